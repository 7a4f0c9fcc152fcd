#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// A time in which a level of the constraints was violated by more than its limit.
struct Excess {
  int level = 0;         ///< 0, 1, 2: Phi, Phi_dot, D v_dot - gamma
  double t = 0.0;        ///< when it began [s]
  double largest = 0.0;  ///< [m or 1, with 1/s or 1/s^2]
  int row = 0;           ///< of the largest
};

/// Compares the violation at the ends of steps with the limits of the run, see Options.
class ViolationMonitor {
 public:
  explicit ViolationMonitor(Dynamics& dynamics);

  /// Looks at the state where `dynamics` is evaluated; true where position or velocity is beyond its limit now.
  bool exceeded(double t);

  const std::vector<Excess>& excesses() const { return excesses_; }  ///< the first ones and the last
  std::int64_t count() const { return count_; }                      ///< of all

 private:
  void look(int level, double t, const VectorXd& violation);

  Dynamics& dynamics_;
  std::array<double, 3> limits_;
  bool limited_;
  std::array<bool, 3> open_{};
  std::array<std::size_t, 3> place_{};
  std::vector<Excess> excesses_;
  std::int64_t count_ = 0;
  VectorXd v_dot_, lambda_, residual_;
};

}  // namespace linkwork
