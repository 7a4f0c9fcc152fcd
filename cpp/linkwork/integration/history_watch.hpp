#pragma once

#include <optional>
#include <vector>

#include "linkwork/integration/touch_search.hpp"

namespace linkwork {

/// Sees to it that full turns can be counted: of an angle that is known up to full turns only the nearest to the last
/// one is meant, so no step may turn it by half a turn.
class TurnGuard {
 public:
  explicit TurnGuard(const Dynamics& dynamics);

  /// The state where `dynamics` is evaluated is accepted.
  void accept();
  /// What a step of size h [s] from there to where `dynamics` is evaluated has turned an angle by, at most [rad]: as
  /// continued, and by its rates at both ends.
  double largest(double h);
  static bool too_far(double angle) { return !(angle < limit); }
  /// StepSizeError about the last call of `largest`.
  [[noreturn]] void refuse(double h, double angle) const;

  void keep(Archive& archive) { archive(rates_, fastest_); }

 private:
  static constexpr double limit = 2.5;  ///< [rad]

  const Dynamics& dynamics_;
  std::vector<int> angles_;
  VectorXd rates_;
  int fastest_ = -1;
};

/// Finds where in a step contacts and stops begin or end. Their forces are not smooth there, and that of a contact
/// depends on the speed at which it began.
class SwitchWatch {
 public:
  /// Values up to `least` in size are as good as zero [m or rad].
  SwitchWatch(const Dynamics& dynamics, double least);
  double least() const { return least_; }

  struct Switch {
    int which;
    double theta;   ///< place in the step, 0 to 1
    bool positive;  ///< its side from there on
    double until;   ///< up to here, at least
  };
  /// The first of the step from t to t + h; `touches`: places, ascending, at which one may be
  /// on another side, beside those that are looked at anyway.
  std::optional<Switch> first(const Interpolant& step, double t, double h,
                              const std::vector<TouchSearch::Touch>& touches);

 private:
  double value(const Interpolant& step, int which, double t, double h, double theta);
  double last_place_of(const Switch& found, std::size_t place, const Interpolant& step, double t, double h);

  const Dynamics& dynamics_;
  double least_;
  Evaluation at_;
  VectorXd state_;
  std::vector<double> places_;
};

}  // namespace linkwork
