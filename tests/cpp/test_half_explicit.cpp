#include "integrators.hpp"

using namespace support;

TEST_CASE("a half-explicit method that is implicit, singular or inconsistent is refused") {
  const auto code = [](auto alter) {
    HalfExplicitTableau tableau = half_explicit_heun();
    alter(tableau);
    return error_code([&] { make_half_explicit(tableau); });
  };
  CHECK(code([](HalfExplicitTableau&) {}) == "none");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A(0, 0) = 1.0; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A_bar(0, 1) = 1.0; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A_bar(0, 0) = 0.0; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A_bar(1, 0) = 0.6; }) == "tableau");
  CHECK(code([](HalfExplicitTableau& tableau) { tableau.A.conservativeResize(1, 1); }) == "tableau");
}

TEST_CASE("a half-explicit method keeps its order, and its steps end on the velocity constraints") {
  const Method heun{"half-explicit heun", 2, [] { return make_half_explicit(half_explicit_heun()); }};
  CHECK(observed_order(spherical_pendulum(), heun, 1.0, 400, unstabilized()) == doctest::Approx(2.0).epsilon(0.1));
  const Frames frames = run(spherical_pendulum(), heun.make(), {1.0, 0.02, 1}, unstabilized());
  double worst = 0.0;
  for (std::size_t n = 0; n < frames.t.size(); ++n) worst = std::max(worst, frames.violation[3 * n + 1]);
  CHECK(worst < 1e-12);
}

TEST_CASE("a half-explicit method refuses Baumgarte's stabilization, which has nothing to do there") {
  for (const char* name : {"baumgarte", "sampled_baumgarte"}) {
    Options options;
    options.stabilization = name;
    CHECK(error_code([&] {
            run(spherical_pendulum(), make_half_explicit(half_explicit_heun()), {0.1, 0.1, 1}, options);
          }) == "conflict");
  }
}
