#include "linkwork/integration/touch_search.hpp"

#include "integrators.hpp"
#include "linkwork/integration/hermite_step.hpp"

using namespace support;

namespace {

constexpr double radius = 0.01;

/// Of one step over 10 m, far longer than the spheres take to pass.
std::vector<TouchSearch::Touch> touches(double beside) {
  Dynamics dynamics(two_balls(10.0, {5, beside, 0}), {});
  TouchSearch search(dynamics, 1e-12);
  const VectorXd y = dynamics.initial_y();
  VectorXd y_new = y;
  y_new[0] = 10.0;
  dynamics.evaluate(0.0, y);
  search.begin(y);
  dynamics.evaluate(1.0, y_new);
  if (!search.suspects(0.0, 1.0, y_new)) return {};
  return search.find(HermiteStep(dynamics.system(), y, y_new, 1.0), 0.0, 1.0);
}

}  // namespace

TEST_CASE("spheres that meet in the middle of a step have touched there, head-on or barely") {
  for (const double beside : {0.0, 0.5 * radius, 1.9 * radius, 1.999 * radius}) {
    CAPTURE(beside);
    const auto found = touches(beside);
    REQUIRE(found.size() == 1);
    CHECK(found[0].which == 0);
    CHECK(std::abs(10.0 * found[0].theta - 5.0) < 2.0 * radius);
  }
}

TEST_CASE("spheres that pass each other have not") {
  for (const double beside : {2.0001 * radius, 2.1 * radius, 1.0, 100.0}) {
    CAPTURE(beside);
    CHECK(touches(beside).empty());
  }
}
