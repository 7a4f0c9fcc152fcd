#include "linkwork/integration/gauss_collocation.hpp"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>

using namespace linkwork;

TEST_CASE("the weights integrate polynomials up to degree 11 exactly, and not those of degree 12") {
  const GaussCollocation gauss;
  for (int degree = 0; degree <= 12; ++degree) {
    const double sum = gauss.b.dot(gauss.c.array().pow(degree).matrix());
    if (degree < 12) CHECK(std::abs(sum - 1.0 / (degree + 1)) < 1e-14);
    else CHECK(std::abs(sum - 1.0 / 13.0) > 1e-9);
  }
}

TEST_CASE("row i of A integrates polynomials up to degree 5 from 0 to node i") {
  const GaussCollocation gauss;
  for (int degree = 0; degree < GaussCollocation::stages; ++degree) {
    const GaussCollocation::Weights found = gauss.A * gauss.c.array().pow(degree).matrix();
    const GaussCollocation::Weights expected = gauss.c.array().pow(degree + 1).matrix() / (degree + 1);
    CHECK((found - expected).cwiseAbs().maxCoeff() < 1e-13);
  }
}

TEST_CASE("the polynomials l_i are 1 at their node and 0 at the others, and their integrals have them as derivatives") {
  const GaussCollocation gauss;
  for (int node = 0; node < GaussCollocation::stages; ++node) {
    const GaussCollocation::Weights expected = GaussCollocation::Weights::Unit(node);
    CHECK((gauss.values(gauss.c[node]) - expected).cwiseAbs().maxCoeff() < 1e-13);
  }
  const double theta = 0.37, h = 1e-3;
  const auto at = [&](double s) { return gauss.integrals(theta + s); };
  const GaussCollocation::Weights slope = (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
  CHECK((slope - gauss.values(theta)).cwiseAbs().maxCoeff() < 1e-8);
}

TEST_CASE("a step on y' = lambda y is the diagonal Pade approximation: it keeps |y| where lambda is imaginary") {
  const GaussCollocation gauss;
  const std::complex<double> lambda(0.0, 2.0);
  const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(6, 6) - lambda * gauss.A.cast<std::complex<double>>();
  const Eigen::VectorXcd k = system.lu().solve(Eigen::VectorXcd::Constant(6, lambda));
  const std::complex<double> y = 1.0 + gauss.b.cast<std::complex<double>>().dot(k);
  CHECK(std::abs(std::abs(y) - 1.0) < 1e-13);
  CHECK(std::abs(y - std::exp(lambda)) < 1.5e-9);  // (6!)^2 / (12! 13!) |lambda|^13 = 1.42e-9 is its leading term
}
