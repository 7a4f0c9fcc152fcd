#include "linkwork/integration/relative_violation.hpp"

#include <algorithm>
#include <cmath>

namespace linkwork {
double RelativeViolation::length_of(const System& system) {
  double longest = 0.0;
  for (const Element& joint : system.model().joints()) {
    if (joint.i != ground) longest = std::max(longest, joint.at.s_i.norm());
    if (joint.j != ground) longest = std::max(longest, joint.at.s_j.norm());
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
