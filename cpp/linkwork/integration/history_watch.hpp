#pragma once

#include <optional>
#include <vector>

#include "linkwork/integration/embedded_pair.hpp"

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
  };
  /// The first of the step from t to t + h; `stepper` can interpolate.
  std::optional<Switch> first(const PairStepper& stepper, double t, double h);

 private:
  double value(const PairStepper& stepper, int which, double t, double h, double theta);

  const Dynamics& dynamics_;
  double least_;
  Evaluation at_;
  VectorXd state_;
};

}  // namespace linkwork
