#include "linkwork/integration/break_points.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace linkwork {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double same = 64 * ulp, beside = 4 * ulp;  // relative to t
constexpr double same_time = 1e-9;                   // relative to the step
constexpr double smaller = 10.0;                     // so many times the estimate an error may be
constexpr double roundoff = 1e-13;
constexpr double sliver = 1e-2;  // of a step

double distance(double relative, double t) {
  return std::max(relative * std::abs(t), std::numeric_limits<double>::min());
}

}  // namespace

BreakPoints::BreakPoints(const Model& model, const std::vector<double>& given) {
  std::vector<Break> breaks;
  for (const TimeFunctionPtr& signal : model.signals())
    if (signal->of_time()) signal->add_breaks(breaks);
  for (const std::vector<double>* times : {&model.breaks(), &given})
    for (const double t : *times) breaks.push_back({t});
  std::sort(breaks.begin(), breaks.end(), [](const Break& a, const Break& b) { return a.t < b.t; });
  for (const Break& it : breaks) {
    if (it.ends_step) add_end(it.t);
    else knots_.push_back(it.t);
  }
  if (!knots_.empty()) add_watched(model);
}

BreakPoints::BreakPoints(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  for (const double t : times) add_end(t);
}

/// The latest so far.
void BreakPoints::add_end(double t) {
  if (!ends_.empty() && t - ends_.back().last <= distance(same, t)) ends_.back().last = t;
  else ends_.push_back({t, t});
}

void BreakPoints::meet_steps(double origin, double h, std::array<double, 2> ends) {
  for (Cluster& it : ends_) {
    const Cluster given = it;
    const double slack = same_time * h + distance(same, given.last);
    for (const double t : {origin + std::round((given.first - origin) / h) * h, ends[0], ends[1]}) {
      if (t < given.first - slack || t > given.last + slack) continue;
      it.first = std::min(it.first, t);
      it.last = std::max(it.last, t);
    }
  }
  merge();
}

/// Those that have come to overlap.
void BreakPoints::merge() {
  std::vector<Cluster> apart;
  for (const Cluster& it : ends_) {
    if (!apart.empty() && it.first <= apart.back().last) apart.back().last = std::max(apart.back().last, it.last);
    else apart.push_back(it);
  }
  ends_ = std::move(apart);
}

void BreakPoints::add_watched(const Model& model) {
  std::vector<char> drives(model.signals().size(), 0);
  for (const Parameter& parameter : model.joint_parameters())
    if (parameter.signal >= 0) drives[parameter.signal] = 1;
  for (std::size_t s = 0; s < drives.size(); ++s)
    if (model.signals()[s]->of_time()) model.signals()[s]->add_watched(drives[s] != 0, watched_);
}

std::vector<double> BreakPoints::times() const {
  std::vector<double> out;
  for (const Cluster& it : ends_) {
    out.push_back(it.first);
    if (it.last > it.first) out.push_back(it.last);
  }
  return out;
}

const BreakPoints::Cluster* BreakPoints::following(double t) const {
  const auto found =
      std::upper_bound(ends_.begin(), ends_.end(), t, [](double a, const Cluster& b) { return a < b.first; });
  return found == ends_.end() ? nullptr : &*found;
}

const BreakPoints::Cluster* BreakPoints::find(double t) const {
  const auto found =
      std::lower_bound(ends_.begin(), ends_.end(), t, [](const Cluster& a, double b) { return a.last < b; });
  return found != ends_.end() && found->first <= t ? &*found : nullptr;
}

double BreakPoints::next(double t) const {
  const Cluster* found = following(t);
  return found ? found->first : std::numeric_limits<double>::infinity();
}

double BreakPoints::room(double t, double h) const {
  const Cluster* found = following(t + same_time * h);
  if (!found) return std::numeric_limits<double>::infinity();
  return std::min(before(found->first) - t, std::floor((found->first - t) / h + same_time) * h);
}

double BreakPoints::after(double t) const {
  const Cluster* found = find(t);
  return found ? found->last + distance(beside, found->last) : t;
}

double BreakPoints::before(double t) const {
  const Cluster* found = find(t);
  return found ? found->first - distance(beside, found->first) : t;
}

StepSpan BreakPoints::span(double t, double t_new) const {
  StepSpan out{t, t_new - t};
  if (at(t)) out.earliest = after(t);
  if (at(t_new)) out.latest = std::max(before(t_new), out.at(0.0));
  return out;
}

double BreakPoints::next_knot(double t) const {
  const auto found = std::upper_bound(knots_.begin(), knots_.end(), t);
  return found == knots_.end() ? std::numeric_limits<double>::infinity() : *found;
}

double BreakPoints::only_knot(double t, double t_new) const {
  const auto first = std::upper_bound(knots_.begin(), knots_.end(), t + sliver * (t_new - t));
  if (first == knots_.end() || *first >= t_new) return t_new;
  return first + 1 == knots_.end() || first[1] >= t_new ? *first : t_new;
}

bool BreakPoints::seen(const EmbeddedPair& pair, const StepSpan& step, double relative) const {
  if (watched_.empty() || next_knot(step.t) >= step.t + step.h) return true;
  return std::all_of(watched_.begin(), watched_.end(),
                     [&](const TimeFunctionPtr& function) { return seen(*function, pair, step, relative); });
}

// With F'' = f:   F'(t + h) - F'(t) = h sum b_i f_i + error,   F(t + h) - F(t) - h F'(t) = h^2 sum b_i (1 - c_i) f_i +
// error, what a force f does to a velocity and to a position.
bool BreakPoints::seen(const TimeFunction& function, const EmbeddedPair& pair, const StepSpan& step, double relative) {
  const ButcherTableau& method = pair.method;
  const double h = step.h;
  const Signal<double> start = function.evaluate(step.at(0.0)), end = function.evaluate(step.at(1.0));
  double first = 0.0, second = 0.0, estimate = 0.0, impulse = 0.0;
  for (Eigen::Index i = 0; i < method.c.size(); ++i) {
    const double f = function.evaluate(step.at(method.c[i])).acceleration;
    first += h * method.b[i] * f;
    second += h * h * method.b[i] * (1.0 - method.c[i]) * f;
    estimate += h * pair.error[i] * f;
    impulse += h * std::abs(method.b[i] * f);
  }
  estimate = std::abs(estimate + h * pair.error[method.c.size()] * end.acceleration);
  const double noise = roundoff * (std::abs(start.rate) + std::abs(end.rate));
  const double position_noise = roundoff * (std::abs(start.value) + std::abs(end.value));
  const double allowed = smaller * estimate + relative * impulse + noise;
  return std::abs(end.rate - start.rate - first) <= allowed &&
         std::abs(end.value - start.value - h * start.rate - second) <= h * allowed + position_noise;
}

}  // namespace linkwork
