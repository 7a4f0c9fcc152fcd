#include "linkwork/integration/gauss_collocation.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

using namespace linkwork;

TEST_CASE("s weights integrate polynomials up to degree 2 s - 1 exactly, and not those of degree 2 s") {
  const GaussCollocation gauss;
  for (int degree = 0; degree <= 2 * GaussCollocation::stages; ++degree) {
    const double error = gauss.integrals(1.0).dot(gauss.c.array().pow(degree).matrix()) - 1.0 / (degree + 1);
    if (degree < 2 * GaussCollocation::stages) CHECK(std::abs(error) < 1e-13);
    else CHECK(std::abs(error) > 1e-10);
  }
}

TEST_CASE("row i of A integrates polynomials up to degree s - 1 from 0 to node i") {
  const GaussCollocation gauss;
  for (int degree = 0; degree < GaussCollocation::stages; ++degree) {
    const GaussCollocation::Weights found = gauss.A * gauss.c.array().pow(degree).matrix();
    const GaussCollocation::Weights expected = gauss.c.array().pow(degree + 1).matrix() / (degree + 1);
    CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-12);
  }
}

TEST_CASE("the polynomials l_i are 1 at their node and 0 at the others, and their integrals have them as derivatives") {
  const GaussCollocation gauss;
  for (int node = 0; node < GaussCollocation::stages; ++node) {
    const GaussCollocation::Weights expected = GaussCollocation::Weights::Unit(node);
    CHECK((gauss.values(gauss.c[node]) - expected).cwiseAbs().maxCoeff() < 1e-12);
  }
  const double theta = 0.37, h = 1e-3;
  const auto at = [&](double s) { return gauss.integrals(theta + s); };
  const GaussCollocation::Weights slope = (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
  CHECK((slope - gauss.values(theta)).cwiseAbs().maxCoeff() < 1e-7);
}

TEST_CASE("a step on y' = lambda y is the diagonal Pade approximation: it keeps |y| where lambda is imaginary") {
  const GaussCollocation gauss;
  constexpr int s = GaussCollocation::stages;
  const std::complex<double> lambda(0.0, 4.0);
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(s, s) - lambda * gauss.A.cast<std::complex<double>>();
  const Eigen::VectorXcd k = system.lu().solve(Eigen::VectorXcd::Constant(s, lambda));
  const std::complex<double> y = 1.0 + gauss.integrals(1.0).cast<std::complex<double>>().dot(k);
  CHECK(std::abs(std::abs(y) - 1.0) < 1e-12);
  const double factorials = std::exp(2.0 * std::lgamma(s + 1) - std::lgamma(2 * s + 1) - std::lgamma(2 * s + 2));
  const double leading =
      factorials * std::pow(std::abs(lambda), 2 * s + 1);  // (s!)^2 / ((2 s)! (2 s + 1)!) |lambda|^..
  CHECK(std::abs(y - std::exp(lambda)) < 1.2 * leading);
  CHECK(std::abs(y - std::exp(lambda)) > 0.5 * leading);
}

TEST_CASE("values at the other nodes lead to a node that is left out, for polynomials up to degree s - 2") {
  const GaussCollocation gauss;
  for (int left_out = 0; left_out < GaussCollocation::stages; ++left_out) {
    const GaussCollocation::Weights weights = gauss.from_others(left_out);
    CHECK(weights[left_out] == 0.0);
    for (int degree = 0; degree < GaussCollocation::stages; ++degree) {
      const GaussCollocation::Weights values = gauss.c.array().pow(degree);
      const double error = std::abs(weights.dot(values) - values[left_out]);
      if (degree < GaussCollocation::stages - 1) CHECK(error < 1e-13);
      else CHECK(error > 1e-7);
    }
  }
}
