#pragma once

#include <optional>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/state_interpolation.hpp"

namespace linkwork {

/// The error of a step of a run, which ended at t in one of two states.
struct StepDifference {
  double t = 0.0;
  VectorXd run, exact;  ///< y = (q, v, ...)
};

/// An error of a state, in space: of each body dr, dphi, dv, and d omega in body axes.
struct Perturbation {
  VectorXd way, velocity;  ///< (6n,) each
  VectorXd acceleration;   ///< what it makes of v_dot
  VectorXd first;          ///< of each part: size of what the joints allow at the beginning, at least a fourth of all
  VectorXd energy;         ///< at the beginning, of each part [J]
  double rate = 0.0;       ///< [1/s]
};

/// The equations of motion linearized about a state, by differences of two evaluations. What errors miss the equations
/// of the joints by is taken back, as stabilization does. Memories stay as they are.
class LinearizedMotion {
 public:
  /// `lengths`, `speeds`: by which poses and velocities of each of ConnectedParts count [m, m/s].
  LinearizedMotion(Dynamics& dynamics, const VectorXd& lengths, const VectorXd& speeds);

  /// Evaluations in all; what follows is false once there have been more.
  void afford(std::int64_t evaluations) { most_ = evaluations; }
  bool affords_more() const { return evaluations_ < most_; }

  /// To another state, with its accelerations; false also where there are none.
  bool go_to(double t, const VectorXd& y, const VectorXd& history);
  const MovingState& here() const { return here_.state; }

  /// A state to which it came, to go back there without evaluating it again.
  struct Place {
    MovingState state;
    VectorXd violations, rates;  ///< of the rows
    VectorXd forces;
    VectorXd switches;
    std::vector<bool> sides;  ///< of switches, on which derivatives are those that are asked for: which are positive
  };
  const Place& place() const { return here_; }
  void go_back_to(const Place& place) { here_ = place; }

  /// From here on derivatives are those on the side of each switch where that state is; whether any is another one: where
  /// contacts and stops begin and end they are others on both sides.
  bool take_sides_of(const Place& place);

  /// Of a step, as if it were one of the state where this is; none where it is none, or nothing is known of it.
  std::optional<Perturbation> error(const StepDifference& step);
  bool find_acceleration(Perturbation& it);
  /// After a step, to the equations of the joints and the energy; after its acceleration was found.
  void take_back(Perturbation& it);

  /// Of each part: the largest of poses and of velocities.
  VectorXd size(const VectorXd& way, const VectorXd& velocity) const;
  VectorXd size(const Perturbation& it) const { return size(it.way, it.velocity); }
  static bool is_some(const VectorXd& size);
  /// What rotates, from axes of bodies to those of space.
  void turn(VectorXd& twist) const;

 private:
  bool accelerate(const VectorXd& y, VectorXd& v_dot);
  bool on_its_side(const VectorXd& switches) const;
  VectorXd moved(const VectorXd& way, const VectorXd& velocity, double by) const;
  VectorXd allowed(const VectorXd& twist, const VectorXd& b);
  void take_violations_back(Perturbation& it);
  void go_back_to_constraints(Perturbation& it);
  VectorXd energies(const Perturbation& it) const;
  double energy(int body, const VectorXd& way, const VectorXd& velocity) const;
  void go_back_to_energies(Perturbation& it);
  double weighed(const VectorXd& x) const;

  Dynamics& dynamics_;
  const System& system_;
  const ConnectedParts& connected_;
  const VectorXd &lengths_, &speeds_;
  bool conservative_, holonomic_;
  Place here_;
  VectorXd other_v_dot_, lambda_;
  double by_ = 0.0;       ///< share of an error by which the state was moved to see what it does
  VectorXd most_change_;  ///< of each part: twice the largest kinetic energy [J]
  std::int64_t evaluations_ = 0, most_ = 0;
};

}  // namespace linkwork
