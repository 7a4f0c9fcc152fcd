#include "linkwork/integration/relative_violation.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

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

double RelativeViolation::length_of(const System& system) {
  double longest = 0.0;
  for (const Element& joint : system.model().joints()) {
    if (joint.i != ground) longest = std::max(longest, joint.at.s_i.norm());
    if (joint.j != ground) longest = std::max(longest, joint.at.s_j.norm());
    if (keeps_points_apart(joint)) longest = std::max(longest, distance_of_points(system.model(), joint));
  }
  if (longest > 0.0) return longest;
  double squared = 0.0;
  for (int body = 0; body < system.body_count(); ++body)
    if (system.mass(body) > 0.0) squared = std::max(squared, system.inertia(body).trace() / system.mass(body));
  return squared > 0.0 ? std::sqrt(squared) : 1.0;
}

RelativeViolation::RelativeViolation(const System& system)
    : system_(system), length_(length_of(system)), at_(system.make_evaluation()) {}

// With d the displacement and phi the rotation of a body, Phi changes by D_r d + D_phi phi: the least change of both
// that makes up for a violation is |Phi| / |(D_r, D_phi / L)| as a length, L the size of the mechanism.
double RelativeViolation::largest(double t, const VectorXd& y, const VectorXd& history) {
  if (system_.row_count() == 0) return 0.0;
  system_.evaluate_constraints(t, y.head(system_.q_size()), y.segment(system_.q_size(), system_.v_size()), history,
                               at_);
  squared_.setZero(system_.row_count());
  for (const ConstraintBlock& block : system_.blocks())
    for (int k = 0; k < block.rows; ++k) {
      const Eigen::Map<const Eigen::Matrix<double, 6, 1>> D(&at_.D[block.offset + 6 * k]);
      squared_[block.row + k] += D.head<3>().squaredNorm() + D.tail<3>().squaredNorm() / (length_ * length_);
    }
  double largest = 0.0;
  for (Eigen::Index row = 0; row < squared_.size(); ++row)
    if (squared_[row] > 0.0) largest = std::max(largest, std::abs(at_.Phi[row]) / (length_ * std::sqrt(squared_[row])));
  return largest;
}

}  // namespace linkwork
