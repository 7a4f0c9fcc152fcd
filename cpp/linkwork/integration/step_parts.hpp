#pragma once

#include <utility>
#include <vector>

#include "linkwork/integration/break_points.hpp"
#include "linkwork/integration/integrator.hpp"

namespace linkwork {

/// The share of the first of two parts.
constexpr double golden_share = 0.6180339887498949;

/// Where the parts begin and end in which a step is taken again: also at breaks inside it. A break as near to one of
/// their ends as a run with fixed steps takes to be there is there.
class StepParts {
 public:
  /// `breaks`, ascending [s]. `share` of the first of two parts; 1: there is but one.
  StepParts(std::vector<double> breaks, double share) : breaks_(std::move(breaks)), share_(share) {}
  /// Parts are divided so many times, which makes two, four, eight: very long steps are far from what Richardson's
  /// extrapolation asks for.
  void divide(int times) { divisions_ = times; }
  /// The step between the breaks at its ends.
  StepSpan whole(double t, double h) const;
  /// What lies between breaks, on its own side of them, and the share of each.
  std::vector<StepSpan> of(double t, double h) const;

 private:
  void divide(const StepSpan& whole, int times, std::vector<StepSpan>& parts) const;

  BreakPoints breaks_;
  double share_;
  int divisions_ = 1;
};

}  // namespace linkwork
