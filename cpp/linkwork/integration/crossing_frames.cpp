#include <algorithm>
#include <cmath>

#include "linkwork/integration/crossing.hpp"
#include "linkwork/integration/growing_multipliers.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/lagrange.hpp"

/// What is recorded in leaps, and beside singular poses.
namespace linkwork {
namespace {

constexpr double doubtful = 0.1;         // of the usual root: nearer to a pose, small violations make other forces
constexpr double doubtful_at_end = 0.3;  // the same of those that a last step leaves, however long it is
constexpr double away = 0.03;            // rad between states whose forces tell those in the pose, at most
constexpr std::size_t most_states = 6, least_states = 4;
constexpr double same_time = 1e-9;     // relative to a leap
constexpr double unlike = 0.03;        // of the largest multiplier: to what the others tell it at least, to be sure
constexpr double nearest_pole = 1e-6;  // of the time between states: nearer to a pose a side of it is chance

/// A state beside the pose: its time, counted from that of the frame, and the least singular value there.
struct StateBeside {
  double time, least;
  VectorXd v_dot, lambda;
};

/// The time of a pose between states or beside them. Their least singular values go linearly
/// to zero and up again: negative before the pose they are smooth, so the smoothest tell how many are before it.
double time_of_pose(std::vector<StateBeside> states) {
  std::sort(states.begin(), states.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  std::vector<double> times, values;
  for (const StateBeside& it : states) {
    times.push_back(it.time);
    values.push_back(it.least);
  }
  double pose = NAN, smoothest = INFINITY;
  for (std::size_t before = 0; before <= times.size(); ++before) {
    if (before > 0) values[before - 1] *= -1.0;
    const double difference = std::abs(divided_difference(times, values));
    if (!(difference < smoothest)) continue;
    smoothest = difference;
    pose = 0.0;
    const std::vector<double> weights = lagrange_weights(values, 0.0);
    for (std::size_t k = 0; k < times.size(); ++k) pose += weights[k] * times[k];
  }
  return pose;
}

/// The same by as many of those with the smallest values as agree best with one less.
double pose_between(std::vector<StateBeside> states) {
  std::sort(states.begin(), states.end(), [](const auto& a, const auto& b) { return a.least < b.least; });
  double pose = NAN, least = INFINITY, before = NAN;
  for (std::size_t count = 3; count <= states.size(); ++count) {
    const double next = time_of_pose({states.begin(), states.begin() + static_cast<std::ptrdiff_t>(count)});
    if (const double change = std::abs(next - before); change < least) {
      least = change;
      pose = next;
    }
    before = next;
  }
  return pose;
}

/// Whether the others tell the first one.
bool tell_each_other(std::vector<double> times, std::vector<VectorXd> values) {
  const double time = times.front();
  const VectorXd value = values.front();
  times.erase(times.begin());
  values.erase(values.begin());
  return (interpolated(times, values, time) - value).cwiseAbs().maxCoeff() <= unlike * value.cwiseAbs().maxCoeff();
}

/// At the time 0; false where multipliers are not sure.
bool interpolate_states(std::vector<StateBeside> states, double apart, VectorXd& v_dot, VectorXd& lambda) {
  const double pose = pose_between(states);
  const auto nearer = [&](const auto& a, const auto& b) { return std::abs(a.time - pose) < std::abs(b.time - pose); };
  if (std::isfinite(pose)) std::sort(states.begin(), states.end(), nearer);
  std::vector<double> times;
  std::vector<VectorXd> accelerations, multipliers;
  for (StateBeside& it : states) {
    times.push_back(it.time);
    accelerations.push_back(std::move(it.v_dot));
    multipliers.push_back(std::move(it.lambda));
  }
  v_dot = interpolated(times, accelerations, 0.0);
  const auto grown = growing_multipliers(times, multipliers, {pose}, nearest_pole * apart, 0.0);
  lambda = grown.value_or(interpolated(times, multipliers, 0.0));
  return grown.has_value() || multipliers.front().size() == 0 || tell_each_other(times, multipliers);
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

/// The last step before a leap may have been longer than the way from there to the pose: by what it is off forces would
/// be others.
void Crossing::correct_frame(Recorder& recorder, double t, const VectorXd& y) {
  if (recorder.last() != t) return;
  if (const auto& start = step_.start_on_constraints()) {
    dynamics_.evaluate(leap_.t, leap_.y);
    return recorder.correct_last(leap_.y, start->v_dot, start->lambda);
  }
  if (starting_ && !beside_a_pose(0.0)) return;
  VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
  interpolate(0.0, v_dot, lambda);
  dynamics_.evaluate(leap_.t, y);
  recorder.correct_last(y, v_dot, lambda);
}

bool Crossing::correct_last_frame(Recorder& recorder, double t, const VectorXd& y) {
  const bool in_leap = t >= leap_.t && t <= (1.0 + same_time) * leap_.followed + leap_.t;
  if (!prepared_ || in_leap || recorder.last() != t) return false;
  const Unwatched unwatched(dynamics_);
  dynamics_.evaluate(t, y);
  VectorXd v_dot(dynamics_.system().v_size()), lambda(dynamics_.system().row_count());
  y_ = y;
  if (near_pose(doubtful_at_end) && tell_on_constraints(t, v_dot, lambda)) recorder.correct_last(y_, v_dot, lambda);
  return true;
}

void Crossing::interpolate(double theta, MutableVector v_dot, MutableVector lambda) const {
  step_.accelerations_at(theta * leap_.followed, v_dot, lambda);
}

/// Whether the pivots where `dynamics` is evaluated are below such a part of the usual root: a pose is near.
bool Crossing::near_pose(double part) {
  if (!prepared_) return false;
  try {
    dynamics_.factorize();
  } catch (const SingularSystemError&) {
    return true;
  }
  return dynamics_.formulation().root_of_pivot() < part * dynamics_.watch().root_of_level();
}

/// Accelerations and multipliers at `time` in a step, on the constraints, from which it is off by its tolerance: beside
/// a pose that would make other forces. False in a pose.
bool Crossing::tell(const Interpolant& step, double t, double h, double time, VectorXd& v_dot, VectorXd& lambda) {
  step.interpolate(dynamics_.system(), (time - t) / h, y_);
  return tell_on_constraints(time, v_dot, lambda);
}

/// At the state y_, which is taken there.
bool Crossing::tell_on_constraints(double time, VectorXd& v_dot, VectorXd& lambda) {
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

/// By the forces some hundredths of a radian before and after it; where the step is not that long, or these do not tell
/// each other, by the equations there.
bool Crossing::accelerations_beside(const Interpolant& step, double t, double h, double at, MutableVector v_dot,
                                    MutableVector lambda) {
  if (!near_pose(doubtful)) return false;
  VectorXd its_v_dot(v_dot.size()), its_lambda(lambda.size()), there_v_dot(v_dot.size()), there_lambda(lambda.size());
  const ForcesBeside beside = between_forces_beside(step, t, h, at, its_v_dot, its_lambda);
  bool found = beside != ForcesBeside::none;
  if (beside != ForcesBeside::sure && tell(step, t, h, at, there_v_dot, there_lambda) && (!found || tells_forces())) {
    its_v_dot = there_v_dot;
    its_lambda = there_lambda;
    found = true;
  }
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

/// None where the step has too few states that tell them.
Crossing::ForcesBeside Crossing::between_forces_beside(const Interpolant& step, double t, double h, double at,
                                                       VectorXd& v_dot, VectorXd& lambda) {
  const System& system = dynamics_.system();
  step.interpolate(system, (at - t) / h, y_);
  const double rate = largest_rate(y_.segment(system.q_size(), system.v_size()));
  if (!(rate > 0.0)) return ForcesBeside::none;
  const double apart = std::min(away / rate, std::max(at - t, t + h - at) / least_states);
  std::vector<StateBeside> states;
  StateBeside next{0.0, 0.0, VectorXd(v_dot.size()), VectorXd(lambda.size())};
  for (int k = 1; k <= static_cast<int>(most_states); ++k)
    for (const double time : {k * apart, -k * apart}) {
      if (states.size() == most_states || at + time < t || at + time > t + h) continue;
      if (!tell(step, t, h, at + time, next.v_dot, next.lambda) || !tells_forces()) continue;
      next.time = time;
      next.least = dynamics_.formulation().least_singular_value();
      states.push_back(next);
    }
  if (states.size() < least_states) return ForcesBeside::none;
  return interpolate_states(std::move(states), apart, v_dot, lambda) ? ForcesBeside::sure : ForcesBeside::unsure;
}

}  // namespace linkwork
