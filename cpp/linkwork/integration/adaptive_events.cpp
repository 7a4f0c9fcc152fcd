// What events and breaks do in AdaptiveSimulation.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "linkwork/integration/adaptive_simulation.hpp"

namespace linkwork {
namespace {

// Events that end steps accumulate, like the bounces of a ball, when so many in a row have come after ever shorter
// times, the last of which is less than this part of all of them.
constexpr int many_shorter = 8;
constexpr double shorter = 0.999, short_time = 1e-6;

constexpr double beside_events = 1e-3;  // of a step
constexpr double cut_otherwise = 0.1;   // of a step: between times of one event in steps that are cut otherwise
constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();  // of times
constexpr double jump = 1e-9;  // of velocities of drivers, relative: what is less is none

}  // namespace

void AdaptiveSimulation::look_for_events() {
  const Dynamics::Place end = dynamics_.place();
  if (!leapt_ && stepper_.prepare_interpolation(dynamics_)) away_from_ = end;
  const System& system = dynamics_.system();
  const Eigen::Index size = y_.size() - 1;
  for (const EventWatch::Found& found : watch_.scan(interpolant(), system, t_, h_, t_new_ >= schedule_.t_end)) {
    if (stops_.empty()) interpolant().interpolate(system, found.theta, workspace_);
    const double t = stops_.empty() ? std::min(t_ + found.theta * h_, t_new_) : t_new_;
    const Energies known{.work = workspace_[size]};
    of_step_.push_back(
        {found.event, since_start(found.event, t), workspace_.head(size), workspace_.head(size), {known, known}});
    if (stops_.empty() && !watch_.event(found.event).stops()) continue;
    stops_.push_back(found);
    t_new_ = t;
  }
  if (stops_.empty()) return;
  y_new_ = workspace_;
  evaluated_ = false;
  away_from_.reset();
  const double theta = stops_.front().theta, beside = theta > beside_events ? -beside_events : beside_events;
  interpolant().interpolate(system, theta + beside, workspace_);
  watch_.approach((workspace_ - y_new_) / (beside * h_));
}

/// When an event of this step came; steps up to the start of a run that is resumed were those of the run before it, cut
/// otherwise: what that has listed is not listed again, and what it has not seen came at the start.
double AdaptiveSimulation::since_start(std::size_t event, double t) {
  if (!resumed() || !schedule_.listed || !(t_ < start_)) return t;
  const auto way = [&](const Listed& it) { return it.event == event ? std::abs(it.t - t) : INFINITY; };
  const auto nearest = std::ranges::min_element(repeated_, {}, way);
  if (nearest == repeated_.end() || way(*nearest) > cut_otherwise * h_) return std::max(t, after_start());
  repeated_.erase(nearest);
  return std::min(t, start_);
}

/// At y_, where `dynamics` is evaluated at its positions.
double AdaptiveSimulation::kinetic_energy() const {
  const System& system = dynamics_.system();
  return system.kinetic_energy(dynamics_.evaluation(), y_.segment(system.q_size(), system.v_size()));
}

/// Of the functions of events, where one changes the state: by what brings it back to the constraints.
void AdaptiveSimulation::find_drift() {
  const auto changes = [this](const EventWatch::Found& it) { return bool(watch_.event(it.event).change); };
  if (std::none_of(stops_.begin(), stops_.end(), changes)) return;
  const double t = clock();
  VectorXd y = y_new_;
  dynamics_.evaluate(t, y);
  projection().positions(t, y);
  projection().velocities(t, y);
  watch_.find_drift(dynamics_.system(), t_, y_new_, y);
  dynamics_.evaluate(t, y_);
}

/// The work takes up the energy that the event makes or takes away.
bool AdaptiveSimulation::apply(const Event& event, Occurrence& occurrence) {
  const System& system = dynamics_.system();
  const Eigen::Index size = y_.size() - 1;
  occurrence.before = y_.head(size);
  occurrence.energies.before = energies();
  const double before = energy();
  const Changed changed = event.change(t_, y_.head(size));
  if (changed.y.size() != size || !changed.y.allFinite())
    throw OptionError("event", "event '" + event.name + "': the state after it has a wrong size or is not finite");
  y_.head(size) = changed.y;
  system.normalize(y_.head(system.q_size()));
  const double t = clock();
  dynamics_.evaluate(t, y_);
  projection().positions(t, y_);
  projection().velocities(t, y_);
  dynamics_.evaluate(t, y_);
  accept_history();
  dynamics_.take_sides(switches_.least());
  y_[size] += energy() - before;
  sampling_.strike();
  occurrence.after = y_.head(size);
  occurrence.energies.after = energies();
  return changed.ends;
}

/// From what ends at the break t_ to what begins there.
void AdaptiveSimulation::cross_break() {
  statistics_.breaks += 1;
  y_[y_.size() - 1] += jumps_.work(breaks_.before(t_), clock(), y_, dynamics_.history());
  const bool driven = dynamics_.system().time_dependent_constraints();
  if (driven) {
    evaluate(breaks_.before(t_), y_);
    const VectorXd before = dynamics_.evaluation().Phi_t;
    evaluate(clock(), y_);
    strike(before);
  }
  evaluated_ = false;
}

void AdaptiveSimulation::strike(const VectorXd& Phi_t_before) {
  const VectorXd& Phi_t = dynamics_.evaluation().Phi_t;
  const double size = std::max(Phi_t.cwiseAbs().maxCoeff(), Phi_t_before.cwiseAbs().maxCoeff());
  if ((Phi_t - Phi_t_before).cwiseAbs().maxCoeff() <= jump * size) return;
  statistics_.impacts += 1;
  const double before = energy();
  Strike strike{t_, dynamics_.evaluation().potential, {y_, kinetic_energy()}, {}};
  projection().velocities(clock(), y_);
  y_[y_.size() - 1] += energy() - before;
  sampling_.strike();
  strike.after = {y_, kinetic_energy()};
  // At its end nothing strikes the run before, but where an event ended it.
  const bool struck = std::ranges::any_of(schedule_.happened, [&](auto& it) { return watch_.event(it.event).stops(); });
  if (!resumed() || t_ > start_ || (t_ == start_ && !struck)) strikes_.push_back(std::move(strike));
}

/// What ended the run before this one does not end it; by steps that are cut otherwise it may come a little later.
void AdaptiveSimulation::finish_event(double t_before) {
  auto occurrence = of_step_.end() - std::ssize(stops_);
  bool ends = false;
  const auto came = [this](const EventWatch::Found& found) {
    const auto same = [&](const Happened& it) { return it.event == found.event; };
    return std::any_of(schedule_.happened.begin(), schedule_.happened.end(), same);
  };
  const auto at_start = [this](const EventWatch::Found& found) {  // of a step that begins there
    return t_ - start_ <= watch_.resolution(found.event) + rounding * std::abs(t_);
  };
  with_time(t_, NAN, [&] { find_drift(); });
  for (const EventWatch::Found& it : stops_) {
    const Event& event = watch_.event(it.event);
    bool ends_here = event.terminal;
    if (event.change) with_time(t_, NAN, [&] { ends_here = apply(event, *occurrence) || ends_here; });
    if (resumed() && came(it) && (t_before < start_ ? repeating() && !schedule_.listed : at_start(it)))
      occurrence->t = start_;  // which is listed already
    ends = ends || (ends_here && !(resumed() && occurrence->t <= start_));
    ++occurrence;
  }
  finished_ = finished_ || ends;
}

void AdaptiveSimulation::list_events() {
  for (Occurrence& it : of_step_) {
    if (resumed() && it.t <= start_) continue;
    listed_.push_back({it.event, it.t});
    around_events_.push_back(it.energies);
    occurrences_.push_back(std::move(it));
  }
  of_step_.clear();
}

void AdaptiveSimulation::check_accumulation() {
  const double interval = t_ - last_stop_;
  const bool vanishes = interval <= watch_.resolution(stops_.front().event);
  shorter_ = vanishes || interval <= shorter * last_interval_ ? shorter_ + 1 : 0;
  if (shorter_ == 0) shorter_since_ = last_stop_;
  last_stop_ = t_;
  last_interval_ = interval;
  if (shorter_ < many_shorter || (!vanishes && interval > short_time * (t_ - shorter_since_))) return;
  char last[32];
  std::snprintf(last, sizeof last, "%.2g", interval);
  throw StepSizeError(
      "event", "event '" + watch_.event(stops_.front().event).name + "' comes after ever shorter times, at last " +
                   last +
                   " s: infinitely many would come before the run goes on; make it terminal, or let its "
                   "change end the run when what bounces has become slow");
}

}  // namespace linkwork
