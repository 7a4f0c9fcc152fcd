#pragma once

#include <optional>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/kept_step.hpp"

namespace linkwork {

/// Energy that a run made or lost in a connected part whose forces and constraints do no work, where it is a constant
/// of the exact motion.
struct EnergyMade {
  double largest = 0.0;      ///< beyond rounding [J]
  double lasting = 1.0;      ///< its integral over time, relative to that of a drift to the largest; at most 2
  double exchanged = 0.0;    ///< what the potential changes by [J]
  double in_inerters = 0.0;  ///< largest kinetic energy of inerters [J]
  double amount = 0.0;       ///< largest of kinetic energy and potential [J]
  double rest = 0.0;         ///< as little is that of a part at rest [J]
};

/// Of each of ConnectedParts, at the ends of these steps, beside the first; none: there may be work, of a driver, a
/// damper, a contact, a function of time or of the user's own. Nothing is looked at where there is but one part: of that
/// the balance of the whole run tells. `lengths`: sizes [m].
std::vector<std::optional<EnergyMade>> find_energies_made(Dynamics& dynamics, const std::vector<const KeptStep*>& steps,
                                                          const VectorXd& lengths);

/// Of each connected part whether energy may be a constant there: no driver, function of time, law of the user's own,
/// contact or stop acts. Dampers and events are not looked at; where `touching`, not what contacts and stops take either.
std::vector<bool> may_conserve(const System& system, bool touching = false);

/// Kinetic energy of the inerters of each connected part [J], of velocities v at the state that was evaluated.
VectorXd energies_in_inerters(const System& system, const Evaluation& at, const VectorXd& v);

/// By how much the energy of each connected part is larger in a state near the one that was evaluated, y, to the first
/// order, whatever potential the forces have or do not tell [J]: v . M dv - F . dx.
VectorXd energies_apart(const System& system, const Evaluation& at, const VectorXd& y, const VectorXd& other);

/// Of each connected part, of which rounding of the state makes the last digits of these energies [J].
VectorXd scales_of_energies(const System& system, const Evaluation& at, const VectorXd& y);

}  // namespace linkwork
