#include "linkwork/integration/break_points.hpp"

#include "integrators.hpp"

using namespace support;

namespace {

/// Pieces of cubics from 0 to 3 s that meet with two continuous derivatives: knots at 1 and 2.
Model with_table() {
  Model model = free_body();
  model.add_signal(piecewise_polynomial({0, 1, 2, 3}, {0, 0, 0, 1, 1, 3, 3, -1, 6, 6, 0, 1}));
  return model;
}

/// Nothing but a bump of width w from 1 on, s^3 (w - s)^3, twice differentiable.
Model with_pulse(double w) {
  Model model = free_body();
  const double size = 1e4 / std::pow(w, 6);
  model.add_signal(piecewise_polynomial(
      {0, 1, 1 + w, 5},
      {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, size * w * w * w, -3 * size * w * w, 3 * size * w, -size, 0, 0, 0, 0, 0, 0, 0}));
  return model;
}

}  // namespace

TEST_CASE("a step ends at the next break, and functions are evaluated beside it, a few units in the last place off") {
  const BreakPoints breaks(free_body(), {2.0, 1.0});
  CHECK(breaks.next(0.0) == 1.0);
  CHECK(breaks.next(1.0) == 2.0);
  CHECK(std::isinf(breaks.next(2.0)));
  CHECK(breaks.at(1.0));
  CHECK(!breaks.at(1.5));
  CHECK(breaks.before(1.0) < 1.0);
  CHECK(breaks.after(1.0) > 1.0);
  CHECK(breaks.after(1.0) - breaks.before(1.0) < 1e-14);
  CHECK(breaks.after(1.5) == 1.5);
  CHECK(breaks.before(1.5) == 1.5);
}

TEST_CASE("up to a break there is room for whole steps, and up to just before it where it is the end of one") {
  const BreakPoints breaks(free_body(), {1.0, 2.05});
  CHECK(breaks.room(0.5, 0.1) < 0.5);
  CHECK(breaks.room(0.5, 0.1) == doctest::Approx(0.5));
  CHECK(breaks.room(1.0 - 1e-15, 0.1) == doctest::Approx(1.0));  // a step begins there
  CHECK(breaks.room(2.0, 0.1) == 0.0);
  CHECK(std::isinf(breaks.room(2.1, 0.1)));
}

TEST_CASE("breaks that differ by roundoff are one, and what is between them is after it") {
  const double nearly = 0.1 + 0.2;  // above 0.3 by one unit
  const BreakPoints breaks(free_body(), {0.3, nearly});
  CHECK(breaks.next(0.0) == 0.3);
  CHECK(std::isinf(breaks.next(0.3)));
  CHECK(breaks.at(0.3));
  CHECK(breaks.before(nearly) < 0.3);
  CHECK(breaks.after(0.3) > nearly);
  for (const double t : {0.3, nearly}) CHECK(breaks.clock(t, 1.0) == breaks.after(nearly));
}

TEST_CASE("where a run ends at a break, nothing is after it") {
  const double nearly = 0.1 + 0.2;
  const BreakPoints breaks(std::vector<double>{nearly, 0.3});
  for (const double t_end : {0.3, nearly}) CHECK(breaks.clock(0.3, t_end) == breaks.before(0.3));
  CHECK(breaks.clock(0.2, 0.3) == 0.2);
}

TEST_CASE("steps that end at a break up to roundoff are on their own sides of it") {
  BreakPoints breaks(std::vector<double>{0.3, 0.5, 0.7});
  const double h = 0.1, third = 3 * h, seventh = 7 * h;  // above 0.3 and 0.7 by one unit
  breaks.meet_steps(0.0, h, {0.0, 1.0});
  CHECK(breaks.times() == std::vector<double>{0.3, third, 0.5, 0.7, seventh});
  for (const double t : {0.3, third}) {
    CHECK(breaks.span(2 * h, t).at(1.0) < 0.3);
    CHECK(breaks.span(t, 4 * h).at(0.0) > third);
    CHECK(breaks.span(t, 4 * h).at(0.5) == t + 0.5 * (4 * h - t));
    CHECK(breaks.clock(t, 1.0) > third);
    CHECK(breaks.clock(t, t) < 0.3);
  }
  CHECK(breaks.span(0.0, h).at(1.0) == h);
}

TEST_CASE("a break is met by the end of a step, of a run and by nothing else") {
  BreakPoints breaks(std::vector<double>{0.25, 0.33});
  breaks.meet_steps(0.03, 0.1, {0.03, std::nextafter(0.25, 1.0)});
  CHECK(breaks.at(0.03 + 3 * 0.1));
  CHECK(breaks.at(std::nextafter(0.25, 1.0)));
  CHECK(!breaks.at(0.25 - 1e-12));
  CHECK(!breaks.at(0.23));
}

TEST_CASE("a function's own breaks are known: where an actuator begins and ends") {
  Model model = free_body();
  model.add_signal(with_breaks(polynomial({1.0}), {0.25, 0.75}));
  const BreakPoints breaks(model, {0.5});
  CHECK(breaks.next(0.0) == 0.25);
  CHECK(breaks.next(0.25) == 0.5);
  CHECK(breaks.next(0.5) == 0.75);
}

TEST_CASE("a single knot of a smooth table in a step is its end, of several none, one just behind the start neither") {
  const BreakPoints breaks(with_table(), {});
  CHECK(breaks.next_knot(0.5) == 1.0);
  CHECK(breaks.only_knot(0.5, 1.5) == 1.0);
  CHECK(breaks.only_knot(0.5, 2.5) == 2.5);
  CHECK(breaks.only_knot(0.999, 1.5) == 1.5);
  CHECK(breaks.only_knot(1.2, 1.8) == 1.8);
}

TEST_CASE("a pulse between the stages of a step is not leapt over, one that the estimate tells of is seen") {
  const BreakPoints breaks(with_pulse(0.1), {});
  CHECK(!breaks.seen(bs32(), {0.2, 2.2}, 1e-6));  // stages at 0.2, 1.3, 1.85, 2.4
  CHECK(breaks.seen(bs32(), {0.7, 0.7}, 1e-6));   // one at 1.05
  CHECK(breaks.seen(bs32(), {1.2, 2.0}, 1e-6));   // behind it
}
