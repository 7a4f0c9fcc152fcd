#include "linkwork/integration/history_watch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "linkwork/math/brent.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

// A contact that begins and ends between two of them is not found; the force in it is that of a contact which begins
// with the speed it has.
constexpr std::array<double, 8> places = {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0};
constexpr double exact = 1e-14;  // of the place in a step

}  // namespace

TurnGuard::TurnGuard(const Dynamics& dynamics) : dynamics_(dynamics) {
  const System& system = dynamics.system();
  for (int k = 0; k < system.history_size(); ++k)
    if (system.history_owners()[static_cast<std::size_t>(k)].kind == HistoryKind::angle) angles_.push_back(k);
  rates_.setZero(system.history_size());
}

void TurnGuard::accept() {
  if (!angles_.empty()) rates_ = dynamics_.evaluation().gauge;
}

double TurnGuard::largest(double h) {
  double most = 0.0;
  const Evaluation& at = dynamics_.evaluation();
  for (const int k : angles_) {
    if (at.gauge[k] == 0.0 && rates_[k] == 0.0) continue;
    const double rate = std::max(std::abs(rates_[k]), std::abs(at.gauge[k]));
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
  const HistoryOwner& owner = system.history_owners()[static_cast<std::size_t>(fastest_)];
  ErrorDetails details;
  if (owner.joint) details.joints = {system.model().joint_name(owner.element)};
  else details.forces = {system.model().force_names().name(owner.element)};
  throw StepSizeError("turns",
                      system.history_name(fastest_) + ": its angle turns by about " + numbers +
                          ", and full turns cannot be counted in steps of nearly half a turn; use a step of " + shorter +
                          " s or less, or rtol for steps that follow the motion",
                      details);
}

ContactWatch::ContactWatch(const Dynamics& dynamics) : dynamics_(dynamics) {
  if (!dynamics.contacts().empty()) at_ = dynamics.system().make_evaluation();
}

double ContactWatch::depth(const PairStepper& stepper, int variable, double t, double h, double theta) {
  const System& system = dynamics_.system();
  stepper.interpolate(system, theta, state_);
  system.evaluate_gauges(t + theta * h, state_.head(system.q_size()),
                         state_.segment(system.q_size(), system.v_size()), dynamics_.history(), at_);
  return at_.gauge[variable];
}

// The side on which a contact is at the start is that of its history: its depth may be roundoff there.
std::optional<ContactWatch::Switch> ContactWatch::first(const PairStepper& stepper, double t, double h) {
  double from = 0.0;
  for (const double to : places) {
    depth(stepper, 0, t, h, to);
    const VectorXd depths = at_.gauge;
    std::optional<Switch> found;
    for (const int k : dynamics_.contacts()) {
      const bool open = dynamics_.history()[k] == 0.0;
      if (depths[k] == 0.0 || (depths[k] > 0.0) != open) continue;
      const auto at = [&](double theta) { return depth(stepper, k, t, h, theta); };
      const double before = at(from);
      const bool there = before == 0.0 || (before > 0.0) == (depths[k] > 0.0);
      const double theta = there ? from : brent(at, from, before, to, depths[k], exact);
      if (!found || theta < found->theta) found = {k, theta, open};
    }
    if (found) return found;
    from = to;
  }
  return {};
}

}  // namespace linkwork
