#include "linkwork/integration/gauss_collocation.hpp"

#include <Eigen/LU>

namespace linkwork {
namespace {

constexpr double leading_of_legendre = 252.0;  // coefficient of x^5 in P_5(2 x - 1)

}  // namespace

GaussCollocation::GaussCollocation() {
  constexpr double roots[] = {0.932469514203152027812301554494, 0.661209386466264513661399595020,
                              0.238619186083196908630501721681};
  for (int k = 0; k < 3; ++k) {
    c[k] = 0.5 - 0.5 * roots[k];
    c[stages - 1 - k] = 0.5 + 0.5 * roots[k];
  }
  // sum_k powers_ik c_j^k = 1 for i = j, else 0
  using Matrix = Eigen::Matrix<long double, stages, stages>;
  Matrix vandermonde;
  for (int j = 0; j < stages; ++j) {
    long double power = 1.0L;
    for (int k = 0; k < stages; ++k, power *= c[j]) vandermonde(j, k) = power;
  }
  powers_ = Matrix(vandermonde.inverse().transpose()).cast<double>();
  for (int i = 0; i < stages; ++i) A.row(i) = integrals(c[i]).transpose();
  b = integrals(1.0);
}

GaussCollocation::Weights GaussCollocation::values(double theta) const {
  Weights out = powers_.col(stages - 1);
  for (int k = stages - 2; k >= 0; --k) out = theta * out + powers_.col(k);
  return out;
}

GaussCollocation::Weights GaussCollocation::integrals(double theta) const {
  Weights out = powers_.col(stages - 1) / stages;
  for (int k = stages - 2; k >= 0; --k) out = theta * out + powers_.col(k) / (k + 1);
  return theta * out;
}

GaussCollocation::Weights GaussCollocation::last_coefficient() const {
  return powers_.col(stages - 1) / leading_of_legendre;
}

}  // namespace linkwork
