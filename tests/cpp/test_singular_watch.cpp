#include <doctest/doctest.h>

#include "dense_algebra.hpp"
#include "linkwork/constraints/rank.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/formulation/singular_watch.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

/// Smallest singular value of D without some rows, relative to the largest.
double condition(const System& system, const std::vector<int>& without) {
  const MatrixXd D = dense_D(system, evaluate_initially(system));
  MatrixXd kept(D.rows() - static_cast<Eigen::Index>(without.size()), D.cols());
  Eigen::Index next = 0;
  for (int row = 0; row < D.rows(); ++row)
    if (!std::binary_search(without.begin(), without.end(), row)) kept.row(next++) = D.row(row);
  const VectorXd sigma = singular_values(kept);
  return sigma.tail<1>()[0] / sigma[0];
}

}  // namespace

TEST_CASE("redundant rows that are well chosen need no other choice") {
  const System system(four_bar());
  const RankReport report = examine_rank(system);
  REQUIRE(report.redundant_rows.size() == 3);
  const PoseExamination found =
      examine_pose(system, {0.0, report.q, system.initial_history()}, report.redundant_rows, 1e-6);
  CHECK(found.rows.empty());
  CHECK(found.better_choice.empty());
}

TEST_CASE("wrong redundant rows are told apart from a singular pose, and better ones found") {
  const Model model = four_bar();
  const System system(model);
  const std::vector<int> wrong = {0, 1, 2};  // the place of hinge A: no other row of the planar loop fixes it
  REQUIRE(condition(system, wrong) < 1e-12);
  const VectorXd q = model.initial_q();
  const PoseExamination found = examine_pose(system, {0.0, q, system.initial_history()}, wrong, 1e-6);
  CHECK_FALSE(found.rows.empty());
  CHECK_FALSE(found.joints.empty());
  REQUIRE(found.better_choice.size() == 3);
  CHECK(condition(system, found.better_choice) > 1e-3);
}

TEST_CASE("pivots are compared with the largest of the run") {
  SingularWatch watch;
  CHECK(watch.doubts_first(1e-12));
  CHECK_FALSE(watch.doubts_first(1e-3));
  CHECK(watch.usual(1e-12));  // a long chain: its own level
  CHECK_FALSE(watch.doubts_first(1e-12));
  CHECK(watch.usual(1e-13));
  CHECK_FALSE(watch.usual(1e-18));
  watch.suspect_less();
  CHECK(watch.usual(1e-18));
  CHECK(watch.usual(0.5));
  CHECK_FALSE(watch.usual(1e-18));
  CHECK(watch.untrustworthy(1e-11));
}

TEST_CASE("suspicion lasts until the pivots have recovered; poses are listed with what led up to them") {
  SingularWatch watch;
  watch.list_evaluations(false);
  CHECK(watch.usual(1.0));
  CHECK_FALSE(watch.usual(1e-6));
  watch.begin(1.0, 1e-6, {3});
  for (const double pivot : {1e-7, 1e-6, 1e-5}) {
    CHECK_FALSE(watch.usual(pivot));
    watch.go_on(pivot);
    CHECK(watch.open());
  }
  watch.count_fallback();
  watch.count_fallback();
  watch.go_on(0.1);
  CHECK_FALSE(watch.open());
  CHECK(watch.usual(0.1));
  CHECK(watch.crossings().empty());
  watch.cross(1.1, 1e-7, {3});
  watch.cross(2.1, 0.0, {3});
  REQUIRE(watch.crossings().size() == 2);
  CHECK(watch.crossings()[0].t == 1.1);
  CHECK(watch.crossings()[0].pivot == doctest::Approx(1e-7));
  CHECK(watch.crossings()[0].fallback_evaluations == 2);
  CHECK(watch.crossings()[1].fallback_evaluations == 0);
  CHECK(watch.singular_poses() == 2);
  watch.list_evaluations(true);
  watch.begin(3.0, 1e-7, {3});
  watch.count_fallback();
  REQUIRE(watch.crossings().size() == 3);
  CHECK(watch.crossings()[2].fallback_evaluations == 1);
}

TEST_CASE("the latest value is that of the trend, and there is neither after one value alone") {
  SingularWatch watch;
  watch.note(0.0, 0.04);
  CHECK(watch.latest() == nullptr);
  CHECK_FALSE(watch.trend());
  for (int k = 1; k < 40; ++k) {
    watch.note(0.1 * k, 1.0 / k);
    REQUIRE(watch.latest() != nullptr);
    CHECK(watch.latest()->t == watch.trend()->last.t);
    CHECK(watch.latest()->root == doctest::Approx(std::sqrt(1.0 / k)));
  }
  watch.forget_trend();
  CHECK(watch.latest() == nullptr);
}

TEST_CASE("usual pivots in their range change nothing of what is usual") {
  SingularWatch watch;
  watch.start(0.5);
  const SingularWatch::Range range = watch.usual_pivots();
  for (const double pivot : {range.least, 0.1, range.most}) {
    CHECK(watch.usual(pivot));
    CHECK(watch.usual_pivots().least == range.least);
    CHECK(watch.usual_pivots().most == range.most);
  }
  CHECK_FALSE(watch.usual(std::nextafter(range.least, 0.0)));
  CHECK(watch.usual(std::nextafter(range.most, 1.0)));
  CHECK(watch.usual_pivots().most > range.most);
  watch.begin(1.0, 1e-9, {0});
  CHECK(watch.usual_pivots().least > watch.usual_pivots().most);  // none is while rows are near each other
}
