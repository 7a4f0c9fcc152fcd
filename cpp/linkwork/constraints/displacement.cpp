#include "linkwork/constraints/displacement.hpp"

#include "linkwork/math/rotation.hpp"

namespace linkwork {

void displace(const System& system, const VectorXd& x, VectorXd& q) {
  for (int body = 0; body < system.body_count(); ++body) {
    const Vec3<double> turn = x.segment<3>(6 * body + 3);
    q.segment<3>(7 * body) += x.segment<3>(6 * body);
    auto p = q.segment<4>(7 * body + 3);
    p = quaternion_product<double>(p, exponential(turn));
    p.normalize();
  }
}

}  // namespace linkwork
