#pragma once

#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// Where the time of right-hand sides goes [s]. Each is measured on its own: `whole` may be less than the sum, because
/// a solver may carry the right-hand side through its factorization.
struct RightHandSideTimes {
  double evaluate = 0.0;   ///< D, Phi, Phi_dot, gamma and g from the state
  double assemble = 0.0;   ///< the matrix; zero where the factorization does it on its way
  double factorize = 0.0;  ///< without the assembly
  double solve = 0.0;      ///< v_dot and lambda by factors that are there
  double reactions = 0.0;  ///< forces and torques of the joints from lambda
  double whole = 0.0;      ///< all of it
};

/// The times of `repeats` right-hand sides at (t, y), together.
RightHandSideTimes time_right_hand_sides(Dynamics& dynamics, double t, const VectorXd& y, int repeats);

/// So many right-hand sides, for others to time.
void repeat_right_hand_side(Dynamics& dynamics, double t, const VectorXd& y, int repeats);

/// The least time of a right-hand side at (t, y) [s], of two or more in so many seconds, on which a run is about to set
/// out from there: nothing of it is remembered but its cost.
double least_time_ahead(Dynamics& dynamics, double t, const VectorXd& y, double seconds);

/// The time of so many looks at the redundant rows, as a run takes one at the end of each step [s].
double time_redundancy_watch(Dynamics& dynamics, double t, const VectorXd& y, int repeats);

/// The time of one symbolic analysis, by a solver like that of `dynamics` [s].
double time_analysis(const Dynamics& dynamics);

}  // namespace linkwork
