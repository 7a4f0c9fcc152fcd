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
      if (it->angle()) angles_.push_back({static_cast<int>(joint), it});
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
  const double turned = std::isnan(last_.t) ? 0.0 : 2.0 * (t - last_.t) * std::max(now, last_.fastest);
  if (kept_ && since_look_ + turned > followed) look(last_.t, last_.q, last_.v);
  last_.t = t;
  last_.fastest = now;
  since_frame_ += turned;
  since_look_ += turned;
  looked_ = !is_first() && since_look_ > followed;
  if (looked_) look(t, q, v);
  kept_ = !is_first() && !looked_ && turned > soon_long;
  if (!kept_) return;
  last_.q = q;
  last_.v = v;
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
  if (std::isnan(looked_at_)) {
    for (Angle& it : angles_) it.at_frame = it.last = state(it, frame_.q, frame_.v);
    looked_at_ = frame_.t;
  }
  for (Angle& it : angles_) {
    State now = state(it, q, v);
    if (since_look_ < pi) now.angle = continued(now.angle, it.last.angle);
    else follow_long_step(t - looked_at_, it, now);
    it.last = now;
  }
  looked_at_ = t;
  since_look_ = 0.0;
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
  if (!angles_.empty()) advance(t, q, v);
}

void TurnCounter::record(double t, const ConstVector& q, const ConstVector& v) {
  if (angles_.empty()) return;
  advance(t, q, v);
  const double by_rates = (t - frame_.t) * (frame_.fastest + last_.fastest);
  if (!is_first() && since_frame_ + by_rates > doubtful) {
    if (!looked_) look(t, q, v);
    compare();
  }
  frame_ = {t, q, v, last_.fastest};
  looked_at_ = NAN;
  kept_ = false;
  since_frame_ = since_look_ = 0.0;
}

void TurnCounter::compare() {
  for (Angle& it : angles_) {
    const double turned = it.last.angle - it.at_frame.angle;
    const double expected = (last_.t - frame_.t) * (it.at_frame.rate + it.last.rate) / 2;
    const bool told = std::abs(turned - expected) <= doubtful && std::abs(turned) <= pi;
    if (!it.sure || !told) found_.push_back({frame_.t, last_.t, it.joint, it.coordinate->name, it.sure ? turned : NAN});
    it.sure = true;
  }
}

}  // namespace linkwork
