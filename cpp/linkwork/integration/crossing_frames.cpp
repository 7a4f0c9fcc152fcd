#include <algorithm>
#include <cmath>

#include "linkwork/integration/crossing.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/lagrange.hpp"

/// What is recorded in leaps, and beside singular poses.
namespace linkwork {
namespace {

constexpr double doubtful = 0.1;  // of the usual root: nearer to a pose, small violations make other forces
constexpr double away = 0.03;     // rad between states whose forces tell those in the pose, at most
constexpr int most_states = 6, least_states = 4;
constexpr double unlike = 0.03;  // of the largest multiplier: what those of a smooth motion are told to

VectorXd sum_of(const std::vector<double>& weights, const std::vector<VectorXd>& values) {
  VectorXd sum = VectorXd::Zero(values.front().size());
  for (std::size_t k = 0; k < weights.size(); ++k) sum += weights[k] * values[k];
  return sum;
}

/// Whether the values at other times tell the first one: those that grow without limit between them do not.
bool tell_each_other(std::vector<double> times, std::vector<VectorXd> values) {
  const double first = times.front();
  const VectorXd value = values.front();
  times.erase(times.begin());
  values.erase(values.begin());
  const VectorXd found = sum_of(lagrange_weights(times, first), values);
  return (found - value).cwiseAbs().maxCoeff() <= unlike * value.cwiseAbs().maxCoeff();
}

}  // namespace

void Crossing::interpolate(const System&, double theta, VectorXd& y) const {
  step_.state_at(theta * leap_.followed, y);
}

/// Where the constraints would move a state of the leap more than it is off.
bool Crossing::beside_a_pose(double time) const {
  return std::any_of(leap_.poses.begin(), leap_.poses.end(),
                     [&](double pose) { return std::abs(time - pose) < margin * leap_.h; });
}

void Crossing::place(double theta, VectorXd& y) {
  const double part = theta * leap_.followed;
  step_.state_at(part, y);
  if (beside_a_pose(part)) return;
  const Unwatched unwatched(dynamics_);
  y_ = y;
  try {
    step_.project(leap_.t + part, y_);
  } catch (const Error&) {
    return;
  }
  y = y_;
}

void Crossing::correct_frame(Recorder& recorder, double t, const VectorXd& y) {
  if (!beside_a_pose(0.0) || recorder.last() != t) return;
  VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
  interpolate(0.0, v_dot, lambda);
  dynamics_.evaluate(leap_.t, y);
  recorder.correct_last(y, v_dot, lambda);
}

void Crossing::interpolate(double theta, MutableVector v_dot, MutableVector lambda) const {
  step_.accelerations_at(theta * leap_.followed, v_dot, lambda);
}

bool Crossing::in_doubt() {
  if (!prepared_) return false;
  try {
    dynamics_.factorize();
  } catch (const SingularSystemError&) {
    return true;
  }
  return dynamics_.formulation().root_of_pivot() < doubtful * dynamics_.watch().root_of_level();
}

/// Accelerations and multipliers at `time` in a step, on the constraints, from which it is off by its tolerance: beside
/// a pose that would make other forces. False in a pose.
bool Crossing::tell(const Interpolant& step, double t, double h, double time, VectorXd& v_dot, VectorXd& lambda) {
  step.interpolate(dynamics_.system(), (time - t) / h, y_);
  try {
    step_.project(time, y_);
    dynamics_.evaluate(time, y_);
    dynamics_.refined_accelerations(v_dot, lambda);
  } catch (const SingularSystemError&) {
    return false;
  } catch (const NotConvergedError&) {
    return false;
  }
  return true;
}

/// By the forces some hundredths of a radian before and after it; where the step is not that long, or they grow toward a
/// pose between, by the equations there.
bool Crossing::accelerations_beside(const Interpolant& step, double t, double h, double at, MutableVector v_dot,
                                    MutableVector lambda) {
  if (!in_doubt()) return false;
  VectorXd its_v_dot(v_dot.size()), its_lambda(lambda.size());
  const bool found =
      between_forces_beside(step, t, h, at, its_v_dot, its_lambda) || tell(step, t, h, at, its_v_dot, its_lambda);
  step.interpolate(dynamics_.system(), (at - t) / h, y_);
  dynamics_.evaluate(at, y_);
  if (!found) return false;
  v_dot = its_v_dot;
  lambda = its_lambda;
  return true;
}

/// Whether the state where `dynamics` is factorized is so far from a pose.
bool Crossing::tells_forces() const {
  return dynamics_.formulation().root_of_pivot() >= solvable * dynamics_.watch().root_of_level();
}

/// False where the step has too few states that tell them.
bool Crossing::between_forces_beside(const Interpolant& step, double t, double h, double at, VectorXd& v_dot,
                                     VectorXd& lambda) {
  const System& system = dynamics_.system();
  step.interpolate(system, (at - t) / h, y_);
  const double rate = largest_rate(y_.segment(system.q_size(), system.v_size()));
  if (!(rate > 0.0)) return false;
  const double apart = std::min(away / rate, std::max(at - t, t + h - at) / least_states);
  std::vector<double> times;
  std::vector<VectorXd> accelerations, multipliers;
  VectorXd its_v_dot(v_dot.size()), its_lambda(lambda.size());
  for (int k = 1; k <= most_states; ++k)
    for (const double time : {k * apart, -k * apart}) {
      if (static_cast<int>(times.size()) == most_states || at + time < t || at + time > t + h) continue;
      if (!tell(step, t, h, at + time, its_v_dot, its_lambda) || !tells_forces()) continue;
      times.push_back(time);
      accelerations.push_back(its_v_dot);
      multipliers.push_back(its_lambda);
    }
  if (static_cast<int>(times.size()) < least_states || !tell_each_other(times, multipliers)) return false;
  const std::vector<double> weights = lagrange_weights(times, 0.0);
  v_dot = sum_of(weights, accelerations);
  lambda = sum_of(weights, multipliers);
  return true;
}

}  // namespace linkwork
