#include "linkwork/constraints/closed_loops.hpp"

#include "linkwork/constraints/length_scale.hpp"
#include "mechanisms.hpp"

using namespace support;

TEST_CASE("the rows of closed loops are those of joints that no pruning takes off") {
  const System system(four_bar_with_tail());
  const ClosedLoops loops(system, evaluate_initially(system), 1e-9);
  REQUIRE(loops.row_count() == 20);
  for (int k = 0; k < 20; ++k) CHECK(loops.rows()[k] == k);  // the hinges were added first
  CHECK(loops.component_count() == 1);
  for (int body = 0; body < 3; ++body) CHECK(loops.component_of_body(body) == 0);
  for (int body = 3; body < 5; ++body) CHECK(loops.component_of_body(body) == -1);
}

TEST_CASE("an open chain has no loops") {
  Random random(5);
  const System system(random_chain(random, 6, "universal"));
  CHECK(ClosedLoops(system, evaluate_initially(system), 1e-9).row_count() == 0);
}

TEST_CASE("loops that share no body are components of their own") {
  Model model = four_bar();
  model.add_body("plate", body_at({0, 0, 5}));
  join(model, "spherical", "low", ground, 3, {0, 0, 4});
  join(model, "spherical", "high", ground, 3, {0, 0, 6});
  const System system(model);
  const ClosedLoops loops(system, evaluate_initially(system), 1e-9);
  CHECK(loops.component_count() == 2);
  CHECK(loops.component_of_body(0) == loops.component_of_body(2));
  CHECK(loops.component_of_body(0) != loops.component_of_body(3));
}

TEST_CASE("one joint of a single loop closes it, and its loop is all of them") {
  const System system(four_bar());
  const ClosedLoops loops(system, evaluate_initially(system), 1e-9);
  std::vector<int> closing;
  for (int joint = 0; joint < 4; ++joint)
    if (loops.closing(joint)) closing.push_back(joint);
  REQUIRE(closing.size() == 1);
  std::vector<int> loop = loops.loop_of(closing.front(), 10);
  std::sort(loop.begin(), loop.end());
  CHECK(loop == std::vector<int>{0, 1, 2, 3});
  CHECK(loops.loop_of(closing.front(), 3).empty());
}

TEST_CASE("scaled D has rows of unit length in velocities of natural size") {
  const System system(four_bar_with_tail());
  const Evaluation at = evaluate_initially(system);
  const ClosedLoops loops(system, at, 1e-9);
  VectorXd lengths;
  const MatrixXd scaled = loops.scaled_D(at, &lengths);
  MatrixXd expected = dense_D(system, at).topRows(20) * velocity_scale(system).asDiagonal();
  for (int row = 0; row < 20; ++row) {
    CHECK(lengths[row] == doctest::Approx(expected.row(row).norm()).epsilon(1e-14));
    expected.row(row) /= expected.row(row).norm();
  }
  CHECK(relative_error(scaled, expected) < 1e-14);
}
