#include "linkwork/integration/collocation_step.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

/// Angle of the crank of a parallelogram at y.
double crank(const VectorXd& y) { return 2 * std::atan2(y[6], y[3]); }

double violation(Dynamics& dynamics, double t, const VectorXd& y) {
  dynamics.evaluate(t, y);
  return std::max(dynamics.evaluation().Phi.cwiseAbs().maxCoeff(), dynamics.evaluation().Phi_dot.cwiseAbs().maxCoeff());
}

}  // namespace

TEST_CASE("one step is what two halves of it are, and stands on the constraints throughout") {
  Dynamics dynamics(parallelogram(0.6, 1.0), {});
  CollocationStep step(dynamics, 1.0);
  const Unwatched unwatched(dynamics);
  const double h = 0.1;
  REQUIRE(step.begin(0.0, dynamics.initial_y(), true));
  const CollocationStep::Quality quality = step.attempt(h);
  CHECK(quality.good());
  CHECK(quality.energy < 1e-13);
  const VectorXd whole = step.leap().y_new;
  VectorXd middle;
  step.state_at(0.5 * h, middle);
  CHECK(violation(dynamics, 0.5 * h, middle) < 1e-11);
  REQUIRE(step.begin(0.0, dynamics.initial_y(), true));
  REQUIRE(step.attempt(0.5 * h).good());
  CHECK((step.leap().y_new - middle).cwiseAbs().maxCoeff() < 1e-11);
  REQUIRE(step.begin(0.5 * h, VectorXd(step.leap().y_new), true));
  REQUIRE(step.attempt(0.5 * h).good());
  CHECK((step.leap().y_new - whole).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(violation(dynamics, h, whole) < 1e-13);
}

TEST_CASE("a step goes over the line of a parallelogram on its branch, if no node is in it") {
  const double rate = 2.0, from = -0.05;
  Dynamics dynamics(parallelogram(from, rate), {});
  const Unwatched unwatched(dynamics);
  CollocationStep step(dynamics, 1.0);
  REQUIRE(step.begin(0.0, dynamics.initial_y(), true));
  REQUIRE(step.attempt(0.05).good());
  const VectorXd over = step.leap().y_new;
  CHECK(crank(over) > 0.03);
  REQUIRE(step.begin(0.05, over, true));
  REQUIRE(step.attempt(0.02).good());
  CHECK(step.size(step.leap().y_new.segment(21, 18)) == doctest::Approx(step.size(over.segment(21, 18))).epsilon(0.1));
}

TEST_CASE("accelerations inside are those of the equations there") {
  Dynamics dynamics(parallelogram(0.6, 1.0), {});
  const Unwatched unwatched(dynamics);
  CollocationStep step(dynamics, 1.0);
  REQUIRE(step.begin(0.0, dynamics.initial_y(), true));
  REQUIRE(step.attempt(0.05).good());
  const int nv = dynamics.system().v_size(), rows = dynamics.system().row_count();
  VectorXd inside(nv), lambda(rows), expected(nv), y;
  step.accelerations_at(0.02, inside, lambda);
  step.state_at(0.02, y);
  dynamics.evaluate(0.02, y);
  dynamics.refined_accelerations(expected, lambda);
  CHECK(relative_error(inside, expected) < 1e-8);
}
