#include "linkwork/formulation/stabilization.hpp"

#include "support.hpp"

using namespace support;

TEST_CASE("dead-beat gains annul every violation in two steps, whatever the method and the step") {
  for (const double s : {0.0, 0.5, 1.0})  // explicit Euler, methods of order two and more, semi-implicit Euler
    for (const double h : {1e-3, 0.2}) {
      const Gains gains = deadbeat_gains(s, h);
      const double alpha = gains.alpha * h, beta = gains.beta * h;
      // (Phi, h Phi_dot) after a step under w = -2 alpha (h Phi_dot) - beta^2 Phi
      Eigen::Matrix2d step;
      step << 1.0 - s * beta * beta, 1.0 - 2.0 * s * alpha, -beta * beta, 1.0 - 2.0 * alpha;
      CHECK((step * step).cwiseAbs().maxCoeff() < 1e-14);
      CHECK(step.cwiseAbs().maxCoeff() > 0.1);  // one step does not do
    }
}

TEST_CASE("each kind of stabilization has one name and projects what the name says") {
  for (const StabilizationInfo& info : stabilizations()) {
    const std::string name = info.name;
    CHECK(stabilization_info(name).kind == info.kind);
    CHECK(projects_positions(info.kind) == (name == "projection" || name == "position_projection"));
    CHECK(projects_velocities(info.kind) == (name == "projection" || name == "velocity_projection"));
  }
  CHECK(error_code([] { stabilization_info("baumgart"); }) != "none");
}
