#include "linkwork/integration/events.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/math/brent.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

// Ends of the pieces of a step: two zeros within one are not seen. The first few count after an event.
constexpr std::array<double, 14> places = {0x1p-22, 0x1p-20, 0x1p-18, 0x1p-16, 0x1p-14, 0x1p-12, 0x1p-10,
                                           0x1p-8,  0x1p-6,  0x1p-4,  0.25,    0.5,     0.75,    1.0};
constexpr std::size_t usual_places = 4;

constexpr double finest = 1e-12, part_of_step = 1e-9;  // of times of events [s], and of the longest step
constexpr double line = 1e-7;                          // of the size of q: for differences of an event's function
constexpr double roundoff = 1e-15;                     // likewise, and of that of v
constexpr double on_constraints = 0.1;  // of what a function changes by in that line: less is what corrections leave
constexpr double slowest = 1e4;         // times that it was faster before
constexpr double leaving = 16.0;        // times as long as a time is known: what a barrier has turned back has left
constexpr double not_straight = 0.25;   // of a change: how far from half of it that of half the way may be
constexpr double as_resolved = 2.0;     // times what a function changes by in the resolution of its time
constexpr double beyond = 1.01;         // times a value: what is far from it
constexpr double as_drift = 2.0;        // times a drift: what may come of it with the change
constexpr double at_rest = 1e-6;        // of the speed before an event: what those differences resolve

void check(const Event& event) {
  const auto refuse = [&](const std::string& why) { throw OptionError("event", "event '" + event.name + "': " + why); };
  if (!event.function) refuse("has no function");
  if (event.direction < -1 || event.direction > 1) refuse("the direction must be 1 (rising), -1 (falling) or 0 (both)");
  if (event.tolerance && !(*event.tolerance >= 0.0 && std::isfinite(*event.tolerance)))
    refuse("the tolerance must not be negative");
}

}  // namespace

EventWatch::EventWatch(std::vector<Event> events)
    : events_(std::move(events)),
      last_value_(events_.size(), 0.0),
      last_theta_(events_.size(), 0.0),
      barrier_t_(events_.size(), -INFINITY),
      left_t_(events_.size(), -INFINITY),
      zero_(events_.size(), 0.0),
      drift_(events_.size(), 0.0),
      stayed_(events_.size(), 0) {
  for (const Event& event : events_) check(event);
}

double EventWatch::value(std::size_t index, double t, const VectorXd& y) {
  q_and_v_ = y.head(y.size() - 1);
  const double value = events_[index].function(t, q_and_v_);
  if (!std::isfinite(value))
    throw OptionError("event", "event '" + events_[index].name + "': its function is not a finite number");
  return value;
}

void EventWatch::start(const System& system, double t, const VectorXd& y) {
  take_signs(t, y);
  fresh_ = false;
  double s = 0.0;
  for (std::size_t k = 0; k < events_.size(); ++k) {
    const double of_place = roundoff / line * std::abs(change_along(system, k, t, y, s));
    if (std::abs(last_value_[k]) <= of_place + rounding(system, k, t, y)) last_value_[k] = 0.0;
  }
}

void EventWatch::take_signs(double t, const VectorXd& y) {
  for (std::size_t k = 0; k < events_.size(); ++k) last_value_[k] = value(k, t, y);
}

double EventWatch::tolerance(std::size_t index) const {
  return events_[index].tolerance.value_or(std::min(finest, part_of_step * longest_));
}

double EventWatch::resolution(std::size_t index) const { return std::min(tolerance(index), finest); }

/// How much later others may come to come with it.
double EventWatch::resolved(std::size_t index, double t) const {
  return tolerance(index) + 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
}

/// How exactly its time is known.
double EventWatch::found_within(std::size_t index, double t) const {
  return resolution(index) + 4.0 * std::numeric_limits<double>::epsilon() * std::abs(t);
}

/// Of a function of velocities, by that of these.
double EventWatch::rounding(const System& system, std::size_t index, double t, const VectorXd& y) {
  state_ = y;
  state_.segment(system.q_size(), system.v_size()) *= 1.0 + line;
  return roundoff / line * std::abs(value(index, t, state_) - value(index, t, y));
}

/// Up to how exactly times are known, and positions on constraints.
bool EventWatch::is_zero(const System& system, std::size_t index, double t, const VectorXd& y) {
  double s = 0.0;
  const double value = std::abs(last_value_[index]), change = std::abs(change_along(system, index, t, y, s));
  return value <= on_constraints * change || (s > 0.0 && value <= leaving * found_within(index, t) * change / s) ||
         value <= as_located(system, index, t, y);
}

void EventWatch::start_after(const System& system, double t, const VectorXd& y, const VectorXd& y_dot,
                             const std::vector<Happened>& happened) {
  approach(y_dot);
  start(system, t, y);
  VectorXd before(y.size());
  for (const Happened& it : happened) {
    if (!is_zero(system, it.event, t, y)) continue;
    before << it.before, 0.0;
    double through = rate(system, it.event, t, before);
    if (through == 0.0) through = -change_in_time(system, it.event, t, before, -resolved(it.event, t));
    if (through == 0.0) continue;
    drift_[it.event] = std::abs(last_value_[it.event]);
    restart_happened(system, t, before, y, {it.event, 0.0, through > 0.0 ? 1.0 : -1.0});
    fresh_ = true;
  }
}

/// Half of the way a smooth function has moved by half of it; one that jumps there has no drift.
void EventWatch::find_drift(const System& system, double t, const VectorXd& y, const VectorXd& corrected) {
  VectorXd half = 0.5 * (y + corrected);
  system.normalize(half.head(system.q_size()));
  for (std::size_t k = 0; k < events_.size(); ++k) {
    const double found = value(k, t, y), moved = value(k, t, corrected) - found;
    const bool smooth = std::abs(value(k, t, half) - found - 0.5 * moved) <= not_straight * std::abs(moved);
    drift_[k] = smooth ? std::abs(moved) : 0.0;
  }
}

void EventWatch::restart(const System& system, double t, const VectorXd& before, const VectorXd& y,
                         const std::vector<Found>& happened) {
  const std::vector<double> last_values = last_value_;
  take_signs(t, y);
  fresh_ = true;
  for (std::size_t k = 0; k < events_.size(); ++k) {
    const auto is_k = [k](const Found& it) { return it.event == k; };
    const auto it = std::find_if(happened.begin(), happened.end(), is_k);
    if (it != happened.end()) restart_happened(system, t, before, y, *it);
    else restart_other(system, k, t, before, last_values[k]);
  }
  std::fill(drift_.begin(), drift_.end(), 0.0);
}

/// While it has not left a barrier that stays as it is, whatever another event does.
void EventWatch::restart_other(const System& system, std::size_t k, double t, const VectorXd& before,
                               double last_value) {
  if (t <= left_t_[k] || (zero_[k] > 0.0 && std::abs(last_value_[k]) <= zero_[k])) {
    last_value_[k] = last_value;
    return;
  }
  barrier_t_[k] = -INFINITY;
  zero_[k] = 0.0;
  stayed_[k] = 0;
  double s = 0.0;
  const double along = change_along(system, k, t, before, s), located = as_located(system, k, t, before);
  const double near = std::max({as_drift * drift_[k], on_constraints * std::abs(along), located});
  if (std::abs(last_value_[k]) <= near && along != 0.0) last_value_[k] = along > 0.0 ? -1.0 : 1.0;
}

void EventWatch::restart_happened(const System& system, double t, const VectorXd& before, const VectorXd& y,
                                  const Found& happened) {
  const std::size_t k = happened.event;
  double s = 0.0;
  const double along = change_along(system, k, t, before, s);
  const double through = s > 0.0 ? happened.side * along / s : 0.0, now = happened.side * rate(system, k, t, y);
  const double found = std::abs(value(k, t, before)), after = last_value_[k];
  const double located = as_located(system, k, t, before), drift = as_drift * drift_[k];
  const double near = std::max({drift, on_constraints * std::abs(along), located});
  const bool jumps = found > near, elsewhere = !jumps && std::abs(after) > near;  // by the change
  // So soon after a barrier the motion through zero is roundoff, and so may be its direction; what has never left it
  // and is pushed through does not move yet.
  const bool held = t - barrier_t_[k] <= found_within(k, t) || (stayed_[k] != 0 && through <= 0.0);
  const bool barrier = held || (!jumps && !elsewhere && through > 0.0 && now <= at_rest * through);
  barrier_t_[k] = barrier ? t : -INFINITY;
  stayed_[k] = barrier;
  left_t_[k] = -INFINITY;
  if (barrier) {  // what has become slow takes as much longer
    const double slower = now < -at_rest * through ? std::clamp(through / -now, 1.0, slowest) : 1.0;
    left_t_[k] = t + leaving * slower * found_within(k, t);
  }
  const double zero = std::max(drift, found <= located ? beyond * found : 0.0);
  zero_[k] = std::abs(after) <= zero ? zero : 0.0;
  last_value_[k] = barrier ? -happened.side : elsewhere ? after : 0.0;
}

/// Change of the function in time by the motion of the bodies, (g(q + s q_dot, v) - g(q, v)) / s. The difference is
/// taken along a short line and not in time: it is as good for a slow motion as for a fast one.
double EventWatch::rate(const System& system, std::size_t index, double t, const VectorXd& y) {
  double s = 0.0;
  const double change = change_along(system, index, t, y, s);
  return s > 0.0 ? change / s : 0.0;
}

/// What a function may be where it passes zero, by how exactly the time of that is known; of one that jumps roundoff.
/// The run has been at times before t, but perhaps not at later ones.
double EventWatch::as_located(const System& system, std::size_t index, double t, const VectorXd& y) {
  const double resolution = resolved(index, t), dt = std::abs(t) > resolution ? -resolution : resolution;
  const double whole = change_in_time(system, index, t, y, dt), half = change_in_time(system, index, t, y, 0.5 * dt);
  const bool straight = std::abs(half - 0.5 * whole) <= not_straight * std::abs(whole);
  return (straight ? as_resolved * std::abs(whole) : 0.0) + rounding(system, index, t, y);
}

double EventWatch::change_in_time(const System& system, std::size_t index, double t, const VectorXd& y, double dt) {
  const int nq = system.q_size();
  VectorXd moved = y, q_dot(nq);
  system.position_rates(y.head(nq), y.segment(nq, system.v_size()), q_dot);
  moved.head(nq) += dt * q_dot;
  if (y_dot_.size() == y.size()) moved.segment(nq, system.v_size()) += dt * y_dot_.segment(nq, system.v_size());
  system.normalize(moved.head(nq));
  return value(index, t + dt, moved) - value(index, t, y);
}

/// That difference, in the time s; s = 0 where nothing moves.
double EventWatch::change_along(const System& system, std::size_t index, double t, const VectorXd& y, double& s) {
  const int nq = system.q_size();
  state_ = y;
  VectorXd q_dot(nq);
  system.position_rates(y.head(nq), y.segment(nq, system.v_size()), q_dot);
  const double speed = q_dot.cwiseAbs().maxCoeff();
  s = speed > 0.0 ? line * (1.0 + y.head(nq).cwiseAbs().maxCoeff()) / speed : 0.0;
  if (s == 0.0) return 0.0;
  state_.head(nq) += s * q_dot;
  system.normalize(state_.head(nq));
  return value(index, t, state_) - value(index, t, y);
}

const std::vector<EventWatch::Found>& EventWatch::scan(const Interpolant& step, const System& system, double t,
                                                       double h, bool last) {
  found_.clear();
  expect(h);
  std::fill(last_theta_.begin(), last_theta_.end(), 0.0);
  double from = 0.0;
  for (std::size_t place = fresh_ ? 0 : places.size() - usual_places; place < places.size(); ++place) {
    const std::size_t before = found_.size();
    scan_piece(step, system, t, h, from, places[place], last && place + 1 == places.size());
    from = places[place];
    if (end_at_stop(before, t, h)) break;
  }
  fresh_ = false;
  return found_;
}

/// Sorts what was found from `first` on by time. True where one of them ends the step: those after it, and not with it,
/// are none; those with it come in the order of the events, first the ones that would end it, too.
bool EventWatch::end_at_stop(std::size_t first, double t, double h) {
  const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(first);
  std::stable_sort(begin, found_.end(), [](const Found& a, const Found& b) { return a.theta < b.theta; });
  const auto stops = [this](const Found& it) { return events_[it.event].stops(); };
  const auto stop = std::find_if(begin, found_.end(), stops);
  if (stop == found_.end()) return false;
  const double theta = stop->theta;
  const auto beside = [&](const Found& it) {
    return std::abs(it.theta - theta) * h <= resolved(it.event, t + theta * h);
  };
  const auto together = std::find_if(begin, stop, beside);
  found_.erase(std::remove_if(stop + 1, found_.end(), std::not_fn(beside)), found_.end());
  std::for_each(together, found_.end(), [&](Found& it) { it.theta = theta; });
  std::sort(together, found_.end(), [](const Found& a, const Found& b) { return a.event < b.event; });
  std::stable_partition(together, found_.end(), stops);
  return true;
}

void EventWatch::scan_piece(const Interpolant& step, const System& system, double t, double h, double from, double to,
                            bool last) {
  for (std::size_t k = 0; k < events_.size(); ++k) {
    if (t + to * h <= left_t_[k]) continue;
    const auto at = [&](double theta) {
      step.interpolate(system, theta, state_);
      return value(k, t + theta * h, state_);
    };
    const double last_value = last_value_[k], found = at(to);
    const double now = found == 0.0 && last ? -last_value : found;
    if (std::abs(now) <= zero_[k]) continue;
    zero_[k] = 0.0;
    if ((last_value < 0.0) == (now < 0.0)) stayed_[k] = 0;
    if ((last_value < 0.0) != (now < 0.0) && last_value != 0.0 && events_[k].direction * now >= 0.0) {
      const double a = std::min(last_theta_[k], from), fa = a == 0.0 ? at(a) : last_value;
      // A sample of zero between the two has no sign, and at the start of a step the interpolant may round otherwise.
      const bool at_a = (fa < 0.0) == (now < 0.0) || fa == 0.0;
      const double theta = found == 0.0 ? to : at_a ? a : brent(at, a, fa, to, now, resolution(k) / h);
      found_.push_back({k, theta, now > 0.0 ? 1.0 : -1.0});
    }
    last_value_[k] = now;
    last_theta_[k] = to;
  }
}

}  // namespace linkwork
