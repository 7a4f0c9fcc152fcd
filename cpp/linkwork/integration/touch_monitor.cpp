#include "linkwork/integration/touch_monitor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwork/integration/hermite_step.hpp"

namespace linkwork {
namespace {

constexpr int parts = 64;  // of a step, in which the force of a touch is looked at

}  // namespace

void TouchMonitor::restart(const VectorXd& switches) { now_ = switches; }

void TouchMonitor::pass(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& switches) {
  if (switches.size() == 0) return;
  if (now_.size() > 0) {
    search_.begin(y, now_);
    if (search_.suspects({t, h, y, y_new}, switches)) {
      const HermiteStep step(dynamics_.system(), y, y_new, h);
      for (const TouchSearch::Touch& it : search_.find(step))
        note(it.which, t, h, search_.rate_at_start(t, h, y, it.which), change(step, it, t, h));
    }
  }
  now_ = switches;
}

namespace {

/// The root of x over those of the inertia of the bodies: of a force g M^-1 g, of velocities v M v.
double size(const System& system, const Element& of, const double* numbers, bool of_force) {
  double square = 0.0;
  const int bodies[] = {of.i, of.j};
  for (int k = 0; k < 2; ++k) {
    if (bodies[k] == ground) continue;
    const Body& body = system.model().bodies()[static_cast<std::size_t>(bodies[k])];
    const Eigen::Map<const Vec3<double>> first(numbers + velocity_size * k), last(numbers + velocity_size * k + 3);
    square += of_force ? first.squaredNorm() / body.mass + last.dot(body.inertia.ldlt().solve(last))
                       : first.squaredNorm() * body.mass + last.dot(body.inertia * last);
  }
  return std::sqrt(square);
}

}  // namespace

/// By the sum over time of the size of its force, be it to and fro: where it is looked at all over the step, and, as
/// that may be too rarely, the largest near the touch.
double TouchMonitor::change(const Interpolant& step, const TouchSearch::Touch& touch, double t, double h) const {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  ForceElement force(system, search_.element(touch.which));
  VectorXd y;
  const auto force_at = [&](double theta) {
    step.interpolate(system, theta, y);
    const auto g = force.forces(t + theta * h, y.head(nq), y.segment(nq, nv), dynamics_.history());
    return size(system, force.element(), g.data(), true);
  };
  double sum = 0.0, near = 0.0;
  for (int k = 0; k < parts; ++k) sum += force_at((k + 0.5) / parts);
  for (int k = -parts; k <= parts; ++k)
    near = std::max(near, force_at(std::clamp(touch.theta + k / (1.0 * parts * parts), 0.0, 1.0)));
  if (sum + near == 0.0) return 0.0;
  std::array<double, 2 * velocity_size> v{};
  step.interpolate(system, touch.theta, y);
  const int bodies[] = {force.element().i, force.element().j};
  for (int k = 0; k < 2; ++k)
    if (bodies[k] != ground) std::copy_n(&y[nq + velocity_size * bodies[k]], velocity_size, &v[velocity_size * k]);
  const double out = h / parts * (sum + near) / size(system, force.element(), v.data(), false);
  return std::isfinite(out) ? out : INFINITY;
}

void TouchMonitor::note(int which, double t, double h, double speed, double change) {
  const auto is_it = [which](const PassedTouch& it) { return it.which == which; };
  auto it = std::find_if(passed_.begin(), passed_.end(), is_it);
  if (it == passed_.end()) it = passed_.insert(it, {which, t, t, 0.0, 0.0, 0});
  it->until = t + h;
  it->speed = std::max(it->speed, speed);
  it->change += change;
  it->steps += 1;
}

}  // namespace linkwork
