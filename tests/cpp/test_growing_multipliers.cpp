#include "linkwork/integration/growing_multipliers.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace linkwork;

namespace {

const std::vector<double> places = {0.2, -0.25, 0.45, -0.5, 0.7, -0.8};  // the first one is next to the poses

VectorXd smooth(double t) { return (VectorXd(3) << 2.0 + t, 1.0 - t * t, 0.5 * t).finished(); }

/// Two of them grow toward each pose.
VectorXd growing(double t, const std::vector<double>& poses) {
  VectorXd sum = smooth(t);
  for (const double pose : poses) sum += VectorXd((VectorXd(3) << 3.0, 0.0, -1.0).finished() / (t - pose));
  return sum;
}

std::optional<VectorXd> found(const std::vector<double>& poses, double at) {
  std::vector<VectorXd> multipliers;
  for (const double place : places) multipliers.push_back(growing(place, poses));
  return growing_multipliers(places, multipliers, poses, 1e-6, at);
}

}  // namespace

TEST_CASE("multipliers that grow toward one pose or two are met beside them") {
  for (const std::vector<double>& poses : {std::vector<double>{0.03}, std::vector<double>{-0.06, 0.05}})
    for (const double at : {-0.3, -0.01, 0.0299, 0.04, 0.1}) {
      const std::optional<VectorXd> multipliers = found(poses, at);
      REQUIRE(multipliers);
      CHECK((*multipliers - growing(at, poses)).norm() < 1e-9 * growing(at, poses).norm());
    }
}

TEST_CASE("in the pose those that are finite are what they are") {
  const double pose = 0.03;
  const std::optional<VectorXd> multipliers = found({pose}, pose);
  REQUIRE(multipliers);
  CHECK((*multipliers)[1] == doctest::Approx(smooth(pose)[1]).epsilon(1e-9));
  CHECK(std::abs((*multipliers)[0]) > 1e6);
}

TEST_CASE("what is smooth is not taken for such that grows") {
  std::vector<VectorXd> multipliers;
  for (const double place : places) multipliers.push_back(smooth(place));
  CHECK(!growing_multipliers(places, multipliers, {0.03}, 1e-6, 0.1));
  CHECK(!growing_multipliers(places, multipliers, {}, 1e-6, 0.1));
}
