#include "linkwork/integration/tolerances.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/math/rotation.hpp"

namespace linkwork {

// The rotation that takes p to p + dp is conj(p) (p + dp) = |p|^2 + conj(p) dp: its angle is twice the vector part of
// conj(p) dp / |p|^2. The other part, a change of length alone, is no rotation, but it counts: error estimates are
// powers of the angle of a step, of which the even ones go into the length, and of dop853 that is the leading one.
// Without it a free wheel is off by a thousand tolerances.
double ErrorMeasure::of_body(int body, const ConstVector& y, const ConstVector& y_new, const ConstVector& dy) const {
  const int nq = system_.q_size();
  const Vec4<double> p = y.segment<4>(7 * body + 3), dp = dy.segment<4>(7 * body + 3);
  const Vec4<double> turn = quaternion_product<double>({p[0], -p[1], -p[2], -p[3]}, dp) / p.squaredNorm();
  double largest = 2.0 * turn.norm() / bound(1.0);
  for (const int place : {7 * body, nq + 6 * body, nq + 6 * body + 3}) {
    const double size = std::max(y.segment<3>(place).norm(), y_new.segment<3>(place).norm());
    const double value = dy.segment<3>(place).norm() / bound(size);
    if (!(value <= largest) && !std::isnan(largest)) largest = value;  // a NaN is the largest of all
  }
  return largest;
}

BodyMaximum ErrorMeasure::of_change(const ConstVector& y, const ConstVector& y_new, const ConstVector& dy) const {
  BodyMaximum largest;
  for (int body = 0; body < system_.body_count() && !std::isnan(largest.value); ++body) {
    const double value = of_body(body, y, y_new, dy);
    if (!(value <= largest.value)) largest = {value, body};
  }
  return largest;
}

VectorXd ErrorMeasure::of_parts(const ConstVector& y, const ConstVector& y_new, const ConstVector& dy) const {
  const ConnectedParts& parts = ConnectedParts::of(system_);
  VectorXd largest = VectorXd::Zero(parts.count());
  for (int body = 0; body < system_.body_count(); ++body) {
    double& own = largest[parts.of_body(body)];
    own = std::max(own, of_body(body, y, y_new, dy));
  }
  return largest;
}

double ErrorMeasure::of_length(const ConstVector& y) const {
  double largest = 1.0;
  for (int body = 0; body < system_.body_count(); ++body) largest = std::max(largest, y.segment<3>(7 * body).norm());
  return bound(largest);
}

double ErrorMeasure::of_state(const ConstVector& y) const {
  double largest = 1.0 / bound(1.0);
  for (int body = 0; body < system_.body_count(); ++body)
    for (const int place : {7 * body, system_.q_size() + 6 * body, system_.q_size() + 6 * body + 3}) {
      const double size = y.segment<3>(place).norm();
      largest = std::max(largest, size / bound(size));
    }
  return largest;
}

}  // namespace linkwork
