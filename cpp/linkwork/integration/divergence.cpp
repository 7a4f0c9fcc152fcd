#include "linkwork/integration/divergence.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace linkwork {
namespace {

constexpr double rounded = 64 * std::numeric_limits<double>::epsilon();

/// The longest side of the box around the bodies and the joints on the ground, or the longest arm of a joint on a body;
/// none where it is only what positions are rounded to.
double size_of(const Model& model) {
  Eigen::AlignedBox3d box;
  double arm = 0.0;
  for (const Body& body : model.bodies()) box.extend(body.position);
  for (const Element& joint : model.joints())
    for (const auto& [body, s] : {std::pair{joint.i, joint.at.s_i}, std::pair{joint.j, joint.at.s_j}}) {
      if (body == ground) box.extend(s);
      else arm = std::max(arm, s.cwiseAbs().maxCoeff());
    }
  if (box.isEmpty()) return arm > 0.0 ? arm : INFINITY;
  const double size = std::max(arm, box.sizes().maxCoeff());
  const double reach = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return size > rounded * reach ? size : INFINITY;
}

}  // namespace

Divergence::Divergence(const System& system) : system_(system), size_(size_of(system.model())) {}

void Divergence::look(const VectorXd& y, double t, double h, double limit) const {
  const auto v = y.segment(system_.q_size(), system_.v_size());
  if (v.size() == 0 || v.cwiseAbs().maxCoeff() * h <= limit * std::min(size_, 1.0)) return;
  for (int body = 0; body < system_.body_count(); ++body) {
    const double way = v.segment<3>(velocity_size * body).norm() * h;
    const double angle = v.segment<3>(velocity_size * body + 3).norm() * h;
    if (angle > limit) report(angle, true, body, t, h);
    if (way > limit * size_) report(way, false, body, t, h);
  }
}

void Divergence::report(double way, bool turn, int body, double t, double h) const {
  ErrorDetails details;
  details.bodies = {system_.model().body_name(body)};
  details.time = t;
  details.step = h;
  char moves[64];
  std::snprintf(moves, sizeof moves, turn ? "turns by %.3g rad" : "moves by %.3g m", way);
  throw NotFiniteError(code,
                       "body '" + details.bodies.front() + "' " + moves +
                           " within one step: the run diverged; use a smaller step, or rtol for steps that follow the "
                           "motion",
                       details);
}

}  // namespace linkwork
