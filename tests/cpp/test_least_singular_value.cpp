#include "linkwork/constraints/least_singular_value.hpp"

#include "dense_algebra.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "mechanisms.hpp"

using namespace support;

namespace {

/// By iterations that go on from one to the next.
double least(Dynamics& dynamics) {
  double value = 0.0;
  for (int k = 0; k < 4; ++k) value = dynamics.formulation().least_singular_value();
  return value;
}

}  // namespace

TEST_CASE("it is the least singular value of scale^-1 D M^-1/2, the scale that of the rows at the start") {
  Random random(150);
  const Model model = random_chain(random, 5, "universal");
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  const MatrixXd D = dense_D(system, at), S = dense_delassus(dense_M(model), D);
  const VectorXd scale = mean_delassus_diagonal(system, at).cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * S * scale.asDiagonal();
  const double expected = std::sqrt(singular_values(scaled).tail<1>()[0]);
  Dynamics dynamics(model, options_of("standard"));
  dynamics.evaluate(0.0, dynamics.initial_y());
  for (int k = 0; k < 20; ++k) least(dynamics);
  CHECK(least(dynamics) == doctest::Approx(expected).epsilon(1e-3));
}

TEST_CASE("the least singular value falls linearly to zero toward a singular pose, whatever the formulation") {
  for (const char* formulation : {"standard", "penalty", "augmented_lagrangian"}) {
    std::vector<double> values;
    for (const double theta : {0.04, 0.02, 0.01}) {
      Dynamics dynamics(parallelogram(theta), options_of(formulation));
      dynamics.evaluate(0.0, dynamics.initial_y());
      values.push_back(least(dynamics));
    }
    CHECK(values[0] / values[1] == doctest::Approx(2.0).epsilon(0.05));
    CHECK(values[1] / values[2] == doctest::Approx(2.0).epsilon(0.05));
  }
}

TEST_CASE(
    "by somebody else's factors it is the same, and the watch hears of them as of its own; not of suspicious ones") {
  Dynamics own(parallelogram(0.3), options_of("standard")), other(parallelogram(0.3), options_of("standard"));
  const SaddleSolver& theirs = own.formulation().saddle();
  const VectorXd none = VectorXd::Zero(own.system().v_size());
  const auto solve = [&](const ConstVector& b, MutableVector x, MutableVector lambda) {
    own.formulation().saddle().solve(none, b, x, lambda);
  };
  other.begin_elsewhere(0.0, other.initial_y());
  CHECK_FALSE(other.formulation().least_singular_value(0.0, 0.0, solve));
  CHECK_FALSE(other.watch().latest());
  for (const double t : {0.0, 0.1, 0.2}) {
    own.evaluate(t, own.initial_y());
    const double expected = own.formulation().least_singular_value();
    const auto found = other.formulation().least_singular_value(t, theirs.smallest_pivot(), solve);
    REQUIRE(found);
    CHECK(*found == expected);
  }
  REQUIRE(other.watch().latest());
  CHECK(other.watch().latest()->t == own.watch().latest()->t);
  CHECK(other.watch().latest()->root == own.watch().latest()->root);
  CHECK(other.watch().root_of_level() == own.watch().root_of_level());
  CHECK(other.formulation().usual_least_singular_value() == own.formulation().usual_least_singular_value());
}
