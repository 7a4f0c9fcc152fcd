// Sums over bodies and blocks of D: products with M, D and their like.
#include <algorithm>

#include "linkwork/assembly/saddle_products.hpp"
#include "linkwork/assembly/system.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {

void System::position_rates(const ConstVector& q, const ConstVector& v, MutableVector q_dot) const {
  threads_->in_chunks(body_count(), chunk, [&](int first, int last) {
    for (int b = first; b < last; ++b) {
      const auto velocity = v.segment<velocity_size>(velocity_size * b);
      auto rates = q_dot.segment<position_size>(position_size * b);
      rates.head<3>() = velocity.head<3>();
      rates.tail<4>() = euler_parameter_rates<double>(q.segment<4>(position_size * b + 3), velocity.tail<3>());
    }
  });
}

void System::normalize(MutableVector q) const {
  threads_->in_chunks(body_count(), chunk, [&](int first, int last) {
    for (int b = first; b < last; ++b) q.segment<4>(position_size * b + 3).normalize();
  });
}

void System::multiply_mass(const Evaluation& at, const ConstVector& x, MutableVector y) const {
  threads_->in_chunks(body_count(), chunk, [&](int first, int last) {
    for (int b = first; b < last; ++b)
      saddle_products::multiply_mass<saddle_products::Doubles>(b, &mass_.front().m, x.data(), y.data());
  });
  const double* D = at.D.data();
  inerters_.add(D, [&](std::size_t k) { return inerters_.inertance(k) * inerters_.rate(k, D, x.data()); }, y.data());
}

// In one order of operations, which lanes have too: that of Eigen's products is not the same in all rows.
void System::multiply_inverse_mass(const ConstVector& x, MutableVector y) const {
  threads_->in_chunks(body_count(), chunk, [&](int first, int last) {
    for (int b = first; b < last; ++b) {
      const int k = velocity_size * b;
      const Mat3<double> inverse = inverse_inertia(b);
      const Vec3<double> torque = x.segment<3>(k + 3);
      y.segment<3>(k) = inverse_mass(b) * x.segment<3>(k);
      for (int r = 0; r < 3; ++r)
        y[k + 3 + r] = inverse(r, 0) * torque[0] + inverse(r, 1) * torque[1] + inverse(r, 2) * torque[2];
    }
  });
}

double System::kinetic_energy(const Evaluation& at, const ConstVector& v) const {
  double twice = 0.0;
  for (int b = 0; b < body_count(); ++b) {
    const auto velocity = v.segment<velocity_size>(velocity_size * b);
    const Vec3<double> omega = velocity.tail<3>();
    twice += mass(b) * velocity.head<3>().squaredNorm() + omega.dot(inertia(b) * omega);
  }
  for (std::size_t k = 0; k < inerters_.count(); ++k) {
    const double rate = inerters_.rate(k, at.D.data(), v.data());
    twice += inerters_.inertance(k) * rate * rate;
  }
  return 0.5 * twice;
}

void System::multiply_D(const Evaluation& at, const ConstVector& x, MutableVector y) const {
  threads_->in_chunks(joint_count(), chunk, [&](int first, int last) {
    const std::vector<int>& row = model_.joint_rows();
    y.segment(row[first], row[last] - row[first]).setZero();
    for (int k = joint_block_begin_[first]; k < joint_block_begin_[last]; ++k)
      saddle_products::add_D<saddle_products::Doubles>(blocks_[joint_block_list_[k]], at.D.data(), x.data(), y.data());
  });
}

void System::add_D_transposed(const Evaluation& at, const ConstVector& lambda, MutableVector y) const {
  const auto add = [&](const ConstraintBlock& block) {
    saddle_products::add_D_transposed<saddle_products::Doubles>(block, at.D.data(), lambda.data(), y.data());
  };
  if (threads_->threads() == 1) {
    for (const ConstraintBlock& block : blocks_) add(block);
    return;
  }
  threads_->in_chunks(body_count(), chunk, [&](int first, int last) {  // for each body in the same order
    for (int k = body_block_begin_[first]; k < body_block_begin_[last]; ++k) add(blocks_[body_block_list_[k]]);
  });
}

double System::power_of_drivers(const Evaluation& at, const ConstVector& lambda) const {
  double power = 0.0;
  for (const int row : driven_rows_) power += lambda[row] * at.Phi_t[row];
  return power;
}

VectorXd System::delassus_diagonal(const Evaluation& at) const {
  VectorXd delassus = VectorXd::Zero(row_count());
  for (const ConstraintBlock& block : blocks_) {
    const BlockOfD D = block_of(at, block);
    const double m = inverse_mass(block.body);
    const Mat3<double> J = inverse_inertia(block.body);
    for (int k = 0; k < block.rows; ++k) {
      const Vec3<double> rotation = D.row(k).tail<3>();
      delassus[block.row + k] += m * D.row(k).head<3>().squaredNorm() + rotation.dot(J * rotation);
    }
  }
  return delassus;
}

// A joint's generalized force on a body is D_b^T lambda = (F, n): F inertial, n about the centre of mass in body axes.
// About the joint's point P_j on the second body:  T = A_b n - (P_j - r_b) x F. On the first body it is the opposite;
// that one is asked where the second is the ground, where P_j = s_j. Of a coupler: what it exerts on the second body of
// its first coordinate, be it the ground, as the first body may have to do with other coordinates, too.
void System::reactions(const Evaluation& at, const ConstVector& q, const ConstVector& lambda,
                       Eigen::Ref<Eigen::Matrix3Xd> force, Eigen::Ref<Eigen::Matrix3Xd> torque) const {
  threads_->run(static_cast<int>(joint_chunks_.size()), [&](int part, int) {
    const JointChunk& of = joint_chunks_[part];
    of.kind->reactions(of.joints, of.kind->rows, of.kind->holds_point, at.D.data(), q.data(), lambda.data(),
                       force.data(), torque.data());
  });
  for (const CompiledSpecialJoint& it : special_joints_) {
    const auto [F, T] = special_reaction(it, at, q, lambda);
    force.col(it.joint) = F;
    torque.col(it.joint) = T;
  }
}

std::pair<Vec3<double>, Vec3<double>> System::special_reaction(const CompiledSpecialJoint& of, const Evaluation& at,
                                                               const ConstVector& q, const ConstVector& lambda) const {
  const Element& element = model_.joints()[of.joint];
  const std::vector<int>& bodies = of.special->bodies();
  const auto place = std::find(bodies.begin(), bodies.end(), element.j) - bodies.begin();
  const BlockOfD D(at.D.data() + of.D + velocity_size * of.rows * place, of.rows, velocity_size);
  const Eigen::Matrix<double, velocity_size, 1> sum = D.transpose() * lambda.segment(of.row, of.rows);
  const Vec3<double> F = sum.head<3>();
  if (element.j == ground) return {F, sum.tail<3>() - element.at.s_j.cross(F)};
  const Mat3<double> A = rotation_matrix<double>(q.segment<4>(position_size * element.j + 3));
  return {F, A * sum.tail<3>() - Vec3<double>(A * element.at.s_j).cross(F)};
}

Mat3<double> System::joint_frame(int joint, const ConstVector& q) const {
  const Element& element = model_.joints()[joint];
  if (element.i == ground) return element.at.C_i;
  return rotation_matrix<double>(q.segment<4>(position_size * element.i + 3)) * element.at.C_i;
}

}  // namespace linkwork
