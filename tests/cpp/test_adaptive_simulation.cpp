#include "linkwork/integration/adaptive_simulation.hpp"

#include "integrators.hpp"

using namespace support;

TEST_CASE("a schedule of an adaptive run that makes no sense is refused") {
  const auto code = [](auto alter) {
    AdaptiveSchedule schedule;
    schedule.t_end = 1.0;
    schedule.record_every = 1;
    alter(schedule);
    Dynamics dynamics(spherical_pendulum(), {});
    return error_code([&] { AdaptiveSimulation simulation(dynamics, bs32(), schedule); });
  };
  CHECK(code([](AdaptiveSchedule&) {}) == "none");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.t_end = -1.0; }) == "t_end");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.tolerances.relative = 1e-16; }) == "rtol");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.tolerances.absolute = 0.0; }) == "atol");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.largest_step = 0.0; }) == "step");
  CHECK(code([](AdaptiveSchedule& schedule) { schedule.times = {1.5}; }) == "times");
}
