#pragma once

#include <functional>
#include <vector>

#include "linkwork/integration/linearized_motion.hpp"
#include "linkwork/integration/moving_axes.hpp"
#include "linkwork/integration/state_log.hpp"

namespace linkwork {

/// Largest that the error of a step becomes, of each of ConnectedParts, by the larger of those of poses and of
/// velocities, relative to what of it the joints allow at t, at least a fourth of it.
struct ErrorGrowth {
  double t = 0.0, until = 0.0;  ///< up to where it was followed [s]
  VectorXd of_part;
  bool lost = false;  ///< beyond that nothing is known of it
};

/// The errors of so many steps, or fewer, spread over the run up to a time, in its order.
using ErrorsToFollow = std::function<std::vector<StepDifference>(std::size_t count, double until)>;

/// How the errors of some steps of a run grow on, to the first order: each is carried along by the equations of motion
/// linearized about the states of the log, of which as many are taken as the motion and the error ask for, with
/// interpolation of the fifth degree between; by the classical Runge-Kutta method, with a difference of two evaluations
/// for the derivative. What it misses the equations of the joints by is taken back, as stabilization does. Memories stay
/// as they are.
///
/// Where that fails, as in a singular pose or at a kink of a law, they are lost, and others begin behind it: those before
/// are taken to grow as these, where that is more than in regular motion.
///
/// Of a long run as far as so many evaluations and the log go; what grows much is followed once more in finer steps, as
/// what these leave grows, too. `lengths`, `speeds`: by which poses and velocities of each part count, seen from its
/// axes [m, m/s].
std::vector<ErrorGrowth> find_error_growth(Dynamics& dynamics, const StateLog& log, const ErrorsToFollow& errors,
                                           const MovingAxes& axes, const VectorXd& lengths, const VectorXd& speeds,
                                           std::int64_t most_evaluations);

}  // namespace linkwork
