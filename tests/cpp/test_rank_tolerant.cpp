#include "linkwork/formulation/rank_tolerant.hpp"

#include "linkwork/constraints/regularized_inertia.hpp"
#include "mechanisms.hpp"

using namespace support;

TEST_CASE("in a singular pose the equations are satisfied by multipliers of an independent part of the rows") {
  for (const double theta : {0.0, 1e-9, 0.3}) {
    const Model model = parallelogram(theta);
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    const RegularizedInertia inertia(system, at);
    RankTolerant solver(system, inertia);
    solver.factorize(at);
    const VectorXd a = at.g.head(system.v_size());
    VectorXd v_dot(system.v_size()), lambda(system.row_count());
    solver.solve(a, VectorXd::Zero(system.row_count()), v_dot, lambda);
    const MatrixXd D = dense_D(system, at);
    CHECK(relative_error(dense_M(model) * v_dot - D.transpose() * lambda, a) < 1e-12);
    CHECK((D * v_dot).cwiseAbs().maxCoeff() < 1e-8);
    CHECK((lambda.array() == 0.0).count() >= (theta == 0.3 ? 3 : 4));  // one more row depends in line
  }
}
