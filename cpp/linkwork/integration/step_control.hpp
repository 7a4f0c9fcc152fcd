#pragma once

#include <algorithm>
#include <cmath>

#include "linkwork/math/archive.hpp"
#include "linkwork/math/elementary.hpp"

namespace linkwork {

/// Proportional-integral control of the step, Gustafsson (1991), ACM Trans. Math. Softw. 17, 533-554: with k the order
/// of the error estimate and e the estimate in units of the tolerances,
///   h' = 0.9 h e^(-0.7/k) e_last^(0.4/k)  after an accepted step,   h' = 0.9 h e^(-1/k)  after a rejected one.
class StepController {
 public:
  explicit StepController(int estimate_order) : k_(estimate_order) {}

  double after_accepted(double h, double error) {
    const double factor = error > 0.0
                              ? safety * elementary::power(error, -0.7 / k_) * elementary::power(last_error_, 0.4 / k_)
                              : INFINITY;
    last_error_ = std::max(error, least_error);
    const double most = rejected_ ? 1.0 : 5.0;
    rejected_ = false;
    return h * std::clamp(factor, 0.2, most);
  }

  /// The error may be infinite or undefined.
  double after_rejected(double h, double error) {
    rejected_ = true;
    const double factor = std::isfinite(error) ? safety * elementary::power(error, -1.0 / k_) : 0.0;
    return h * std::clamp(factor, 0.1, 0.9);
  }

  /// Forgets the steps so far.
  void restart() { *this = StepController(static_cast<int>(k_)); }

  void keep(Archive& archive) { archive(last_error_, rejected_); }

 private:
  static constexpr double safety = 0.9, least_error = 1e-4;

  double k_, last_error_ = 1.0;
  bool rejected_ = false;
};

}  // namespace linkwork
