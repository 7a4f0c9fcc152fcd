#include "linkwork/linear/block/ballast.hpp"

#include <algorithm>

namespace linkwork::block {
namespace {

constexpr double least_part = 1e-3;  // of a size: with smaller pivots, refinement finds digits that elimination loses

struct Size {
  double mass = 0.0, moment = 0.0;
};

Size own_size(const Body& body) { return {body.mass, body.inertia.diagonal().maxCoeff()}; }

/// For bodies that carry nothing; any where there is none, as nothing moves there.
Size mean_size(const std::vector<Body>& bodies) {
  Size out;
  for (const Body& body : bodies) {
    const Size own = own_size(body);
    out.mass += own.mass / static_cast<double>(bodies.size());
    out.moment += own.moment / static_cast<double>(bodies.size());
  }
  if (out.mass == 0.0) out.mass = out.moment > 0.0 ? out.moment : 1.0;
  if (out.moment == 0.0) out.moment = out.mass;
  return out;
}

/// The squared distances of a joint from the centers of mass of its bodies.
double squared_arms(const Model& model, int row) {
  const Attachment<double>& at = model.joints()[model.joint_of_row(row)].at;
  return at.s_i.squaredNorm() + at.s_j.squaredNorm();
}

/// Own ones, m l^2 of the joint that holds a body included; where a body has none, those of its branches.
std::vector<Size> sizes(const Model& model, const std::vector<TreeStep>& steps, int compliant_from) {
  std::vector<Size> out;
  for (const Body& body : model.bodies()) out.push_back(own_size(body));
  for (const TreeStep& step : steps) {
    Size& body = out[step.body];
    if (step.rows > 0 && step.row < compliant_from) body.moment += body.mass * squared_arms(model, step.row);
    if (step.parent < 0) continue;
    const Size own = own_size(model.bodies()[step.parent]);
    if (own.mass == 0.0) out[step.parent].mass += body.mass;
    if (own.moment == 0.0) out[step.parent].moment += body.moment;
  }
  return out;
}

}  // namespace

std::vector<Ballast> ballasts(const Model& model, const std::vector<TreeStep>& steps, int compliant_from) {
  const Size mean = mean_size(model.bodies());
  std::vector<Ballast> out;
  for (const Size& it : sizes(model, steps, compliant_from)) {
    const double mass = it.mass > 0.0 ? it.mass : mean.mass, moment = it.moment > 0.0 ? it.moment : mean.moment;
    out.push_back({1.0 / mass, 1.0 / moment, least_part * mass, least_part * moment});
  }
  return out;
}

}  // namespace linkwork::block
