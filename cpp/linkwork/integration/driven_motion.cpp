#include "linkwork/integration/driven_motion.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/math/error.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

constexpr int first_iterations = 6;  // toward the smallest singular value
constexpr double noise = 0.1;        // so that another one is found when it becomes the smallest
constexpr double inside = 0.618;     // of a step: in step with nothing
constexpr double rounding_of_times = 4.0 * std::numeric_limits<double>::epsilon();

/// q after the small motion x: shifts in inertial axes, rotation vectors in body axes.
VectorXd displaced(const VectorXd& q, const VectorXd& x) {
  VectorXd out(q.size());
  for (Eigen::Index body = 0; body < q.size() / position_size; ++body) {
    const auto from = q.segment<7>(7 * body);
    const auto by = x.segment<6>(6 * body);
    out.segment<3>(7 * body) = from.head<3>() + by.head<3>();
    const Vec4<double> p = from.tail<4>();
    out.segment<4>(7 * body + 3) = quaternion_product<double>(p, exponential(Vec3<double>(by.tail<3>()))).normalized();
  }
  return out;
}

double largest(const VectorXd& x) { return x.size() ? x.cwiseAbs().maxCoeff() : 0.0; }

void append(std::vector<double>& to, const VectorXd& from) { to.insert(to.end(), from.begin(), from.end()); }

}  // namespace

SparsePattern::SparsePattern(const System& system) : begin(system.v_size() + 1, 0) {
  for (const ConstraintBlock& block : system.blocks())
    for (int c = 0; c < velocity_size; ++c) begin[velocity_size * block.body + c + 1] += block.rows;
  for (std::size_t c = 1; c < begin.size(); ++c) begin[c] += begin[c - 1];
  for (std::vector<int>* entries : {&row, &column}) entries->resize(begin.back());
  source.resize(begin.back());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (const ConstraintBlock& block : system.blocks())
    for (int c = 0; c < velocity_size; ++c)
      for (int k = 0; k < block.rows; ++k) {
        const int place = next[velocity_size * block.body + c]++;
        row[place] = block.row + k;
        column[place] = velocity_size * block.body + c;
        source[place] = block.offset + velocity_size * k + c;
      }
}

DrivenMotion::DrivenMotion(Dynamics& dynamics, double length, VectorXd row_lengths, double rounding, double unit,
                           std::vector<double> recorded)
    : dynamics_(dynamics),
      system_(dynamics.system()),
      length_(length),
      rounding_(rounding),
      unit_(unit),
      row_lengths_(std::move(row_lengths)),
      pattern_(system_),
      lu_(system_.row_count(), pattern_.begin, pattern_.row),
      values_(pattern_.row.size()),
      row_scale_(system_.row_count()),
      column_scale_(system_.v_size()),
      turns_(system_),
      recorded_(std::move(recorded)),
      here_(system_.make_evaluation()),
      there_(system_.make_evaluation()),
      right_(system_.v_size()),
      rest_(VectorXd::Zero(system_.v_size())),
      b_(system_.row_count()),
      dx_(system_.v_size()) {
  for (int body = 0; body < system_.body_count(); ++body)
    column_scale_.segment<6>(6 * body) << 1.0, 1.0, 1.0, 1.0 / length, 1.0 / length, 1.0 / length;
}

bool DrivenMotion::begin(double t, const ConstVector& q, const ConstVector& v, const ConstVector& v_dot,
                         const ConstVector& history) {
  now_ = {t, q, v, v_dot, history};
  turns_.pass(t, q, v);
  dynamics_.set_history(history);
  system_.evaluate(t, q, v, history, here_);
  return choose_pivots(here_) && begins_regular();
}

bool DrivenMotion::start(const ConstVector& q, const ConstVector& history) {
  now_ = {0.0, q, rest_, rest_, history};
  dynamics_.set_history(history);
  DrivenState next = now_;
  try {
    evaluate_at_rest(0.0, next.q);
    if (!choose_pivots(there_) || !correct(0.0, next.q, INFINITY)) return false;
    if (!factorize(there_) || !begins_regular()) return false;
  } catch (const Error&) {
    return false;
  }
  complete(next);
  now_ = std::move(next);
  turns_.pass(now_.t, now_.q, now_.v);
  std::swap(here_, there_);
  dynamics_.set_history(now_.history);
  return true;
}

bool DrivenMotion::begins_regular() {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (double& entry : right_) entry = any(random_);
  return regular(first_iterations, left_);
}

DrivenFrames DrivenMotion::follow(const std::vector<double>& times, double seconds) {
  const std::chrono::duration<double> most(seconds);
  ends_ = std::chrono::steady_clock::now() + std::chrono::duration_cast<std::chrono::steady_clock::duration>(most);
  DrivenFrames out;
  steps_ = evaluations_ = factorizations_ = 0;
  for (const double t : times) {
    if (out.count > 0 && time_is_over()) break;
    DrivenState last = now_;
    const TurnCounter::Way way = turns_.way();
    if (try_frame(t, out)) continue;
    if (out.paused) break;
    now_ = std::move(last);
    turns_.go_back(way);
    break;
  }
  out.steps = steps_, out.evaluations = evaluations_, out.factorizations = factorizations_;
  return out;
}

bool DrivenMotion::try_frame(double t, DrivenFrames& out) {
  try {
    return go_to(t, out.paused) && add_frame(out);
  } catch (const Error&) {  // whoever looks closer finds it as well
    return false;
  }
}

// --- steps -------------------------------------------------------------------------------------------------------------

bool DrivenMotion::go_to(double t, bool& paused) {
  double h = t - now_.t;
  const double smallest = limits_.shortest_part * h, soon = std::max(limits_.touch_part * h, rounding_of_times * t);
  while (now_.t < t) {
    if (paused) return false;
    const bool last = now_.t + h >= t - smallest;
    const double to = last ? t : now_.t + h;
    const Step found = step(to, soon);
    if (found == Step::taken) {
      h *= 2.0;
      paused = time_is_over();
      continue;
    }
    if (!factorize(here_)) return false;
    if (found == Step::touches) {
      if (!touch(to, soon)) return false;
      continue;
    }
    h /= 2.0;
    if (h < smallest) return false;
  }
  return true;
}

/// To where a contact begins that has begun at t, by halves.
bool DrivenMotion::touch(double t, double soon) {
  while (now_.t < t) {
    const double to = t - now_.t > soon ? 0.5 * (now_.t + t) : t;
    const Step found = step(to, soon);
    if (found == Step::taken) continue;
    if (found == Step::refused || !factorize(here_)) return false;
    t = to;
  }
  return true;
}

DrivenMotion::Step DrivenMotion::step(double t, double soon) {
  const double h = t - now_.t;
  const VectorXd x = predicted(h);
  const double moved = reach(x);
  const double largest_correction = std::max(limits_.largest_correction * moved, 1e-9);
  if (!(moved <= limits_.longest_step) || !foreseen(h, largest_correction)) return Step::refused;
  DrivenState next{t, displaced(now_.q, x), now_.v + h * now_.v_dot, now_.v_dot, {}};
  const int sign = lu_.sign(), pivots = pivots_;
  if (!correct(t, next.q, largest_correction)) return Step::refused;
  VectorXd left;
  if (!factorize(there_) || !same_side(sign, pivots) || !regular(1, left)) return Step::refused;
  if (left.dot(left_) < 0.0) return Step::refused;  // two singular values at once keep the sign of the determinant
  complete(next);
  if (reach(h * next.v) > limits_.fastest_end) return Step::refused;
  if (h > soon && system_.begins_contact(now_.history, next.history)) return Step::touches;
  left_ = left;
  now_ = std::move(next);
  turns_.pass(now_.t, now_.q, now_.v);
  std::swap(here_, there_);
  dynamics_.set_history(now_.history);
  steps_ += 1;
  return Step::taken;
}

// Whether drivers do within the step what they did at its beginning: a whole turn looks like none at its end.
bool DrivenMotion::foreseen(double h, double largest_correction) {
  const double part = inside * h;
  VectorXd x = predicted(part);
  evaluate_at_rest(now_.t + part, displaced(now_.q, x));
  solve(there_.Phi, x);
  return reach(x) <= largest_correction;
}

// h v + h^2 v_dot / 2
VectorXd DrivenMotion::predicted(double h) const { return h * now_.v + 0.5 * h * h * now_.v_dot; }

// Newton's method with the D of the last pose, renewed where it converges slowly.
bool DrivenMotion::correct(double t, VectorXd& q, double most) {
  double total = 0.0, before = INFINITY;
  VectorXd x(system_.v_size());
  evaluate_at_rest(t, q);
  for (int k = 0; k < limits_.iterations; ++k) {
    solve(there_.Phi, x);
    double size = reach(x);
    total += size;
    if (!(total <= most)) return false;
    if (size > 0.1 * before) {
      if (before < limits_.rounding) return closed();
      if (!factorize(there_)) return false;
      solve(there_.Phi, x);
      size = reach(x);
    }
    q = displaced(q, -x);
    before = size;
    evaluate_at_rest(t, q);
    if (size < limits_.converged) return closed();
  }
  return before < 10.0 * limits_.rounding && closed();
}

void DrivenMotion::evaluate_at_rest(double t, const VectorXd& q) {
  system_.evaluate_constraints(t, q, rest_, now_.history, there_);
  evaluations_ += 1;
}

// Redundant equations as well as the others.
bool DrivenMotion::closed() const {
  return largest(there_.Phi.cwiseQuotient(row_lengths_)) < limits_.closed + rounding_;
}

// D v = -Phi_t, D v_dot = gamma
void DrivenMotion::complete(DrivenState& next) {
  std::swap(here_, there_);  // `reduce` takes the D of here_
  reduce(-here_.Phi_t, next.v);
  system_.evaluate(next.t, next.q, next.v, now_.history, here_);
  evaluations_ += 1;
  reduce(here_.gamma, next.v_dot);
  next.history = here_.history;
  std::swap(here_, there_);
}

// Whether the determinant has kept its sign from here to there, where it is factorized.
bool DrivenMotion::same_side(int sign, int pivots) {
  if (pivots == pivots_) return lu_.sign() == sign;
  const int there = lu_.sign();
  scale(here_);
  const bool same = lu_.refactorize(values_) && lu_.sign() == there;
  scale(there_);
  return same && lu_.refactorize(values_);
}

// --- the constraints ---------------------------------------------------------------------------------------------------

void DrivenMotion::scale(const Evaluation& at) {
  row_scale_.setZero();
  for (std::size_t k = 0; k < values_.size(); ++k) {
    values_[k] = at.D[pattern_.source[k]] * column_scale_[pattern_.column[k]];
    row_scale_[pattern_.row[k]] += values_[k] * values_[k];
  }
  for (double& scale : row_scale_) scale = scale > 0.0 ? 1.0 / std::sqrt(scale) : 1.0;
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] *= row_scale_[pattern_.row[k]];
}

bool DrivenMotion::factorize(const Evaluation& at) {
  scale(at);
  factorizations_ += 1;
  return lu_.refactorize(values_) || choose_pivots(at);
}

bool DrivenMotion::choose_pivots(const Evaluation& at) {
  scale(at);
  pivots_ += 1;
  return lu_.factorize(values_);
}

// The smallest singular value by inverse iteration.
bool DrivenMotion::regular(int iterations, VectorXd& left) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const double part = noise / std::sqrt(static_cast<double>(right_.size()));
  for (double& entry : right_) entry += part * any(random_);
  double sigma = 0.0;
  for (int k = 0; k < iterations; ++k) {
    lu_.solve_transposed(right_.normalized(), b_);
    left = b_.normalized();
    lu_.solve(left, right_);
    sigma = 1.0 / right_.norm();
    right_ *= sigma;
  }
  return sigma > limits_.regular * unit_;
}

// D x = residual
void DrivenMotion::solve(const VectorXd& residual, VectorXd& x) {
  b_ = row_scale_.cwiseProduct(residual);
  lu_.solve(b_, x);
  x.array() *= column_scale_.array();
}

// x becomes the solution of D x = b, refined.
void DrivenMotion::reduce(const VectorXd& b, VectorXd& x) {
  VectorXd residual(b.size());
  for (int k = 0; k < 2; ++k) {
    system_.multiply_D(here_, x, residual);
    residual -= b;
    solve(residual, dx_);
    x -= dx_;
  }
}

// The largest shift in sizes of the mechanism, or angle [rad].
double DrivenMotion::reach(const VectorXd& x) const {
  return (x.array() / column_scale_.array()).abs().maxCoeff() / length_;
}

// --- frames ------------------------------------------------------------------------------------------------------------

void DrivenMotion::record_turns(double t, const ConstVector& q, const ConstVector& v) {
  if (std::binary_search(recorded_.begin(), recorded_.end(), t)) turns_.record(t, q, v);
  else turns_.pass(t, q, v);
}

bool DrivenMotion::add_frame(DrivenFrames& out) {
  VectorXd lambda(system_.row_count()), residual(system_.row_count());
  if (!find_multipliers(lambda)) return false;
  system_.multiply_D(here_, now_.v_dot, residual);
  residual -= here_.gamma;
  record_turns(now_.t, now_.q, now_.v);
  out.count += 1;
  out.t.push_back(now_.t);
  append(out.q, now_.q);
  append(out.v, now_.v);
  append(out.v_dot, now_.v_dot);
  append(out.lambda, lambda);
  append(out.history, now_.history);
  out.potential.push_back(here_.potential);
  out.power.push_back(here_.power - system_.power_of_drivers(here_, lambda));
  for (const double violation : {largest(here_.Phi), largest(here_.Phi_dot), largest(residual)})
    out.violation.push_back(violation);
  return true;
}

// D^T lambda = M v_dot - g. Where redundant rows leave lambda open, that of forward dynamics shares it.
bool DrivenMotion::find_multipliers(VectorXd& lambda) {
  VectorXd force(system_.v_size());
  system_.multiply_mass(here_, now_.v_dot, force);
  force -= here_.g.head(system_.v_size());
  lambda.setZero();
  if (lambda.size() > force.size() && !shared_multipliers(force, lambda)) return false;
  VectorXd left(force.size());
  for (int k = 0; k < 2; ++k) {
    left.setZero();
    system_.add_D_transposed(here_, lambda, left);
    left = (force - left).cwiseProduct(column_scale_);
    lu_.solve_transposed(left, b_);
    lambda += row_scale_.cwiseProduct(b_);
  }
  return true;
}

// False: they are not those of this motion.
bool DrivenMotion::shared_multipliers(const VectorXd& force, VectorXd& lambda) {
  VectorXd y(dynamics_.y_size()), v_dot(force.size()), left = VectorXd::Zero(force.size());
  y << now_.q, now_.v, 0.0;
  dynamics_.evaluate(now_.t, y);
  dynamics_.accelerations(v_dot, lambda);
  evaluations_ += 1;
  system_.add_D_transposed(here_, lambda, left);
  const double all =
      left.cwiseProduct(column_scale_).norm() + here_.g.head(force.size()).cwiseProduct(column_scale_).norm();
  return (force - left).cwiseProduct(column_scale_).norm() <= limits_.balanced * all;
}

}  // namespace linkwork
