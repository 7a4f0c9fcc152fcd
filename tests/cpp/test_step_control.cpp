#include "linkwork/integration/step_control.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace linkwork;

TEST_CASE("the controller keeps a step whose error is 0.9 of the tolerance to the k-th power") {
  for (const int k : {3, 5, 8}) {
    StepController controller(k);
    const double error = std::pow(0.9, k);
    double h = 1.0;
    for (int step = 0; step < 200; ++step) h = controller.after_accepted(1.0, error);
    CHECK(std::abs(h - std::pow(0.9, 1.0 - 0.3)) < 1e-12);  // e^(-0.7/k) e^(0.4/k) = 0.9^-0.3
  }
}

TEST_CASE("the controller does not let the step grow right after a rejection, and shrinks it for what is no number") {
  StepController controller(5);
  CHECK(controller.after_rejected(1.0, 32.0) == doctest::Approx(0.45));
  CHECK(controller.after_accepted(1.0, 1e-9) == 1.0);
  CHECK(controller.after_accepted(1.0, 1e-9) == 5.0);
  for (const double error : {double(NAN), double(INFINITY)}) CHECK(controller.after_rejected(1.0, error) == 0.1);
}

TEST_CASE("restarted, the controller gives what a new one gives") {
  StepController used(5), fresh(5);
  used.after_accepted(1.0, 1e-3);
  used.after_rejected(1.0, 40.0);
  used.restart();
  CHECK(used.after_accepted(1.0, 0.3) == fresh.after_accepted(1.0, 0.3));
}
