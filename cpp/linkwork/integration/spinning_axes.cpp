#include "linkwork/integration/spinning_axes.hpp"

#include <Eigen/QR>
#include <iterator>
#include <vector>

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

constexpr double alike = 1e-9;  // moments of inertia, and points of the axis

bool symmetric(const Mat3<double>& J, const Vec3<double>& axis) {
  const Mat3<double> along = axis * axis.transpose();
  const double about = axis.dot(J * axis), across = 0.5 * (J.trace() - about);
  return (J - about * along - across * (Mat3<double>::Identity() - along)).norm() <= alike * J.trace();
}

/// Bodies on which something but their weight acts, or which have a part in special joints.
std::vector<char> loaded(const System& system) {
  const Model& model = system.model();
  std::vector<char> out(static_cast<std::size_t>(system.body_count()), !model.user_forces().empty());
  const auto load = [&](int body) {
    if (body != ground) out[static_cast<std::size_t>(body)] = 1;
  };
  for (const Element& force : model.forces()) {
    load(force.i);
    load(force.j);
  }
  for (const JointForce& force : model.joint_forces()) {
    load(force.i);
    load(force.j);
  }
  for (const ConstraintBlock& block : system.blocks())
    if (model.special_joint(block.joint)) load(block.body);
  return out;
}

template <class See>
void each_rotor(const MatrixXd& Omega, See see) {
  for (Eigen::Index body = 0; body < Omega.cols(); ++body)
    if (!Omega.col(body).isZero(0.0)) see(body, Vec3<double>(Omega.col(body)));
}

void turn_forces(const MatrixXd& Omega, double time, MutableVector g) {
  each_rotor(Omega, [&](Eigen::Index body, const Vec3<double>& rate) {
    auto torque = g.segment<3>(velocity_size * body + 3);
    torque = rotation_matrix<double>(exponential(time * rate)) * Vec3<double>(torque);
  });
}

void turn_state(const MatrixXd& Omega, double time, VectorXd& y) {
  const Eigen::Index nq = position_size * Omega.cols();
  each_rotor(Omega, [&](Eigen::Index body, const Vec3<double>& rate) {
    auto p = y.segment<4>(position_size * body + 3);
    auto omega = y.segment<3>(nq + velocity_size * body + 3);
    p = quaternion_product<double>(p, exponential(-time * rate));
    omega = rotation_matrix<double>(exponential(time * rate)) * Vec3<double>(omega);
  });
}

}  // namespace

Eigen::Matrix3Xd rotor_axes(const System& system) {
  const Model& model = system.model();
  const int hinge = joint_kind_index("revolute"), sleeve = joint_kind_index("cylindrical");
  const std::vector<char> excluded = loaded(system);
  Eigen::Matrix3Xd axes = Eigen::Matrix3Xd::Zero(3, system.body_count());
  for (int body = 0; body < system.body_count(); ++body) {
    const BlockRange blocks = system.body_blocks(body);
    if (std::distance(blocks.begin(), blocks.end()) != 1 || excluded[static_cast<std::size_t>(body)]) continue;
    const Element& joint = model.joints()[system.blocks()[*blocks.begin()].joint];
    if (joint.kind != hinge && joint.kind != sleeve) continue;
    const Vec3<double> axis = joint.i == body ? joint.at.z_i() : joint.at.z_j();
    const Vec3<double> point = joint.i == body ? joint.at.s_i : joint.at.s_j;
    if ((point - axis * axis.dot(point)).norm() <= alike * point.norm() &&
        symmetric(model.bodies()[body].inertia, axis))
      axes.col(body) = axis;
  }
  return axes;
}

void hold_rotor(const System& system, const Evaluation& at, int rotor, const VectorXd& v_dot, MutableVector lambda) {
  const ConstraintBlock& block = system.blocks()[*system.body_blocks(rotor).begin()];
  VectorXd momentum(system.v_size());
  system.multiply_mass(at, v_dot, momentum);
  const Eigen::Index first = velocity_size * static_cast<Eigen::Index>(rotor);
  const MatrixXd D = block_of(at, block);
  lambda.segment(block.row, block.rows) = D.transpose().colPivHouseholderQr().solve(
      momentum.segment(first, velocity_size) - at.g.segment(first, velocity_size));
}

SpinningAxes SpinningAxes::at_start(const Eigen::Matrix3Xd& axes, const ConstVector& v) {
  SpinningAxes out{MatrixXd::Zero(3, axes.cols())};
  for (Eigen::Index body = 0; body < axes.cols(); ++body)
    out.Omega.col(body) = axes.col(body) * axes.col(body).dot(v.segment<3>(velocity_size * body + 3));
  return out;
}

void SpinningAxes::see(double time, VectorXd& y) const { turn_state(Omega, time, y); }
void SpinningAxes::carry(double time, VectorXd& y) const { turn_state(Omega, -time, y); }

void SpinningAxes::see_rates(double time, const VectorXd& y, VectorXd& y_dot) const {
  const Eigen::Index nq = position_size * Omega.cols();
  each_rotor(Omega, [&](Eigen::Index body, const Vec3<double>& rate) {
    const Vec4<double> p = y.segment<4>(position_size * body + 3);
    const Vec3<double> omega = y.segment<3>(nq + velocity_size * body + 3);
    auto p_dot = y_dot.segment<4>(position_size * body + 3);
    auto omega_dot = y_dot.segment<3>(nq + velocity_size * body + 3);
    p_dot = quaternion_product<double>(p_dot - euler_parameter_rates<double>(p, rate), exponential(-time * rate));
    omega_dot = rotation_matrix<double>(exponential(time * rate)) * Vec3<double>(omega_dot + rate.cross(omega));
  });
}

void SpinningAxes::carry_accelerations(double time, const VectorXd& y, MutableVector v_dot) const {
  const Eigen::Index nq = position_size * Omega.cols();
  each_rotor(Omega, [&](Eigen::Index body, const Vec3<double>& rate) {
    const Vec3<double> omega = y.segment<3>(nq + velocity_size * body + 3);
    auto omega_dot = v_dot.segment<3>(velocity_size * body + 3);
    omega_dot = rotation_matrix<double>(exponential(-time * rate)) * Vec3<double>(omega_dot) - rate.cross(omega);
  });
}

void SpinningAxes::see_forces(double time, MutableVector g) const { turn_forces(Omega, time, g); }
void SpinningAxes::carry_forces(double time, MutableVector g) const { turn_forces(Omega, -time, g); }

}  // namespace linkwork
