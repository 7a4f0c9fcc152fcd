#include "linkwork/integration/relative_violation.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

// Of the radius of gyration: joints nearer to a center of mass give a part no size of its own. Not more, as the radius
// says nothing of bodies with much inertia and little mass, which stand for rotors.
constexpr double next_to = 1e-3;

bool keeps_points_apart(const Element& joint) {
  const std::vector<EquationInfo>& equations = joint_info(joint.kind).equations;
  return std::any_of(equations.begin(), equations.end(),
                     [](const EquationInfo& it) { return it.quantity == EquationInfo::Quantity::distance; });
}

/// Where the bodies of the model are.
double distance_of_points(const Model& model, const Element& joint) {
  const auto point = [&](int body, const Vec3<double>& s) -> Vec3<double> {
    if (body == ground) return s;
    return model.bodies()[body].position + rotation_matrix<double>(model.bodies()[body].orientation) * s;
  };
  return (point(joint.i, joint.at.s_i) - point(joint.j, joint.at.s_j)).norm();
}

}  // namespace

VectorXd RelativeViolation::lengths_of(const System& system) {
  const ConnectedParts& parts = ConnectedParts::of(system);
  VectorXd longest = VectorXd::Zero(parts.count()), squared = VectorXd::Constant(parts.count(), INFINITY);
  for (const Element& joint : system.model().joints()) {
    double& own = longest[parts.of_bodies(joint.i, joint.j)];
    if (joint.i != ground) own = std::max(own, joint.at.s_i.norm());
    if (joint.j != ground) own = std::max(own, joint.at.s_j.norm());
    if (keeps_points_apart(joint)) own = std::max(own, distance_of_points(system.model(), joint));
  }
  for (int body = 0; body < system.body_count(); ++body) {
    double& own = squared[parts.of_body(body)];
    const double J = system.inertia(body).trace();
    if (system.mass(body) > 0.0 && J > 0.0) own = std::min(own, J / system.mass(body));
  }
  for (Eigen::Index part = 0; part < longest.size(); ++part) {
    const double gyration = std::sqrt(squared[part]);
    if (gyration < INFINITY && longest[part] < next_to * gyration) longest[part] = gyration;
    else if (!(longest[part] > 0.0)) longest[part] = 1.0;
  }
  return longest;
}

RelativeViolation::RelativeViolation(const System& system)
    : system_(system), lengths_(lengths_of(system)), at_(system.make_evaluation()) {}

// With d the displacement and phi the rotation of a body, Phi changes by D_r d + D_phi phi: the least change of both
// that makes up for a violation is |Phi| / |(D_r, D_phi / L)| as a length, L the size of the part.
double RelativeViolation::largest(double t, const VectorXd& y, const VectorXd& history) {
  const ConnectedParts& parts = ConnectedParts::of(system_);
  speeds_.setZero(parts.count());
  if (system_.row_count() == 0) return 0.0;
  system_.evaluate_constraints(t, y.head(system_.q_size()), y.segment(system_.q_size(), system_.v_size()), history,
                               at_);
  squared_.setZero(system_.row_count());
  const auto length = [&](Eigen::Index row) { return lengths_[parts.of_row(row)]; };
  for (const ConstraintBlock& block : system_.blocks()) {
    const double squared_length = length(block.row) * length(block.row);
    for (int k = 0; k < block.rows; ++k) {
      const Eigen::Map<const Eigen::Matrix<double, 6, 1>> D(&at_.D[block.offset + 6 * k]);
      squared_[block.row + k] += D.head<3>().squaredNorm() + D.tail<3>().squaredNorm() / squared_length;
    }
  }
  double largest = 0.0;
  for (Eigen::Index row = 0; row < squared_.size(); ++row) {
    if (!(squared_[row] > 0.0)) continue;
    const double of_motion = std::sqrt(squared_[row]);
    double& speed = speeds_[parts.of_row(row)];
    largest = std::max(largest, std::abs(at_.Phi[row]) / (length(row) * of_motion));
    speed = std::max(speed, std::abs(at_.Phi_dot[row]) / of_motion);
  }
  return largest;
}

}  // namespace linkwork
