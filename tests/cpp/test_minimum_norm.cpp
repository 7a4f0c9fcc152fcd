#include "linkwork/constraints/minimum_norm.hpp"

#include "dense_algebra.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/formulation/formulation.hpp"
#include "support.hpp"

using namespace support;

TEST_CASE("multipliers of redundant rows are those of least weighted norm") {
  Random random(135);
  Model model = random_chain(random, 4, "revolute");
  model.add_joint("spherical", "within", 1, 2, model.joints()[2].at);
  Dynamics dynamics(model, {});
  VectorXd v_dot(dynamics.system().v_size()), lambda(dynamics.system().row_count());
  dynamics.evaluate(0.0, dynamics.initial_y());
  dynamics.accelerations(v_dot, lambda);
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const MatrixXd D = dense_D(system, at);
  const VectorXd root = mean_delassus_diagonal(system, at).cwiseSqrt();
  const MatrixXd weighted = D.transpose() * root.cwiseInverse().asDiagonal();  // D^T lambda = weighted (root lambda)
  const VectorXd force = D.transpose() * lambda;
  CHECK(relative_error(root.cwiseProduct(lambda), dense_least_norm(weighted, force, 1e-9)) < 1e-9);
}
