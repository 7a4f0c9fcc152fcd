#include "linkwork/integration/step_groups.hpp"

#include <numeric>

#include "support.hpp"

using namespace support;

namespace {

void take(StepGroups& groups, double t, const std::vector<int>& of) {
  if (KeptStep* place = groups.take(of)) {
    place->t = t;
    place->h = 1.0;
    place->changes = VectorXd::Ones(1);
  }
}

std::int64_t covered(const StepGroups& groups) {
  const std::vector<RunPart> parts = groups.parts();
  return std::accumulate(parts.begin(), parts.end(), std::int64_t{0},
                         [](std::int64_t sum, const RunPart& part) { return sum + part.steps; });
}

}  // namespace

TEST_CASE("of many steps of a group some are kept that are spread over all of them, of few all") {
  StepGroups groups(2, 100);
  for (int step = 0; step < 5000; ++step) take(groups, step, {step % 1000 == 500 ? 1 : 0});
  std::vector<double> rare, often;
  for (const RunPart& part : groups.parts()) (part.steps == 1 ? rare : often).push_back(part.any.t);
  CHECK(rare == std::vector<double>{500.0, 1500.0, 2500.0, 3500.0, 4500.0});
  CHECK(often.size() >= 12);
  CHECK(often.size() <= 20);
  CHECK(often.front() < 700.0);
  CHECK(often.back() > 4300.0);
  CHECK(covered(groups) >= 5000);
  CHECK(covered(groups) < 5100);
}

TEST_CASE("a step of several groups counts once, for the rarest") {
  StepGroups groups(3, 100);
  for (int step = 0; step < 3000; ++step) take(groups, step, {0, 1, 2});
  CHECK(covered(groups) >= 3000);
  CHECK(covered(groups) < 3100);
  StepGroups others(2, 100);
  for (int step = 0; step < 1000; ++step) take(others, step, step == 700 ? std::vector{0, 1} : std::vector{0});
  std::int64_t alone = 0;
  for (const RunPart& part : others.parts()) alone += part.any.t == 700.0 && part.steps == 1 ? 1 : 0;
  CHECK(alone == 1);
}

TEST_CASE("breaks are grouped by the function and the decade of its jump, what nobody knows by itself") {
  std::vector<double> knots = {0.0}, values = {1.0};
  for (int k = 1; k < 100; ++k) {
    knots.push_back(k);
    values.push_back(k == 40 ? 1e3 : k % 2);
  }
  knots.push_back(100.0);
  Model model;
  model.add_signal(piecewise_polynomial(knots, values));
  model.add_signal(
      piecewise_polynomial({-1.0, 20.5, 200.0}, {1e-6, 0.0}));  // however small, it may be all to a light part
  std::vector<double> times(knots.begin() + 1, knots.end() - 1);
  times.push_back(55.5);  // of a function of Python
  times.push_back(20.5);
  std::sort(times.begin(), times.end());
  const std::vector<int> groups = groups_of_breaks(model, times);
  const auto of = [&](double t) {
    return groups[static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), t) - times.begin())];
  };
  CHECK(of(40.0) == of(41.0));  // up and down
  CHECK(of(3.0) == of(70.0));
  const std::vector<int> kinds = {of(40.0), of(3.0), of(20.5), of(55.5)};
  for (std::size_t a = 0; a < kinds.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) CHECK(kinds[a] != kinds[b]);
}
