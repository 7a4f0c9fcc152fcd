#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// The states inside of a step.
class Interpolant {
 public:
  virtual ~Interpolant() = default;
  /// y at t + theta h, with unit Euler parameters; 0 <= theta <= 1.
  virtual void interpolate(const System& system, double theta, VectorXd& y) const = 0;
};

}  // namespace linkwork
