#include "linkwork/integration/turn_counter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/special_joint.hpp"

namespace linkwork {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double doubtful = pi / 2;  // by which the rates at two frames, or ends of a long step, may miss an angle
constexpr double followed = 1.0;     // by which an angle may turn from one look to the next, but for a step
constexpr double soon_long = 0.1;    // in a step: the next one may be by more than that

BodyState<double> state_of(int body, const ConstVector& q, const ConstVector& v) {
  if (body == ground)
    return {Vec3<double>::Zero(), Eigen::Matrix3d::Identity(), Vec3<double>::Zero(), Vec3<double>::Zero()};
  return {q.segment<3>(7 * body), rotation_matrix<double>(q.segment<4>(7 * body + 3)), v.segment<3>(6 * body),
          v.segment<3>(6 * body + 3)};
}

}  // namespace

TurnCounter::TurnCounter(const System& system) : system_(system) {
  const std::vector<Element>& joints = system.model().joints();
  for (std::size_t joint = 0; joint < joints.size(); ++joint)
    for (const FreeCoordinate* it : joint_info(joints[joint].kind).coordinates)
      if (it->angle()) way_.angles.push_back({static_cast<int>(joint), it});
}

double TurnCounter::fastest(const ConstVector& v) const {
  double square = 0.0;
  for (Eigen::Index body = 0; body < system_.body_count(); ++body)
    square = std::max(square, v.segment<3>(velocity_size * body + 3).squaredNorm());
  return std::sqrt(square);
}

/// Two bodies turn against each other by the rates of both at most. Steps are short mostly: states are kept to look at
/// them before the next step only where that may be a long one.
void TurnCounter::advance(double t, const ConstVector& q, const ConstVector& v) {
  const double now = fastest(v);
  const double turned =
      std::isnan(way_.last.t) ? 0.0 : 2.0 * std::abs(t - way_.last.t) * std::max(now, way_.last.fastest);
  if (way_.kept && way_.since_look + turned > followed) look(way_.last.t, way_.last.q, way_.last.v);
  way_.last.t = t;
  way_.last.fastest = now;
  way_.since_frame += turned;
  way_.since_look += turned;
  way_.looked = !is_first() && way_.since_look > followed;
  if (way_.looked) look(t, q, v);
  way_.kept = !is_first() && !way_.looked && turned > soon_long;
  if (!way_.kept) return;
  way_.last.q = q;
  way_.last.v = v;
}

TurnCounter::State TurnCounter::state(const Angle& angle, const ConstVector& q, const ConstVector& v) const {
  const Element& joint = system_.model().joints()[static_cast<std::size_t>(angle.joint)];
  const BodyState<double> i = state_of(joint.i, q, v), j = state_of(joint.j, q, v);
  Equation<double> turn;
  angle.coordinate->evaluate(joint.at, i, j, turn);
  return {turn.Phi, turn.rate(i, j)};
}

/// The first time since a frame at that, too.
void TurnCounter::look(double t, const ConstVector& q, const ConstVector& v) {
  if (std::isnan(way_.looked_at)) {
    for (Angle& it : way_.angles) it.at_frame = it.last = state(it, way_.frame.q, way_.frame.v);
    way_.looked_at = way_.frame.t;
  }
  for (Angle& it : way_.angles) {
    State now = state(it, q, v);
    if (way_.since_look < pi) now.angle = continued(now.angle, it.last.angle);
    else follow_long_step(t - way_.looked_at, it, now);
    it.last = now;
  }
  way_.looked_at = t;
  way_.since_look = 0.0;
}

/// What is so far from the last look is one step, but for short ones. Its turns are sure where any rate between those at
/// its ends tells nearly the same, which the pose bears out.
void TurnCounter::follow_long_step(double h, Angle& angle, State& now) {
  const double expected = angle.last.angle + h * (angle.last.rate + now.rate) / 2;
  now.angle = continued(now.angle, expected);
  const bool told = h * std::abs(now.rate - angle.last.rate) <= pi && std::abs(now.angle - expected) <= doubtful;
  angle.sure = angle.sure && told;
}

void TurnCounter::pass(double t, const ConstVector& q, const ConstVector& v) {
  if (!way_.angles.empty()) advance(t, q, v);
}

void TurnCounter::record(double t, const ConstVector& q, const ConstVector& v) {
  if (way_.angles.empty()) return;
  advance(t, q, v);
  const double by_rates = (t - way_.frame.t) * (way_.frame.fastest + way_.last.fastest);
  if (!is_first() && way_.since_frame + by_rates > doubtful) {
    if (!way_.looked) look(t, q, v);
    compare();
  }
  way_.frame = {t, q, v, way_.last.fastest};
  way_.looked_at = NAN;
  way_.kept = false;
  way_.since_frame = way_.since_look = 0.0;
}

void TurnCounter::compare() {
  for (Angle& it : way_.angles) {
    const double turned = it.last.angle - it.at_frame.angle;
    const double expected = (way_.last.t - way_.frame.t) * (it.at_frame.rate + it.last.rate) / 2;
    const bool told = std::abs(turned - expected) <= doubtful && std::abs(turned) <= pi;
    if (!it.sure || !told)
      found_.push_back({way_.frame.t, way_.last.t, it.joint, it.coordinate->name, it.sure ? turned : NAN});
    it.sure = true;
  }
}

}  // namespace linkwork
