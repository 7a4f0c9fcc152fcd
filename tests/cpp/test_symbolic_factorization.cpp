#include "linkwork/linear/block/symbolic_factorization.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "mechanisms.hpp"

using namespace support;
using linkwork::block::SymbolicFactorization;

TEST_CASE("open branches are eliminated leaf to root, each body once and before its parent") {
  Random random(81);
  const System system(random_tree(random, 30));
  const SymbolicFactorization symbolic(system);
  REQUIRE(symbolic.steps.size() == 30);
  CHECK(symbolic.fronts.empty());
  CHECK(symbolic.bodies.empty());
  std::set<int> done;
  for (const block::TreeStep& step : symbolic.steps) {
    CHECK(done.insert(step.body).second);
    CHECK(!done.count(step.parent));
    CHECK(step.row == system.model().joint_rows()[step.body]);  // random_tree adds joint k with body k
  }
}

namespace {

/// Rows of constraints of fronts, and of hinges that bodies are eliminated with.
std::multiset<int> eliminated_rows(const SymbolicFactorization& symbolic) {
  std::multiset<int> out;
  for (const block::Front& front : symbolic.fronts)
    for (int k = 0; k < front.width; ++k) out.insert(symbolic.unknowns[front.unknown + k]);
  for (const block::CoreBody& body : symbolic.bodies)
    for (int k = 0; body.grounded() && k < block::ground_rows; ++k) out.insert(body.ground_row + k);
  return out;
}

}  // namespace

TEST_CASE("bodies of loops are eliminated into a front, with every row of their joints as an unknown once") {
  const System system(four_bar_with_tail());
  std::multiset<int> expected;
  for (int row = 0; row < 20; ++row) expected.insert(row);
  for (const bool grounded : {true, false}) {
    const SymbolicFactorization symbolic(system, {}, std::numeric_limits<int>::max(), {}, false, grounded);
    CHECK(symbolic.steps.size() == 2);
    CHECK(symbolic.bodies.size() == 3);
    CHECK(eliminated_rows(symbolic) == expected);
    CHECK(symbolic.grounded() == grounded);
    CHECK(symbolic.grounded_by(0) == grounded);  // crank and ground
    CHECK(!symbolic.grounded_by(5));
  }
}

TEST_CASE("bodies are eliminated with a hinge on the ground that is whole, and takes fewer operations") {
  const System system(four_bar());
  const auto count = [](const SymbolicFactorization& it) {
    return std::count_if(it.bodies.begin(), it.bodies.end(),
                         [](const block::CoreBody& body) { return body.grounded(); });
  };
  const SymbolicFactorization all(system), less(system, {17});
  CHECK(count(all) == 2);
  CHECK(count(less) == 1);
  const SymbolicFactorization as_others(system, {}, std::numeric_limits<int>::max(), {}, false, false);
  CHECK(all.flops < less.flops);
  CHECK(less.flops < as_others.flops);
}

TEST_CASE("dropped rows of loops take no part") {
  const System system(four_bar());
  const SymbolicFactorization all(system), less(system, {12, 13, 14});
  CHECK(eliminated_rows(all).size() == 20);
  CHECK(eliminated_rows(less).size() == 17);
  for (const int row : {12, 13, 14}) CHECK(eliminated_rows(less).count(row) == 0);
  CHECK(less.flops < all.flops);
}

TEST_CASE("fronts that live at the same time have contribution blocks apart") {
  Model model = four_bar();
  for (int k = 0; k < 12; ++k) {  // a net: each new body on two of those before it
    const int body = model.add_body("body" + std::to_string(k), body_at({0.3 * k, 2.0 + k, 0.1 * k * k}));
    join(model, "spherical", "p" + std::to_string(k), (2 * k) % (3 + k), body, {0.3 * k, 1.5 + k, 0.0});
    join(model, "spherical", "q" + std::to_string(k), (2 * k + 1) % (3 + k), body, {0.3 * k, 1.7 + k, 0.4});
  }
  const SymbolicFactorization symbolic((System(model)));
  const auto& fronts = symbolic.fronts;
  const auto size = [](const block::Front& it) { return std::ptrdiff_t{it.size - it.width} * it.contribution_rows; };
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    CHECK(fronts[f].contribution + size(fronts[f]) <= symbolic.contribution_size);
    if (fronts[f].parent < 0) continue;
    const block::Front& parent = fronts[fronts[f].parent];
    const bool apart = fronts[f].contribution + size(fronts[f]) <= parent.contribution ||
                       parent.contribution + size(parent) <= fronts[f].contribution;
    CHECK((apart || size(parent) == 0 || size(fronts[f]) == 0));
  }
}
