#pragma once

#include "linkwork/integration/interpolant.hpp"

namespace linkwork {

/// A step by what is known at its ends: positions by Hermite's cubics, with q_dot = N(q) v, and the rest linearly. No stage
/// that was somewhere else spoils it.
class HermiteStep final : public Interpolant {
 public:
  /// From y to y_new, to which it refers, in h [s].
  HermiteStep(const System& system, const VectorXd& y, const VectorXd& y_new, double h);
  void interpolate(const System& system, double theta, VectorXd& y) const override;

 private:
  const VectorXd &y_, &y_new_;
  double h_;
  VectorXd rates_, rates_new_;
};

}  // namespace linkwork
