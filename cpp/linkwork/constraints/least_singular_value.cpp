#include "linkwork/constraints/least_singular_value.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/math/elementary.hpp"

namespace linkwork {
namespace {

constexpr int least_iterations = 2, most_iterations = 40;
constexpr double settled = 0.01;  // relative change of the square: more would seem a fall from one look to the next
constexpr double news = 1.0;      // a vector in any direction, to one that was the least

}  // namespace

LeastSingularValue::LeastSingularValue(const System& system, const VectorXd& delassus, const DroppedRows& dropped)
    : system_(&system), scale_(delassus.cwiseSqrt()) {
  dropped.take_from(scale_);
}

/// Where it is asked for at all, which it is near singular poses.
void LeastSingularValue::begin() {
  some_.resize(scale_.size());
  for (Eigen::Index k = 0; k < some_.size(); ++k) some_[k] = elementary::cosine(1.0 + 2.4 * static_cast<double>(k));
  some_ *= news / std::sqrt(static_cast<double>(some_.size()));
  lambda_.resize(scale_.size());
  none_.setZero(system_->v_size());
  for (VectorXd* velocities : {&x_, &momentum_}) velocities->resize(system_->v_size());
}

// The last u may be without any part of a vector that has become the least one: a little of all is added.
double LeastSingularValue::of(const Solve& solve, const Evaluation& at) {
  if (some_.size() == 0) begin();
  if (u_.size() == 0) u_.setZero(scale_.size());
  u_ += some_;
  double quotient = iterate(solve, at), last = INFINITY;
  for (int k = 1; k < most_iterations && (k < least_iterations || quotient < (1.0 - settled) * last); ++k) {
    last = quotient;
    quotient = iterate(solve, at);
  }
  if (u_.allFinite() && std::isfinite(quotient)) return std::sqrt(std::max(quotient, 0.0));
  u_.resize(0);
  return 0.0;
}

double LeastSingularValue::of(SaddleSolver& saddle, const Evaluation& at) {
  return of([&](const ConstVector& b, MutableVector x, MutableVector lambda) { saddle.solve(none_, b, x, lambda); },
            at);
}

// With S = D M^-1 D^T, scaled by s = diag(S)^1/2 of the start, u <- s S^-1 s u; the quotient u^T s^-1 S s^-1 u =
// lambda^T D x, where lambda = S^-1 s u and x = M^-1 D^T lambda, is not touched by penalties in the factorization.
double LeastSingularValue::iterate(const Solve& solve, const Evaluation& at) {
  b_ = scale_.cwiseProduct(u_);
  solve(b_, x_, lambda_);
  u_ = scale_.cwiseProduct(lambda_);
  const double length = u_.norm();
  u_ /= length;
  system_->multiply_mass(at, x_, momentum_);
  return x_.dot(momentum_) / (length * length);
}

}  // namespace linkwork
