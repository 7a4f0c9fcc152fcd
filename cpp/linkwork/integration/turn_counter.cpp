#include "linkwork/integration/turn_counter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/special_joint.hpp"

namespace linkwork {
namespace {

constexpr double doubtful = std::numbers::pi / 2;  // by which the rates at two frames may miss an angle
constexpr double followed = 1.0;                   // by which an angle may turn from one look to the next
constexpr std::size_t most = 10000;

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
      if (it->angle()) angles_.push_back({static_cast<int>(joint), it, {}, {}});
}

double TurnCounter::fastest(const ConstVector& v) const {
  double square = 0.0;
  for (Eigen::Index body = 0; body < system_.body_count(); ++body)
    square = std::max(square, v.segment<3>(velocity_size * body + 3).squaredNorm());
  return std::sqrt(square);
}

/// Two bodies turn against each other by the rates of both at most.
void TurnCounter::advance(double t, const ConstVector& v) {
  const double now = fastest(v);
  const double turned = std::isnan(t_) ? 0.0 : 2.0 * (t - t_) * std::max(now, fastest_);
  since_frame_ += turned;
  since_look_ += turned;
  t_ = t;
  fastest_ = now;
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
    now.angle = continued(now.angle, it.last.angle + (t - looked_at_) * (it.last.rate + now.rate) / 2);
    it.last = now;
  }
  looked_at_ = t;
  since_look_ = 0.0;
}

void TurnCounter::pass(double t, const ConstVector& q, const ConstVector& v) {
  if (angles_.empty()) return;
  advance(t, v);
  if (since_look_ >= followed && !is_first()) look(t, q, v);
}

void TurnCounter::record(double t, const ConstVector& q, const ConstVector& v) {
  if (angles_.empty()) return;
  advance(t, v);
  const double by_rates = (t - frame_.t) * (frame_.fastest + fastest_);
  if (!is_first() && (since_frame_ > doubtful || by_rates > doubtful)) {
    look(t, q, v);
    compare(t);
  }
  frame_.t = t;
  frame_.q = q;
  frame_.v = v;
  frame_.fastest = fastest_;
  looked_at_ = NAN;
  since_frame_ = since_look_ = 0.0;
}

void TurnCounter::compare(double t) {
  for (const Angle& it : angles_) {
    const double turned = it.last.angle - it.at_frame.angle;
    const double expected = (t - frame_.t) * (it.at_frame.rate + it.last.rate) / 2;
    const bool sure = std::abs(turned - expected) <= doubtful && std::abs(turned) <= std::numbers::pi;
    if (!sure && found_.size() < most) found_.push_back({frame_.t, t, it.joint, it.coordinate->name, turned});
  }
}

}  // namespace linkwork
