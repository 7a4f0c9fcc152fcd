#include "linkwork/linear/block/eliminated_rows.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <set>

#include "linkwork/linear/block/symbolic_factorization.hpp"
#include "mechanisms.hpp"

using namespace support;
using linkwork::block::EliminatedRows;
using linkwork::block::SymbolicFactorization;

namespace {

/// Three links on hinges about changing axes.
Model arm() {
  Random random(41);
  Model model;
  for (int k = 0; k < 3; ++k) {
    model.add_body("link " + std::to_string(k), random_body(random));
    add_joint(model, random, "revolute", "hinge " + std::to_string(k), k - 1, k);
  }
  return model;
}

/// So many inerters between two bodies.
void add_inerters(Model& model, int count, int i, int j) {
  Random random(42);
  for (int k = 0; k < count; ++k)
    model.add_force("inerter", "inerter " + std::to_string(model.forces().size()), i, j, random_attachment(random),
                    {{0.5, -1}});
}

/// What a solver eliminates of a model with its inerters.
struct Eliminated {
  explicit Eliminated(const Model& model, const std::vector<int>& dropped = {})
      : system(Inerters::as_joints(model)),
        rows(system, dropped, model.row_count()),
        symbolic(system, dropped, model.row_count()) {}
  System system;
  EliminatedRows rows;
  SymbolicFactorization symbolic;
};

}  // namespace

TEST_CASE("inerters are attached to the joint between the same bodies, the order of these aside") {
  Model model = arm();
  add_inerters(model, 1, 2, 1);
  add_inerters(model, 1, ground, 0);
  add_inerters(model, 1, 0, 2);  // there is no joint
  const Eliminated found(model);
  CHECK(found.rows.host(3) == 2);
  CHECK(found.rows.host(4) == 0);
  CHECK(found.rows.host(5) == 5);
  CHECK(!found.rows.is_attached(5));
  CHECK(found.rows.next(2) == 3);
  CHECK(found.rows.count(2) == 6);
  CHECK(found.rows.count(3) == 0);
}

TEST_CASE("trees with an inerter beside each joint are eliminated as trees") {
  Model model = arm();
  for (int k = 0; k < 3; ++k) add_inerters(model, 1, k - 1, k);
  const Eliminated found(model);
  CHECK(found.symbolic.fronts.empty());
  REQUIRE(found.symbolic.steps.size() == 3);
  for (const block::TreeStep& step : found.symbolic.steps) {
    CHECK(step.rows == 6);
    REQUIRE(step.scattered >= 0);
    for (int k = 0; k < 6; ++k)  // the hinge's first
      CHECK(found.symbolic.step_rows[step.scattered + k].row == (k < 5 ? step.row + k : 15 + step.body));
  }
  const SymbolicFactorization apart(found.system, {}, std::numeric_limits<int>::max(), {}, false, false);
  CHECK(apart.fronts.size() > 0);
  CHECK(found.symbolic.flops < 0.8 * apart.flops);
}

TEST_CASE("more than six rows have no place on a branch, and close a loop") {
  Model model = arm();
  add_inerters(model, 3, 1, 2);
  const Eliminated found(model);
  CHECK(found.rows.host(3) == 2);
  CHECK(found.rows.host(4) == 4);  // the fifth row beside a hinge begins a joint of its own, ...
  CHECK(found.rows.host(5) == 4);  // ... which takes the next
  CHECK(found.symbolic.steps.size() < 3);
  CHECK(found.symbolic.fronts.size() > 0);
}

TEST_CASE("inerters between free bodies are joints of theirs, several of them one") {
  Model model;
  for (int k = 0; k < 2; ++k) model.add_body("body " + std::to_string(k), body_at({1.0 * k, 0, 0}));
  add_inerters(model, 4, 0, 1);
  const Eliminated found(model);
  CHECK(found.symbolic.fronts.empty());
  CHECK(found.rows.count(0) == 4);
}

TEST_CASE("in loops a joint and its inerters are eliminated as one, each row once") {
  Model model = four_bar();
  add_inerters(model, 1, 0, 1);
  const Eliminated found(model, {12, 13, 14});
  const SymbolicFactorization apart(found.system, {12, 13, 14});
  CHECK(found.symbolic.flops <= apart.flops);
  std::multiset<int> unknowns, expected{20};
  for (const block::Front& front : found.symbolic.fronts)
    for (int k = 0; k < front.width; ++k) unknowns.insert(found.symbolic.unknowns[front.unknown + k]);
  for (const block::CoreBody& body : found.symbolic.bodies)
    for (int k = 0; body.grounded() && k < block::ground_rows; ++k) unknowns.insert(body.ground_row + k);
  for (int row = 0; row < 20; ++row)
    if (row < 12 || row > 14) expected.insert(row);
  CHECK(unknowns == expected);
}

TEST_CASE("joints of which all rows are dropped take none") {
  Model model = four_bar();
  add_inerters(model, 1, ground, 2);
  const Eliminated found(model, {15, 16, 17, 18, 19});
  CHECK(found.rows.host(4) == 4);
  CHECK(found.rows.count(3) == 0);
}

TEST_CASE("without compliance nothing is attached") {
  Model model = arm();
  Random random(43);
  add_joint(model, random, "distance", "rod", 0, 1);
  const System system(model);
  const EliminatedRows rows(system, {}, std::numeric_limits<int>::max());
  for (int joint = 0; joint < system.joint_count(); ++joint) CHECK(!rows.is_attached(joint));
}
