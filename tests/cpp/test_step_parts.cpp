#include "linkwork/integration/step_parts.hpp"

#include "support.hpp"

using namespace support;

namespace {

constexpr double t = 0.3, h = 1e-3;

/// Nothing of the step is left out, however many parts there are.
void check_whole(const std::vector<StepSpan>& parts) {
  CHECK(parts.front().t == t);
  double sum = 0.0;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    sum += parts[k].h;
    if (k > 0) CHECK(parts[k].t == doctest::Approx(parts[k - 1].t + parts[k - 1].h).epsilon(1e-15));
    CHECK(parts[k].h > 0.0);
  }
  CHECK(sum == doctest::Approx(h).epsilon(1e-12));
}

}  // namespace

TEST_CASE("a step without breaks is divided by its share") {
  StepParts parts({0.1, 0.5}, golden_share);
  std::vector<StepSpan> two = parts.of(t, h);
  REQUIRE(two.size() == 2);
  check_whole(two);
  CHECK(two[0].h == golden_share * h);
  CHECK(two[0].at(0.0) == t);
  parts.divide(3);
  CHECK(parts.of(t, h).size() == 8);
  check_whole(parts.of(t, h));
  CHECK(StepParts({}, 1.0).of(t, h).size() == 1);
}

TEST_CASE("parts end at breaks and see their own side of them, without a gap") {
  const double at = t + 0.4 * h;
  const std::vector<StepSpan> parts = StepParts({at}, 1.0).of(t, h);
  REQUIRE(parts.size() == 2);
  check_whole(parts);
  CHECK(parts[0].at(1.0) < at);
  CHECK(parts[1].at(0.0) > at);
  CHECK(parts[1].at(0.0) - parts[0].at(1.0) < 1e-15);
  CHECK(StepParts({at, t + 0.5 * h}, golden_share).of(t, h).size() == 6);
}

TEST_CASE("breaks at the ends of a step, or as near as a run takes them to be there, divide nothing") {
  for (const double off : {0.0, 1e-10 * h, -1e-10 * h, 1e-15, -1e-15}) {
    const StepParts ends({t + off, t + h + off}, 1.0);
    const std::vector<StepSpan> parts = ends.of(t, h);
    REQUIRE(parts.size() == 1);
    check_whole(parts);
    CHECK(parts[0].at(0.0) > t + off);
    CHECK(parts[0].at(1.0) < t + h + off);
    const StepSpan whole = ends.whole(t, h);
    CHECK(whole.at(0.0) == parts[0].at(0.0));
    CHECK(whole.at(1.0) == parts[0].at(1.0));
  }
}
