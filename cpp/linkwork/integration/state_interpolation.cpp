#include "linkwork/integration/state_interpolation.hpp"

#include "linkwork/integration/state_difference.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

/// Of Euler parameters p, whose omega and its rate are there in y and v_dot.
Vec4<double> second_rates(const Vec4<double>& p, const Vec4<double>& p_dot, const MovingState& at, Eigen::Index omega,
                          Eigen::Index omega_dot) {
  return euler_parameter_rates<double>(p_dot, at.y.segment<3>(omega)) +
         euler_parameter_rates<double>(p, at.v_dot.segment<3>(omega_dot));
}

}  // namespace

CubicVelocities::CubicVelocities(const System& system, const ConstVector& begin, const ConstVector& end, double h)
    : first_(begin.segment(system.q_size(), system.v_size())),
      change_(end.segment(system.q_size(), system.v_size()) - first_),
      bend_(system.v_size()) {
  for (int body = 0; body < system.body_count(); ++body) {
    const Eigen::Index r = position_size * body, v = velocity_size * body;
    bend_.segment<3>(v) = (end.segment<3>(r) - begin.segment<3>(r)) / h;
    bend_.segment<3>(v + 3) = StateDifference::turn(end.segment<4>(r + 3), begin.segment<4>(r + 3)) / h;
  }
  bend_ = 6.0 * (bend_ - first_ - 0.5 * change_);
}

VectorXd quintic_between(const System& system, const MovingState& begin, const MovingState& end, double s) {
  const double h = end.t - begin.t, s2 = s * s, s3 = s2 * s, s4 = s3 * s, s5 = s4 * s;
  const double way[] = {10 * s3 - 15 * s4 + 6 * s5, h * (s - 6 * s3 + 8 * s4 - 3 * s5),
                        h * h * (s2 - 3 * s3 + 3 * s4 - s5) / 2, h * (-4 * s3 + 7 * s4 - 3 * s5),
                        h * h * (s3 - 2 * s4 + s5) / 2};
  const double rate[] = {(30 * s2 - 60 * s3 + 30 * s4) / h, 1 - 18 * s2 + 32 * s3 - 15 * s4,
                         h * (2 * s - 9 * s2 + 12 * s3 - 5 * s4) / 2, -12 * s2 + 28 * s3 - 15 * s4,
                         h * (3 * s2 - 8 * s3 + 5 * s4) / 2};
  const auto sum = [](const double(&of)[5], const auto& whole, const auto& v0, const auto& a0, const auto& v1,
                      const auto& a1) {
    return (of[0] * whole + of[1] * v0 + of[2] * a0 + of[3] * v1 + of[4] * a1).eval();
  };
  VectorXd out = begin.y;
  for (int body = 0; body < system.body_count(); ++body) {
    const Eigen::Index r = position_size * body, own = velocity_size * body, v = system.q_size() + own;
    const Vec3<double> x = end.y.segment<3>(r) - begin.y.segment<3>(r), v0 = begin.y.segment<3>(v),
                       v1 = end.y.segment<3>(v), a0 = begin.v_dot.segment<3>(own), a1 = end.v_dot.segment<3>(own);
    out.segment<3>(r) += sum(way, x, v0, a0, v1, a1);
    out.segment<3>(v) = sum(rate, x, v0, a0, v1, a1);
    const Vec4<double> p0 = begin.y.segment<4>(r + 3), p1 = end.y.segment<4>(r + 3), turned = p1 - p0;
    const Vec4<double> rate0 = euler_parameter_rates<double>(p0, begin.y.segment<3>(v + 3)),
                       rate1 = euler_parameter_rates<double>(p1, end.y.segment<3>(v + 3));
    const Vec4<double> bent0 = second_rates(p0, rate0, begin, v + 3, own + 3),
                       bent1 = second_rates(p1, rate1, end, v + 3, own + 3);
    const Vec4<double> p = p0 + sum(way, turned, rate0, bent0, rate1, bent1),
                       p_dot = sum(rate, turned, rate0, bent0, rate1, bent1);
    out.segment<4>(r + 3) = p;
    out.segment<3>(v + 3) =
        2.0 / p.squaredNorm() * quaternion_product<double>({p[0], -p[1], -p[2], -p[3]}, p_dot).tail<3>();
  }
  system.normalize(out.head(system.q_size()));
  return out;
}

}  // namespace linkwork
