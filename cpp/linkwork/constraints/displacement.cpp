#include "linkwork/constraints/displacement.hpp"

#include <algorithm>

#include "linkwork/math/rotation.hpp"

namespace linkwork {

double displace(const System& system, const VectorXd& x, VectorXd& q) {
  double largest = 0.0;
  for (int body = 0; body < system.body_count(); ++body) {
    const Vec3<double> step = x.segment<3>(6 * body), turn = x.segment<3>(6 * body + 3);
    auto r = q.segment<3>(7 * body);
    auto p = q.segment<4>(7 * body + 3);
    largest = std::max({largest, step.norm() / (1.0 + r.norm()), turn.norm()});
    r += step;
    p = quaternion_product<double>(p, exponential(turn));
    p.normalize();
  }
  return largest;
}

}  // namespace linkwork
