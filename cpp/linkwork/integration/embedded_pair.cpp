#include "linkwork/integration/embedded_pair.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/integration/runge_kutta.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double exact = 1e-10;  // coefficients are given to some 15 digits, and grow to some hundreds

void check(const EmbeddedPair& pair) {
  check(pair.method);
  const Eigen::Index s = pair.method.b.size(), extra = pair.extra_c.size(), all = s + 1 + extra;
  const auto refuse = [&](const std::string& why) {
    throw OptionError("tableau", "pair '" + pair.method.name + "': " + why);
  };
  if (pair.error.size() != s + 1 || (pair.second_error.size() != 0 && pair.second_error.size() != s + 1))
    refuse("the weights of the error estimate must be one more than the stages");
  if (std::abs(pair.error.sum()) > exact || std::abs(pair.second_error.sum()) > exact)
    refuse("the weights of the error estimate must add up to 0");
  if (pair.error_order < 1) refuse("the order of the embedded method must be at least 1");
  if (pair.extra_A.rows() != extra || (extra > 0 && pair.extra_A.cols() != all))
    refuse("extra_A must have a row for each number in extra_c and a column for each stage");
  for (Eigen::Index i = 0; i < extra; ++i)
    if (pair.extra_A.row(i).tail(extra - i).cwiseAbs().maxCoeff() > 0.0) refuse("only explicit methods");
  if (pair.interpolant.rows() != all || pair.interpolant.cols() < 1)
    refuse("the interpolant must have a row for each stage");
  VectorXd end = pair.interpolant.rowwise().sum();
  end.head(s) -= pair.method.b;
  if (!(end.cwiseAbs().maxCoeff() <= exact)) refuse("the interpolant must end in the new state");
}

}  // namespace

PairStepper::PairStepper(const EmbeddedPair& pair)
    : pair_(pair), stages_(pair.method.b.size()), extra_A_(pair.extra_A) {
  check(pair);
}

void PairStepper::start(int y_size) {
  k_.resize(y_size, pair_.interpolant.rows());
  for (VectorXd* state : {&y_, &y_new_, &workspace_}) state->resize(y_size);
  weights_.resize(pair_.interpolant.rows());
}

void PairStepper::begin(Dynamics& dynamics, const StepSpan& step) {
  begun_ = supplied_ = false;
  evaluate_first_stage(pair_.method, dynamics, step, k_);
  begun_ = true;
}

// p is made a unit vector before the last stage: the first of the next step is then at the same state, and only its
// correction differs. That changes k_s by O(h^order), along p alone.
bool PairStepper::take(Dynamics& dynamics, const StepSpan& step, const VectorXd& y) {
  const double h = step.h;
  step_ = step;
  h_ = h;
  y_ = y;
  prepared_ = false;
  if (!std::exchange(begun_, false)) evaluate_first_stage(pair_.method, dynamics, step, k_);
  if (!std::exchange(supplied_, false)) evaluate_later_stages(pair_.method, dynamics, step, y, k_, workspace_);
  y_new_ = y;
  add_combination(h, pair_.method.b, k_, y_new_);
  if (!y_new_.allFinite()) return false;
  dynamics.system().normalize(y_new_.head(dynamics.system().q_size()));
  dynamics.evaluate(step.at(1.0), y_new_);
  dynamics.rates(k_.col(stages_));
  return true;
}

BodyMaximum PairStepper::trial(Dynamics& dynamics, const ErrorMeasure& measure, const StepSpan& step,
                               const VectorXd& y) {
  if (!take(dynamics, step, y)) return {std::numeric_limits<double>::infinity(), -1};
  return estimate(measure, y);
}

BodyMaximum PairStepper::estimate(const ErrorMeasure& measure, const VectorXd& y) {
  const auto measured = [&](const VectorXd& weights) {
    workspace_.setZero();
    add_combination(h_, weights, k_, workspace_);
    return measure.of_change(y, y_new_, workspace_);
  };
  BodyMaximum error = measured(pair_.error);
  if (pair_.second_error.size() > 0 && error.value > 0.0) {
    const double ratio = 0.1 * measured(pair_.second_error).value / error.value;
    error.value /= ratio < 1e9 ? std::sqrt(1.0 + ratio * ratio) : ratio;  // hypot asks for a new C library
  }
  return error;
}

VectorXd PairStepper::errors_of_parts(const ErrorMeasure& measure, double error) {
  workspace_.setZero();
  add_combination(h_, pair_.error, k_, workspace_);
  const VectorXd found = measure.of_parts(y_, y_new_, workspace_);
  const double largest = found.size() > 0 ? found.maxCoeff() : 0.0;
  return largest > 0.0 ? VectorXd(error / largest * found) : found;
}

bool PairStepper::prepare_interpolation(Dynamics& dynamics) {
  if (prepared_) return false;
  prepared_ = true;
  for (Eigen::Index i = 0; i < pair_.extra_c.size(); ++i) {
    workspace_ = y_;
    add_combination(h_, extra_A_.row(i).head(stages_ + 1 + i).transpose(), k_, workspace_);
    dynamics.evaluate(step_.at(pair_.extra_c[i]), workspace_);
    dynamics.rates(k_.col(stages_ + 1 + i));
  }
  return pair_.extra_c.size() > 0;
}

void PairStepper::interpolate(const System& system, double theta, VectorXd& y) const {
  weights_.setZero();
  for (Eigen::Index power = pair_.interpolant.cols() - 1; power >= 0; --power)
    weights_ = theta * (weights_ + pair_.interpolant.col(power));
  y = y_;
  add_combination(h_, weights_, k_, y);
  system.normalize(y.head(system.q_size()));
}

}  // namespace linkwork
