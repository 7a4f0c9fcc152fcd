#include "linkwork/formulation/watched_formulation.hpp"

#include "linkwork/formulation/dynamics.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

struct Solved {
  VectorXd v_dot, lambda;
};

Solved solve(Dynamics& dynamics) {
  Solved out{VectorXd(dynamics.system().v_size()), VectorXd(dynamics.system().row_count())};
  dynamics.accelerations(out.v_dot, out.lambda);
  return out;
}

}  // namespace

TEST_CASE("the rank-revealing fallback gives the accelerations and multipliers of the usual factorization") {
  Dynamics dynamics(four_bar_with_tail(), {});
  dynamics.evaluate(0.0, dynamics.initial_y());
  const Solved usual = solve(dynamics);
  CHECK(!dynamics.formulation().fallback());
  dynamics.formulation().fall_back();
  CHECK(dynamics.formulation().fallback());
  const Solved other = solve(dynamics);
  CHECK(relative_error(other.v_dot, usual.v_dot) < 1e-10);
  CHECK(relative_error(other.lambda, usual.lambda) < 1e-8);
  dynamics.evaluate(0.0, dynamics.initial_y());
  CHECK(!dynamics.formulation().fallback());  // of one evaluation
}

TEST_CASE("which redundant rows are left out does not matter to motion and reactions") {
  Dynamics dynamics(four_bar_with_tail(), {});
  dynamics.evaluate(0.0, dynamics.initial_y());
  const Solved before = solve(dynamics);
  std::vector<int> others = {2, 3, 4};  // z and the rotations of the first hinge
  REQUIRE(dynamics.dropped().rows() != others);
  dynamics.formulation().change_redundant_rows(others, {0});
  CHECK(dynamics.dropped().rows() == others);
  dynamics.evaluate(0.0, dynamics.initial_y());
  const Solved after = solve(dynamics);
  CHECK(relative_error(after.v_dot, before.v_dot) < 1e-10);
  CHECK(relative_error(after.lambda, before.lambda) < 1e-8);
  CHECK(dynamics.watch().row_changes() == 1);
}

TEST_CASE("right-hand sides of rows that are left out do not matter") {
  Dynamics dynamics(four_bar(), {});
  const System& system = dynamics.system();
  dynamics.evaluate(0.0, dynamics.initial_y());
  dynamics.factorize();  // ahead: it is fused with the first solution otherwise
  const VectorXd a = dynamics.evaluation().g.head(system.v_size());
  VectorXd b = VectorXd::Zero(system.row_count()), x(a.size()), other(a.size()), lambda(b.size());
  dynamics.solve(a, b, x, lambda);
  for (const int row : dynamics.dropped().rows()) b[row] = 1e3;
  dynamics.solve(a, b, other, lambda);
  CHECK((x - other).norm() == 0.0);
}
