#include "linkwork/integration/divergence.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("a run that diverges ends with an error that names a body and the time") {
  for (const bool held : {false, true}) {
    CAPTURE(held);
    Model model = held ? spherical_pendulum() : free_body();
    const std::string name = model.body_name(0);
    const Mat3<double> I = Mat3<double>::Identity();
    const Vec3<double> s(1.0, 0.5, 0.0);
    model.add_force("spring_damper", "stiff", ground, 0, {s, s, I, I}, {{1e60, -1}, {0.0, -1}, {0.1, -1}, {0.0, -1}});
    try {
      run(model, make_runge_kutta(rk4()), {100.0, 0.5, 1});
      FAIL("no error");
    } catch (const NotFiniteError& error) {
      INFO(std::string(error.what()));
      CHECK((error.details.bodies.empty() ? "no body" : error.details.bodies.front()) == name);
      CHECK(error.details.time > 0.0);
      CHECK(error.details.time < 100.0);
    }
  }
}
