#include "linkwork/integration/history_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "linkwork/math/brent.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr std::array<double, 8> places = {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0};
constexpr double exact = 1e-14;  // of the place in a step

}  // namespace

TurnGuard::TurnGuard(const Dynamics& dynamics) : dynamics_(dynamics) {
  const System& system = dynamics.system();
  for (int k = 0; k < system.history_size(); ++k)
    if (system.history_owners()[k].kind == HistoryKind::angle) angles_.push_back(k);
  rates_.setZero(system.history_size());
}

void TurnGuard::accept() {
  if (!angles_.empty()) rates_ = dynamics_.evaluation().history_rate;
}

double TurnGuard::largest(double h) {
  double most = 0.0;
  const Evaluation& at = dynamics_.evaluation();
  for (const int k : angles_) {
    if (at.history_rate[k] == 0.0 && rates_[k] == 0.0) continue;
    const double rate = std::max(std::abs(rates_[k]), std::abs(at.history_rate[k]));
    const double turned = std::max(std::abs(at.history[k] - dynamics_.history()[k]), h * rate);
    if (turned <= most) continue;
    most = turned;
    fastest_ = k;
  }
  return most;
}

void TurnGuard::refuse(double h, double angle) const {
  char numbers[96];
  std::snprintf(numbers, sizeof numbers, "%.3g rad in a step of %.3g s", angle, h);
  char shorter[32];
  std::snprintf(shorter, sizeof shorter, "%.1g", 0.5 * limit / angle * h);
  const System& system = dynamics_.system();
  ErrorDetails details;
  (system.history_owners()[fastest_].joint ? details.joints : details.forces) = {system.history_element(fastest_)};
  throw StepSizeError("turns",
                      system.history_name(fastest_) + ": its angle turns by about " + numbers +
                          ", and full turns cannot be counted in steps of nearly half a turn; use a step of " +
                          shorter + " s or less, or rtol for steps that follow the motion",
                      details);
}

SwitchWatch::SwitchWatch(const Dynamics& dynamics, double least) : dynamics_(dynamics), least_(least) {
  if (!dynamics.system().switches().empty()) at_ = dynamics.system().make_evaluation();
}

double SwitchWatch::value(const Interpolant& step, int which, double t, double h, double theta) {
  const System& system = dynamics_.system();
  step.interpolate(system, theta, state_);
  system.evaluate_switches(t + theta * h, state_.head(system.q_size()),
                           state_.segment(system.q_size(), system.v_size()), dynamics_.history(), at_);
  return at_.switches[which];
}

// The side at the start is known: the value may be roundoff there. What is still on its old side where another is found
// to change comes later, and need not be searched for.
std::optional<SwitchWatch::Switch> SwitchWatch::first(const Interpolant& step, double t, double h,
                                                      const std::vector<TouchSearch::Touch>& touches) {
  places_.assign(places.begin(), places.end());
  for (const TouchSearch::Touch& it : touches) places_.push_back(it.theta);
  std::sort(places_.begin(), places_.end());
  double from = 0.0;
  for (std::size_t place = 0; place < places_.size(); ++place) {
    const double to = places_[place];
    value(step, 0, t, h, to);
    const VectorXd values = at_.switches;
    VectorXd at_first = values;
    std::optional<Switch> found;
    for (int k = 0; k < values.size(); ++k) {
      const bool positive = values[k] > 0.0;
      if (std::abs(values[k]) <= least_ || positive == (dynamics_.sides()[k] != 0)) continue;
      if ((at_first[k] > 0.0) != positive) continue;
      const auto at = [&](double theta) { return value(step, k, t, h, theta); };
      const double before = at(from);
      const bool there = before == 0.0 || (before > 0.0) == positive;
      const double theta = there ? from : brent(at, from, before, to, values[k], exact);
      if (found && theta >= found->theta) continue;
      found = {k, theta, positive, to};
      value(step, k, t, h, theta);
      at_first = at_.switches;
    }
    if (found) {
      found->until = last_place_of(*found, place, step, t, h);
      return found;
    }
    from = to;
  }
  return {};
}

/// Up to which it stays on that side.
double SwitchWatch::last_place_of(const Switch& found, std::size_t place, const Interpolant& step, double t, double h) {
  while (place + 1 < places_.size() && (value(step, found.which, t, h, places_[place + 1]) > 0.0) == found.positive)
    ++place;
  return places_[place];
}

}  // namespace linkwork
