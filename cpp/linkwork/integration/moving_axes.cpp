#include "linkwork/integration/moving_axes.hpp"

#include <cmath>

#include "linkwork/assembly/connected_components.hpp"

namespace linkwork {
namespace {

/// Those of each part stand still.
MovingAxes still(const System& system, double t) {
  const ConnectedParts& parts = ConnectedParts::of(system);
  MovingAxes out;
  out.t = t;
  for (int body = 0; body < system.body_count(); ++body) out.part.push_back(parts.of_body(body));
  out.velocity.setZero(3, parts.count());
  return out;
}

/// Of vectors of the bodies, which lie `size` apart from `first` on, in each part: by masses; alike, where no body has
/// one.
Eigen::Matrix3Xd means(const System& system, const std::vector<int>& part, Eigen::Index parts, const VectorXd& y,
                       int first, int size) {
  Eigen::Matrix3Xd by_mass = Eigen::Matrix3Xd::Zero(3, parts), sum = by_mass;
  VectorXd mass = VectorXd::Zero(parts), count = mass;
  for (int body = 0; body < system.body_count(); ++body) {
    const Vec3<double> x = y.segment<3>(first + size * body);
    const int k = part[body];
    mass[k] += system.mass(body);
    count[k] += 1.0;
    by_mass.col(k) += system.mass(body) * x;
    sum.col(k) += x;
  }
  for (Eigen::Index k = 0; k < parts; ++k)
    if (mass[k] > 0.0) by_mass.col(k) /= mass[k];
    else by_mass.col(k) = sum.col(k) / count[k];
  return by_mass;
}

}  // namespace

MovingAxes MovingAxes::of(const System& system, const std::vector<const KeptStep*>& steps) {
  if (steps.empty()) return {};
  const KeptStep *first = steps.front(), *last = steps.front();
  for (const KeptStep* step : steps) {
    if (step->t < first->t) first = step;
    if (step->t + step->h > last->t + last->h) last = step;
  }
  MovingAxes axes = still(system, first->t);
  const auto centers = [&](const VectorXd& y) {
    return means(system, axes.part, axes.velocity.cols(), y, 0, position_size);
  };
  const Eigen::Matrix3Xd velocity = (centers(last->y_new) - centers(first->y)) / (last->t + last->h - first->t);
  for (Eigen::Index k = 0; k < velocity.cols(); ++k)
    if (velocity.col(k).allFinite()) axes.velocity.col(k) = velocity.col(k);
  return axes;
}

MovingAxes MovingAxes::at_start(const System& system, const KeptStep& step) {
  MovingAxes axes = still(system, step.t);
  axes.velocity = means(system, axes.part, axes.velocity.cols(), step.y, system.q_size(), velocity_size);
  return axes;
}

VectorXd MovingAxes::diagonals(const std::vector<const KeptStep*>& steps) const {
  Eigen::Array3Xd low = Eigen::Array3Xd::Constant(3, velocity.cols(), INFINITY), high = -low;
  for (const KeptStep* step : steps) {
    VectorXd seen = step->y_new;
    if (!seen.allFinite()) continue;
    see(step->t + step->h, seen);
    for (std::size_t body = 0; body < part.size(); ++body) {
      const Eigen::Array3d r = seen.segment<3>(position_size * static_cast<Eigen::Index>(body)).array();
      low.col(part[body]) = low.col(part[body]).min(r);
      high.col(part[body]) = high.col(part[body]).max(r);
    }
  }
  return (high - low).max(0.0).matrix().colwise().norm();
}

void MovingAxes::move(double at, double sign, VectorXd& y) const {
  const Eigen::Index bodies = static_cast<Eigen::Index>(part.size());
  for (Eigen::Index body = 0; body < bodies; ++body) {
    const Vec3<double> added = sign * velocity.col(part[body]);
    y.segment<3>(position_size * body) += (at - t) * added;
    y.segment<3>(position_size * bodies + velocity_size * body) += added;
  }
}

}  // namespace linkwork
