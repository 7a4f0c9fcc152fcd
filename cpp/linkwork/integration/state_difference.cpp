#include "linkwork/integration/state_difference.hpp"

#include <algorithm>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {

Vec3<double> StateDifference::turn(const Vec4<double>& a, const Vec4<double>& b) {
  const Vec4<double> difference = a.dot(b) < 0.0 ? Vec4<double>(-a - b) : Vec4<double>(a - b);  // of the same sign
  return 2.0 * quaternion_product<double>({b[0], -b[1], -b[2], -b[3]}, difference).tail<3>();
}

StateDifference StateDifference::of_body(const System& system, int body, const VectorXd& a, const VectorXd& b) {
  const int r = position_size * body, p = r + 3, v = system.q_size() + velocity_size * body;
  return {(a.segment<3>(r) - b.segment<3>(r)).norm(), turn(a.segment<4>(p), b.segment<4>(p)).norm(),
          (a.segment<3>(v) - b.segment<3>(v)).norm(), (a.segment<3>(v + 3) - b.segment<3>(v + 3)).norm()};
}

void StateDifference::raise(const StateDifference& other) {
  position = std::max(position, other.position);
  rotation = std::max(rotation, other.rotation);
  velocity = std::max(velocity, other.velocity);
  omega = std::max(omega, other.omega);
}

void StateDifference::lower(const StateDifference& by) {
  position = std::max(position - by.position, 0.0);
  rotation = std::max(rotation - by.rotation, 0.0);
  velocity = std::max(velocity - by.velocity, 0.0);
  omega = std::max(omega - by.omega, 0.0);
}

void StateDifference::scale(double factor) {
  for (double* value : {&position, &rotation, &velocity, &omega}) *value *= factor;
}

DifferencesOfParts differences(const System& system, const VectorXd& a, const VectorXd& b) {
  const ConnectedParts& parts = ConnectedParts::of(system);
  DifferencesOfParts out(parts.count());
  for (int body = 0; body < system.body_count(); ++body)
    out[parts.of_body(body)].raise(StateDifference::of_body(system, body, a, b));
  return out;
}

}  // namespace linkwork
