#include "linkwork/constraints/least_singular_value.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/connected_components.hpp"
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
  lambda_.resize(scale_.size());
  none_.setZero(system_->v_size());
  for (VectorXd* velocities : {&x_, &momentum_}) velocities->resize(system_->v_size());
  const ConnectedComponents& components = ConnectedComponents::of(*system_);
  std::vector<int> part(components.count(), -1), rows;
  for (Eigen::Index row = 0; row < scale_.size(); ++row) {
    int& own = part[components.of_row(row)];
    if (own < 0) {
      own = static_cast<int>(rows.size());
      rows.push_back(0);
    }
    rows[own] += 1;
    part_of_row_.push_back(own);
  }
  for (int body = 0; body < system_->body_count(); ++body) part_of_body_.push_back(part[components.of_body(body)]);
  for (VectorXd* each : {&quotients_, &lengths_, &values_}) each->resize(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index k = 0; k < some_.size(); ++k)
    some_[k] *= news / std::sqrt(static_cast<double>(rows[part_of_row_[k]]));
}

// The last u may be without any part of a vector that has become the least one: a little of all is added.
const VectorXd& LeastSingularValue::of(const Solve& solve, const Evaluation& at) {
  if (some_.size() == 0) begin();
  if (u_.size() == 0) u_.setZero(scale_.size());
  u_ += some_;
  iterate(solve, at);
  VectorXd last = VectorXd::Constant(quotients_.size(), INFINITY);
  for (int k = 1; k < most_iterations && (k < least_iterations || falls(last)); ++k) {
    last = quotients_;
    iterate(solve, at);
  }
  const bool finite = u_.allFinite() && !quotients_.hasNaN();
  if (!finite) u_.resize(0);
  values_ = finite ? VectorXd(quotients_.cwiseMax(0.0).cwiseSqrt()) : VectorXd::Zero(quotients_.size());
  return values_;
}

bool LeastSingularValue::falls(const VectorXd& last) const {
  return (quotients_.array() < (1.0 - settled) * last.array()).any();
}

const VectorXd& LeastSingularValue::of(SaddleSolver& saddle, const Evaluation& at) {
  return of([&](const ConstVector& b, MutableVector x, MutableVector lambda) { saddle.solve(none_, b, x, lambda); },
            at);
}

// With S = D M^-1 D^T, scaled by s = diag(S)^1/2 of the start, u <- s S^-1 s u; the quotient u^T s^-1 S s^-1 u =
// lambda^T D x, where lambda = S^-1 s u and x = M^-1 D^T lambda, is not touched by penalties in the factorization.
// What has no equations in common is solved for side by side.
void LeastSingularValue::iterate(const Solve& solve, const Evaluation& at) {
  b_ = scale_.cwiseProduct(u_);
  solve(b_, x_, lambda_);
  u_ = scale_.cwiseProduct(lambda_);
  add_up(u_, u_, part_of_row_, 1, lengths_);
  lengths_ = lengths_.cwiseSqrt();
  for (Eigen::Index k = 0; k < u_.size(); ++k)
    if (const double length = lengths_[part_of_row_[k]]; length != 0.0) u_[k] /= length;
  system_->multiply_mass(at, x_, momentum_);
  add_up(x_, momentum_, part_of_body_, velocity_size, quotients_);
  for (Eigen::Index part = 0; part < quotients_.size(); ++part) {
    const double length = lengths_[part];
    quotients_[part] = length == 0.0 ? INFINITY : quotients_[part] / (length * length);
  }
}

/// Products over the parts, of so many numbers of a row or body each.
void LeastSingularValue::add_up(const VectorXd& a, const VectorXd& b, const std::vector<int>& part, Eigen::Index each,
                                VectorXd& sums) const {
  if (sums.size() == 1) {
    sums[0] = a.dot(b);
    return;
  }
  sums.setZero();
  for (std::size_t k = 0; k < part.size(); ++k) {
    if (part[k] < 0) continue;
    const Eigen::Index first = static_cast<Eigen::Index>(k) * each;
    sums[part[k]] += a.segment(first, each).dot(b.segment(first, each));
  }
}

}  // namespace linkwork
