#include "linkwork/integration/approach.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

Vec3<double> part(const double* numbers, int size, int at, int body) {
  if (body == ground || numbers == nullptr) return Vec3<double>::Zero();
  return Eigen::Map<const Vec3<double>>(numbers + std::ptrdiff_t{size} * body + at);
}

/// One end of a step.
struct End {
  const VectorXd& y;
  const double* v;
  const double* v_dot;

  Vec3<double> r(int body) const { return part(y.data(), position_size, 0, body); }
  Vec3<double> r_dot(int body) const { return part(v, velocity_size, 0, body); }
  Vec3<double> omega(int body) const { return part(v, velocity_size, 3, body); }
  Vec3<double> r_ddot(int body) const { return part(v_dot, velocity_size, 0, body); }
  Vec3<double> omega_dot(int body) const { return part(v_dot, velocity_size, 3, body); }
  Vec4<double> p(int body) const { return y.segment<4>(position_size * body + 3); }
  Vec4<double> p_dot(int body) const { return euler_parameter_rates<double>(p(body), omega(body)); }
};

/// Length of the way from x to x_new, at most.
template <class Vector>
double way(double h, const Vector& x, const Vector& x_new, const Vector& x_dot, const Vector& x_dot_new) {
  const Vector between = 3.0 * (x_new - x) - h * (x_dot + x_dot_new);
  return std::max({h * x_dot.norm(), h * x_dot_new.norm(), between.norm()});
}

double turn(double h, int body, const End& a, const End& b) {
  if (body == ground) return 0.0;
  const double bend = std::max(a.omega_dot(body).norm(), b.omega_dot(body).norm());
  return 2.0 * way<Vec4<double>>(h, a.p(body), b.p(body), a.p_dot(body), b.p_dot(body)) + 0.5 * h * h * bend;
}

Approach::Limit limit_of_time(const Model& model, const Element& element, int place) {
  const SwitchLimit* limits = force_kinds()[element.kind].limits;
  if (!limits) return {};
  const std::size_t parameter = element.first_parameter + static_cast<std::size_t>(limits[place].parameter);
  const int signal = model.force_parameters()[parameter].signal;
  if (signal < 0) return {};
  const TimeFunction& function = *model.signals()[static_cast<std::size_t>(signal)];
  Approach::Limit out{&function, limits[place].sign, function.amplitude(), {}};
  std::vector<Break> breaks;
  function.add_breaks(breaks);
  for (const Break& it : breaks) out.breaks.push_back(it.t);
  std::sort(out.breaks.begin(), out.breaks.end());
  return out;
}

}  // namespace

Approach::Approach(const Model& model) {
  for (const SwitchOwner& owner : owners_of_switches(model)) {
    const Element& it = model.forces()[static_cast<std::size_t>(owner.element)];
    const ForceKind& kind = force_kinds()[it.kind];
    const Shape shape = kind.info.placement == "two_points"  ? Shape::spheres
                        : kind.history == HistoryKind::angle ? Shape::angle
                                                             : Shape::along_axis;
    gaps_.push_back({owner, it.i, it.j, it.at.s_i, it.at.s_j, shape, limit_of_time(model, it, owner.place)});
  }
}

double Approach::largest_change(int which, const StepEnds& step) const {
  const Gap& gap = gaps_[static_cast<std::size_t>(which)];
  const auto nq = static_cast<std::ptrdiff_t>(position_size * ((step.y.size() - 1) / (position_size + velocity_size)));
  const End a{step.y, step.y.data() + nq, step.v_dot}, b{step.y_new, step.y_new.data() + nq, step.v_dot_new};
  const int i = gap.i, j = gap.j;
  const double h = step.h;
  if (gap.shape == Shape::angle) return turn(h, i, a, b) + turn(h, j, a, b);
  const Vec3<double> r = a.r(j) - a.r(i), r_new = b.r(j) - b.r(i);
  const double bend = std::max((a.r_ddot(j) - a.r_ddot(i)).norm(), (b.r_ddot(j) - b.r_ddot(i)).norm());
  const double arm_j = gap.s_j.norm();
  double out = way<Vec3<double>>(h, r, r_new, a.r_dot(j) - a.r_dot(i), b.r_dot(j) - b.r_dot(i)) + 0.5 * h * h * bend;
  const double arm_i = gap.shape == Shape::spheres ? gap.s_i.norm() : std::max(r.norm(), r_new.norm()) + out + arm_j;
  if (arm_j > 0.0) out += arm_j * turn(h, j, a, b);
  if (arm_i > 0.0) out += arm_i * turn(h, i, a, b);
  return out;
}

double Approach::distance(int which, const VectorXd& y) const {
  const Gap& gap = gaps_[static_cast<std::size_t>(which)];
  const auto point = [&](int body, const Vec3<double>& s) -> Vec3<double> {
    if (body == ground) return s;
    return y.segment<3>(position_size * body) + rotation_matrix<double>(y.segment<4>(position_size * body + 3)) * s;
  };
  return (point(gap.j, gap.s_j) - point(gap.i, gap.s_i)).norm();
}

}  // namespace linkwork
