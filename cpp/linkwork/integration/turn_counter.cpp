#include "linkwork/integration/turn_counter.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/special_joint.hpp"

namespace linkwork {
namespace {

constexpr double doubtful = std::numbers::pi / 2;  // by which the rates at two frames may miss an angle
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

TurnCounter::State TurnCounter::at(const Angle& angle, double t, const ConstVector& q, const ConstVector& v) const {
  const Element& joint = system_.model().joints()[static_cast<std::size_t>(angle.joint)];
  const BodyState<double> i = state_of(joint.i, q, v), j = state_of(joint.j, q, v);
  Equation<double> turn;
  angle.coordinate->evaluate(joint.at, i, j, turn);
  const double rate = turn.rate(i, j);
  if (std::isnan(passed_)) return {turn.Phi, rate};
  const double expected = angle.passed.angle + (t - passed_) * (angle.passed.rate + rate) / 2;
  return {continued(turn.Phi, expected), rate};
}

void TurnCounter::pass(double t, const ConstVector& q, const ConstVector& v) {
  for (Angle& it : angles_) it.passed = at(it, t, q, v);
  passed_ = t;
}

void TurnCounter::record(double t, const ConstVector& q, const ConstVector& v) {
  for (Angle& it : angles_) {
    const State now = at(it, t, q, v), before = std::exchange(it.recorded, now);
    const double turned = now.angle - before.angle, expected = (t - recorded_) * (before.rate + now.rate) / 2;
    const bool sure = std::abs(turned - expected) <= doubtful && std::abs(turned) <= std::numbers::pi;
    if (!std::isnan(recorded_) && !sure && found_.size() < most)
      found_.push_back({recorded_, t, it.joint, it.coordinate->name, turned});
  }
  recorded_ = t;
}

}  // namespace linkwork
