#include "linkwork/integration/moving_axes.hpp"

#include <algorithm>

namespace linkwork {
namespace {

/// Of vectors of the bodies, which lie `size` apart from `first` on, by masses; alike, where no body has one.
Vec3<double> mean(const System& system, const VectorXd& y, int first, int size) {
  Vec3<double> by_mass = Vec3<double>::Zero(), sum = Vec3<double>::Zero();
  double mass = 0.0;
  for (int body = 0; body < system.body_count(); ++body) {
    const Vec3<double> x = y.segment<3>(first + size * body);
    mass += system.mass(body);
    by_mass += system.mass(body) * x;
    sum += x;
  }
  return mass > 0.0 ? Vec3<double>(by_mass / mass) : Vec3<double>(sum / std::max(system.body_count(), 1));
}

Vec3<double> center(const System& system, const VectorXd& y) { return mean(system, y, 0, position_size); }

}  // namespace

MovingAxes MovingAxes::of(const System& system, const std::vector<const KeptStep*>& steps) {
  MovingAxes axes;
  if (steps.empty()) return axes;
  const KeptStep *first = steps.front(), *last = steps.front();
  for (const KeptStep* step : steps) {
    if (step->t < first->t) first = step;
    if (step->t + step->h > last->t + last->h) last = step;
  }
  axes.t = first->t;
  const Vec3<double> velocity =
      (center(system, last->y_new) - center(system, first->y)) / (last->t + last->h - first->t);
  if (velocity.allFinite()) axes.velocity = velocity;
  return axes;
}

MovingAxes MovingAxes::at_start(const System& system, const KeptStep& step) {
  return {step.t, mean(system, step.y, system.q_size(), velocity_size)};
}

void MovingAxes::move(double at, double sign, VectorXd& y) const {
  const Eigen::Index bodies = y.size() / (position_size + velocity_size);
  const Vec3<double> way = sign * (at - t) * velocity, added = sign * velocity;
  for (Eigen::Index body = 0; body < bodies; ++body) {
    y.segment<3>(position_size * body) += way;
    y.segment<3>(position_size * bodies + velocity_size * body) += added;
  }
}

}  // namespace linkwork
