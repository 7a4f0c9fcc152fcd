#include <doctest/doctest.h>

#include "linkwork/constraints/rank.hpp"
#include "linkwork/constraints/redundancy_watch.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

RedundancyExamination examine(const System& system, const VectorXd& q, const std::vector<int>& redundant) {
  const VectorXd history = system.initial_history();
  return examine_redundancy(system, {0.0, q, history}, redundant);
}

/// An evaluation at rest, with the rows taken out.
struct Watched {
  Watched(const System& system, const std::vector<int>& rows, const VectorXd& q)
      : dropped(system, rows), at(system.make_evaluation()), v(VectorXd::Zero(system.v_size())) {
    system.evaluate(0.0, q, v, system.initial_history(), at);
    dropped.take_out(at);
  }
  DroppedRows dropped;
  Evaluation at;
  VectorXd v;
};

}  // namespace

TEST_CASE("off the constraints by a little, the redundant rows of a loop stay as many as they are") {
  const System system(four_bar());
  const std::vector<int> redundant = examine_rank(system).redundant_rows;
  REQUIRE(redundant.size() == 3);
  Random random(200);
  for (const double part : {0.0, 1e-9, 1e-5, 1e-3}) {
    INFO(part);
    VectorXd q = system.model().initial_q();
    for (double& x : q) x += part * random.number();
    system.normalize(q);
    const RedundancyExamination found = examine(system, q, redundant);
    CHECK(found.consistent);
    CHECK(!found.contradicts);
    CHECK(!found.changed);
    CHECK(found.choice.size() == 3);
  }
}

TEST_CASE("rows that depended on the others in a dead center only are taken in again beside it") {
  const RankReport dead_center = examine_rank(System(four_bar(true)));
  REQUIRE(dead_center.redundant_rows.size() == 3);
  REQUIRE(dead_center.singular_rows.size() == 1);
  const System system(four_bar());
  std::vector<int> rows = dead_center.redundant_rows;
  rows.push_back(dead_center.singular_rows.front());
  const RedundancyExamination found = examine(system, system.model().initial_q(), rows);
  CHECK(found.consistent);
  CHECK(found.changed);
  CHECK(found.choice.size() == 3);
}

TEST_CASE("hinges that no pose satisfies are never taken for consistent, and contradict each other by name") {
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double off : {1e-6, 1e-4, 1e-3, 1e-2}) {
      INFO(size, " ", off);
      const std::vector<int> redundant = examine_rank(System(door(size, {0, 0, 0}))).redundant_rows;
      REQUIRE(redundant.size() == 5);
      const System system(door(size, {0, 0, off}));
      const RedundancyExamination found = examine(system, system.model().initial_q(), redundant);
      CHECK(!found.consistent);
      CHECK(!found.changed);
      if (off <= 1e-4) CHECK(found.joints == std::vector<int>{0, 1});  // else the nearest pose may be too far
    }
}

TEST_CASE("what a dropped row is off while the others hold is noticed in parts of the size, however small that is") {
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double off : {0.0, 1e-10, 1e-7, 1e-4}) {
      INFO(size, " ", off);
      const std::vector<int> redundant = examine_rank(System(door(size, {0, 0, 0}))).redundant_rows;
      const System system(door(size, {0, 0, off}));
      const VectorXd q = system.model().initial_q();
      RedundancyWatch watch(system, q);
      const Watched state(system, redundant, q);
      CHECK(watch.suspicious(system, state.at, state.dropped, state.v) == (off > 1e-8));
      if (off <= 1e-8) continue;
      CHECK(watch.excess().position == doctest::Approx(off).epsilon(0.01));
      watch.suspect_less();
      CHECK(!watch.suspicious(system, state.at, state.dropped, state.v));
      const System worse(door(size, {0, 0, 4.0 * off}));
      const Watched later(worse, redundant, q);
      CHECK(watch.suspicious(worse, later.at, later.dropped, later.v));
    }
}

TEST_CASE("drift of the rows that are kept explains as much of the others") {
  const System system(four_bar());
  const std::vector<int> redundant = examine_rank(system).redundant_rows;
  Random random(201);
  for (const double drift : {1e-7, 1e-5, 1e-3}) {
    VectorXd q = system.model().initial_q();
    RedundancyWatch watch(system, q);
    for (double& x : q) x += drift * random.number();
    system.normalize(q);
    const Watched state(system, redundant, q);
    CHECK(!watch.suspicious(system, state.at, state.dropped, state.v));
  }
}

TEST_CASE("a velocity that only a dropped row resists is noticed") {
  const System aligned(door(1.0, {0, 0, 0}));
  const std::vector<int> redundant = examine_rank(aligned).redundant_rows;
  // hinges about parallel axes, 1e-5 apart, do not turn together, though each holds in the pose
  Model model = door(1.0, {0, 0, 0});
  std::vector<Element> joints = model.joints();
  Model apart;
  apart.add_body("door", model.bodies().front());
  joints[1].at.s_i[0] += 1e-5;
  joints[1].at.s_j[0] += 1e-5;
  for (const Element& joint : joints)
    apart.add_joint("revolute", "hinge " + std::to_string(apart.joints().size()), joint.i, joint.j, joint.at);
  for (const auto& [model_of, expected] : {std::pair{&model, false}, {&apart, true}}) {
    const System system(*model_of);
    const VectorXd q = system.model().initial_q();
    RedundancyWatch watch(system, q);
    Watched state(system, redundant, q);
    state.dropped.put_back(state.at);
    state.v << 0.0, 0.5, 0.0, 0.0, 0.0, 1.0;  // turns about the lower hinge
    system.evaluate(0.0, q, state.v, system.initial_history(), state.at);
    state.dropped.take_out(state.at);
    CHECK(watch.suspicious(system, state.at, state.dropped, state.v) == expected);
  }
}
