#include "linkwork/assembly/joint_reactions.hpp"

#include "support.hpp"

using namespace support;

namespace {

constexpr int both = 9;  // joints of each kind between two bodies; as many on the ground first, and second

/// Joints of every kind, more than registers have lanes.
Model many_joints(Random& random) {
  Model model(random.vec3(9.81));
  for (int body = 0; body < 4; ++body) model.add_body("body " + std::to_string(body), random_body(random));
  for (const JointKind& kind : joint_kinds())
    for (int k = 0; k < 3 * both; ++k) {
      const int i = k % 3 == 1 ? ground : k % 4, j = k % 3 == 2 ? ground : (k + 1) % 4;
      add_joint(model, random, kind.info.name, kind.info.name + std::to_string(k), i, j);
    }
  return model;
}

struct Reactions {
  Eigen::Matrix3Xd force, torque;
};

Reactions reactions_of(const System& system, const Evaluation& at, const VectorXd& lambda) {
  Reactions out{Eigen::Matrix3Xd(3, system.joint_count()), Eigen::Matrix3Xd(3, system.joint_count())};
  system.reactions(at, system.model().initial_q(), lambda, out.force, out.torque);
  return out;
}

}  // namespace

TEST_CASE("reactions are D^T lambda of the second body, moved to the joint's point on it") {
  Random random(41);
  const Model model = many_joints(random);
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const VectorXd q = system.model().initial_q();
  const VectorXd lambda = random.vector(system.row_count());
  const Reactions found = reactions_of(system, at, lambda);
  for (int joint = 0; joint < system.joint_count(); ++joint) {
    const Element& element = model.joints()[joint];
    CAPTURE(model.joint_names().name(joint));
    const int body = element.j == ground ? element.i : element.j;
    const Vec3<double> r = q.segment<3>(7 * body), force = found.force.col(joint), torque = found.torque.col(joint);
    const Mat3<double> A = rotation_matrix<double>(q.segment<4>(7 * body + 3));
    const Vec3<double> point = element.j == ground ? element.at.s_j : Vec3<double>(r + A * element.at.s_j);
    Eigen::Matrix<double, 6, 1> expected = Eigen::Matrix<double, 6, 1>::Zero(), wrench;
    for (const int index : system.joint_blocks(joint)) {
      const ConstraintBlock& block = system.blocks()[index];
      if (block.body != body) continue;
      for (int row = 0; row < block.rows; ++row)
        expected += lambda[block.row + row] *
                    Eigen::Map<const Eigen::Matrix<double, 6, 1>>(at.D.data() + block.offset + 6 * row);
    }
    wrench << force, A.transpose() * (torque + (point - r).cross(force));
    if (element.j == ground) wrench = -wrench;
    CHECK((wrench - expected).norm() < 1e-14 * (1.0 + expected.norm()));
  }
}

TEST_CASE("reactions have the same bits by every instruction set") {
  Random random(42);
  const Model model = many_joints(random);
  const System system(model, instruction_set(0));
  const Evaluation at = evaluate_initially(system);
  const VectorXd lambda = random.vector(system.row_count());
  const Reactions expected = reactions_of(system, at, lambda);
  for (int level = 1; level < instruction_set_count(); ++level) {
    const Reactions found = reactions_of(System(model, instruction_set(level)), at, lambda);
    CHECK(found.force == expected.force);
    CHECK(found.torque == expected.torque);
  }
}

TEST_CASE("reactions of few joints of a kind have the bits that they have among many") {
  Random random(43);
  const Model model = many_joints(random);
  const System system(model);
  const VectorXd lambda = random.vector(system.row_count());
  const Reactions among_many = reactions_of(system, evaluate_initially(system), lambda);
  for (int first = 0; first < system.joint_count(); first += 3 * both)
    for (const int count : {1, 2, 3}) {
      Model few(model.gravity());
      for (std::size_t body = 0; body < model.bodies().size(); ++body)
        few.add_body("body " + std::to_string(body), model.bodies()[body]);
      for (int joint = first; joint < first + count; ++joint) {
        const Element& it = model.joints()[joint];
        const KindInfo& info = joint_kinds()[it.kind].info;
        const auto parameters = model.joint_parameters().begin() + static_cast<std::ptrdiff_t>(it.first_parameter);
        few.add_joint(info.name, std::to_string(joint), it.i, it.j, it.at,
                      {parameters, parameters + static_cast<std::ptrdiff_t>(info.parameters.size())});
      }
      const System alone(few);
      const VectorXd its = lambda.segment(model.joint_rows()[first], alone.row_count());
      const Reactions found = reactions_of(alone, evaluate_initially(alone), its);
      CHECK(found.force == among_many.force.middleCols(first, count));
      CHECK(found.torque == among_many.torque.middleCols(first, count));
    }
}
