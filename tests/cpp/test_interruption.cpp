#include "linkwork/math/interruption.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <stdexcept>
#include <thread>

#include "linkwork/formulation/dynamics.hpp"
#include "mechanisms.hpp"

using namespace linkwork;

namespace {

int looks = 0;

struct Ended : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// While it is there somebody looks.
class Owner {
 public:
  explicit Owner(Interruption look) { set_interruption(look), looks = 0; }
  ~Owner() { set_interruption(nullptr); }
};

void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(60)); }

}  // namespace

TEST_CASE("work looks when some time has passed, not at every call") {
  wait();
  const Owner owner([] { looks += 1; });
  for (int k = 0; k < 1000; ++k) look_for_interruption();
  CHECK(looks == 1);
  wait();
  look_for_interruption();
  CHECK(looks == 2);
}

TEST_CASE("small work looks after so much of it") {
  wait();
  const Owner owner([] { looks += 1; });
  InterruptionMeter meter;
  for (int k = 0; k < 9; ++k) meter.add(1000);
  CHECK(looks == 0);
  meter.add(1000);
  CHECK(looks == 1);
}

TEST_CASE("what the owner throws ends evaluations, which go on afterwards as if nothing had been") {
  const Model model = support::four_bar();
  Dynamics dynamics(model, {}), other(model, {});
  const VectorXd y = dynamics.initial_y();
  VectorXd rates(y.size()), undisturbed(y.size());
  const auto evaluate = [&](Dynamics& of, VectorXd& into) {
    of.evaluate(0.0, y);
    of.rates(into);
  };
  evaluate(other, undisturbed);
  {
    const Owner owner([] { throw Ended("ended"); });
    const auto for_ever = [&] {
      for (;;) evaluate(dynamics, rates);
    };
    CHECK_THROWS_AS(for_ever(), Ended);
  }
  evaluate(dynamics, rates);
  CHECK(rates == undisturbed);
}
