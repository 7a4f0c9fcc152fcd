#include "linkwork/integration/touch_monitor.hpp"

#include <algorithm>

#include "linkwork/integration/hermite_step.hpp"

namespace linkwork {
namespace {

constexpr double faster = 0.5;  // than in the step before, relative

}  // namespace

void TouchMonitor::restart(const VectorXd& switches) {
  before_.resize(0);
  now_ = switches;
}

/// Whether a depth comes to zero within the step after the last, if it goes on as in that: else nothing is asked.
bool TouchMonitor::come_near() const {
  return before_.size() == 0 ||
         ((now_.array() < 0.0) && (now_ + (1.0 + faster) * (now_ - before_)).array() > 0.0).any();
}

void TouchMonitor::pass(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& switches) {
  if (switches.size() == 0) return;
  if (now_.size() > 0 && come_near()) {
    search_.begin(y, now_);
    if (search_.suspects(t, h, y_new, switches))
      for (const TouchSearch::Touch& it : search_.find(HermiteStep(dynamics_.system(), y, y_new, h), t, h))
        note(it.which, t, h, search_.rate_at_begin(it.which));
  }
  before_ = std::exchange(now_, switches);
}

void TouchMonitor::note(int which, double t, double h, double speed) {
  const auto is_it = [which](const PassedTouch& it) { return it.which == which; };
  auto it = std::find_if(passed_.begin(), passed_.end(), is_it);
  if (it == passed_.end()) it = passed_.insert(it, {which, t, t, 0.0, 0});
  it->until = t + h;
  it->speed = std::max(it->speed, speed);
  it->steps += 1;
}

}  // namespace linkwork
