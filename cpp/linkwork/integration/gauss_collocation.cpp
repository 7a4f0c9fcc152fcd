#include "linkwork/integration/gauss_collocation.hpp"

#include <cmath>
#include <numbers>

#include "linkwork/math/elementary.hpp"

namespace linkwork {
namespace {

constexpr int stages = GaussCollocation::stages;
using Legendre = Eigen::Matrix<double, stages + 1, 1>;  // P_0 .. P_stages

Legendre legendre(double x) {
  Legendre P;
  P[0] = 1.0;
  P[1] = x;
  for (int k = 1; k < stages; ++k) P[k + 1] = ((2 * k + 1) * x * P[k] - k * P[k - 1]) / (k + 1);
  return P;
}

double derivative_of_last(double x, const Legendre& P) {
  return stages * (x * P[stages] - P[stages - 1]) / (x * x - 1.0);
}

/// The k-th root of P_stages, ascending.
double root(int k) {
  double x = -elementary::cosine(std::numbers::pi * (k + 0.75) / (stages + 0.5));
  for (int iteration = 0; iteration < 10; ++iteration) {
    const Legendre P = legendre(x);
    x -= P[stages] / derivative_of_last(x, P);
  }
  return x;
}

}  // namespace

// With the weights w of Gauss quadrature, which is exact for the products here, l_i = w_i sum_k (2k + 1) P_k(x_i) P_k.
GaussCollocation::GaussCollocation() {
  for (int i = 0; i < stages; ++i) {
    const double x = root(i);
    const Legendre P = legendre(x);
    const double slope = derivative_of_last(x, P), weight = 1.0 / ((1.0 - x * x) * slope * slope);
    c[i] = 0.5 + 0.5 * x;
    for (int k = 0; k < stages; ++k) coefficients_(i, k) = weight * (2 * k + 1) * P[k];
  }
  for (int i = 0; i < stages; ++i) A.row(i) = integrals(c[i]).transpose();
}

GaussCollocation::Weights GaussCollocation::values(double theta) const {
  return coefficients_ * legendre(2.0 * theta - 1.0).head<stages>();
}

GaussCollocation::Weights GaussCollocation::from_others(int i) const {
  Weights out = Weights::Ones();
  out[i] = 0.0;
  for (int j = 0; j < stages; ++j)
    for (int m = 0; m < stages; ++m)
      if (m != i && m != j) out[j] *= (c[i] - c[m]) / (c[j] - c[m]);
  return out;
}

GaussCollocation::Weights GaussCollocation::integrals(double theta) const {
  const Legendre P = legendre(2.0 * theta - 1.0);
  Weights of_legendre;
  of_legendre[0] = theta;
  for (int k = 1; k < stages; ++k) of_legendre[k] = 0.5 * (P[k + 1] - P[k - 1]) / (2 * k + 1);
  return coefficients_ * of_legendre;
}

}  // namespace linkwork
