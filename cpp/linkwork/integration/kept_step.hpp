#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// A step as a run took it, from y at t to y_new at t + h; y = (q, v, work).
struct KeptStep {
  double t = 0.0, h = 0.0;
  double correction_length = 0.0;  ///< see Dynamics::correct_over
  /// How much the accelerations differ from those of the step before [m/s^2]; of steps that follow tolerances what the
  /// method estimates their errors to be, in units of these; see StepSampling.
  double change = -1.0;
  VectorXd changes;   ///< the same of each of ConnectedParts
  double made = 0.0;  ///< energy, beyond rounding [J]
  VectorXd y, y_new;
  VectorXd history;           ///< variables of the elements, at t
  VectorXd history_new;       ///< at t + h, of a step in which contacts begin; else empty
  bool switched = false;      ///< see StepGroups
  std::vector<int> left_out;  ///< redundant rows, at t

  bool kept() const { return h > 0.0; }
};

/// Some steps of a run, one after the other, and the two of them that are kept: one that nothing chose,
/// and the one with the most change.
/// `Step`: those steps, or where they are.
template <class Step>
struct PartOfRun {
  std::int64_t steps = 0;
  double t = 0.0, seconds = 0.0;
  VectorXd sums_of_changes;  ///< of each of ConnectedParts
  VectorXd peaks;            ///< largest acceleration of a body, of each of them [m/s^2]
  VectorXd velocity_paths;   ///< of each of them: sum of the largest acceleration of a body times the step [m/s]
  Step any{}, steepest{};
  double work = -std::numeric_limits<double>::infinity();  ///< largest that forces and drivers have done [J]
};
using RunPart = PartOfRun<KeptStep>;

}  // namespace linkwork
