#include "linkwork/integration/touch_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double beside = 1e-4;  // of a step, for differences in time
// Of the second derivatives of a cubic, what those of the motion may be more: in an oscillation up to 4 rad and 2.5
// rad.
constexpr double more_in_step = 1.5, more_inside = 0.5;
constexpr std::array<double, 3> places = {0.25, 0.5, 0.75};  // of a step, that are looked at anyway
constexpr double inside = 0.1;                               // of an interval: no nearer to its ends
constexpr double nearly_straight = 2.0;   // second derivatives up to so many times of what d rises by: it does so once
constexpr double narrowest = 1e-10;       // of a step: what touches for as long is grazed
constexpr int most_looks = 400;           // in a step, at least:
constexpr int most_work = 3000000;        // looks at a limit that moves, by all bodies, whose state each look makes
constexpr int parts = 16, halvings = 30;  // of a step that is to be clear

using Place = TouchSearch::Place;

/// The highest of a + a' s + M s^2 / 2 up to s = `to`.
Place highest_on_parabola(double a, double rate, double M, double to) {
  const auto at = [&](double s) { return Place{s, a + s * (rate + 0.5 * M * s)}; };
  Place best = at(to).value > a ? at(to) : at(0.0);
  if (const double top = -rate / M; M < 0.0 && top > 0.0 && top < to) best = at(top);
  return best;
}

/// A bound of the second derivative, at s from 0 to 1, of what is about a cubic.
double bend(double a, double a_rate, double b, double b_rate, double more) {
  const double first = 2.0 * (3.0 * (b - a) - 2.0 * a_rate - b_rate);
  const double last = -2.0 * (3.0 * (b - a) - a_rate - 2.0 * b_rate);
  return std::max(first, last) + more * std::max(std::abs(first), std::abs(last));
}

/// The highest of what is below both parabolas, at s from 0 to 1.
Place highest_between(double a, double a_rate, double b, double b_rate, double M) {
  const double closing = a_rate - b_rate + M;
  const double meeting = closing > 0.0 ? std::clamp((b - a - b_rate + 0.5 * M) / closing, 0.0, 1.0) : 0.5;
  const Place before = highest_on_parabola(a, a_rate, M, meeting);
  const Place after = highest_on_parabola(b, -b_rate, M, 1.0 - meeting);
  return before.value > after.value ? before : Place{1.0 - after.at, after.value};
}

}  // namespace

TouchSearch::TouchSearch(const Dynamics& dynamics, double least)
    : dynamics_(dynamics),
      least_(least),
      approach_(dynamics.system().model()),
      count_(dynamics.system().switches().size()) {}

void TouchSearch::begin(const VectorXd& y, const VectorXd& switches, const std::vector<char>& sides) {
  if (count_ == 0) return;
  y_ = y;
  at_begin_ = switches;
  sides_ = sides;
  if (!sides_.empty()) return;
  for (Eigen::Index k = 0; k < switches.size(); ++k) sides_.push_back(switches[k] > 0.0);
}

bool TouchSearch::suspects(const StepEnds& step, const VectorXd& switches) {
  suspects_.clear();
  t_ = step.t;
  h_ = step.h;
  std::optional<Look> from, to;
  for (int k = 0; k < static_cast<int>(count_); ++k) {
    const double a = at_begin_[k], b = switches[k], free = std::max(least_, a);
    if (sides_[static_cast<std::size_t>(k)] || b > free) continue;
    if (!(0.5 * (a + b + approach_.largest_change(k, step)) + approach_.limit(k).amplitude > free)) continue;
    if (!from) {
      from = Look{t_, 0.0, h_, y_};
      to = Look{t_ + h_, 1.0, h_, step.y_new};
      look_beside(*from);
      look_beside(*to);
    }
    Suspect it{k, approach_.of_spheres(k) ? a + approach_.distance(k, y_) : 0.0, 0.0, {}, {}};
    it.free = value(it, free);
    it.from = sample(*from, it);
    it.to = sample(*to, it);
    if (highest(it, it.from, it.to, more_in_step).value > it.free) suspects_.push_back(it);
  }
  return !suspects_.empty();
}

std::vector<TouchSearch::Touch> TouchSearch::find(const Interpolant& step) {
  std::vector<Touch> found;
  if (suspects_.empty()) return found;
  const int at_moving_limit = std::max(most_looks, most_work / (10 + dynamics_.system().body_count()));
  std::vector<Look> looks;
  for (const double theta : places) looks.push_back(look_at(step, theta));
  for (const Suspect& it : suspects_) {
    const Approach::Limit& limit = approach_.limit(it.which);
    looks_left_ = limit.function ? at_moving_limit : most_looks;
    std::vector<Sample> samples = {it.from};
    for (const Look& look : looks) samples.push_back(sample(look, it));
    for (auto t = std::upper_bound(limit.breaks.begin(), limit.breaks.end(), t_);
         t != limit.breaks.end() && *t < t_ + h_; ++t)
      samples.push_back(sample(look_at(step, (*t - t_) / h_), it));
    samples.push_back(it.to);
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.theta < b.theta; });
    for (std::size_t p = 1; p < samples.size(); ++p)
      if (const auto theta = first_touch(step, it, samples[p - 1], samples[p])) {
        found.push_back({it.which, *theta});
        break;
      }
  }
  std::sort(found.begin(), found.end(), [](const Touch& a, const Touch& b) { return a.theta < b.theta; });
  return found;
}

std::optional<double> TouchSearch::first_touch(const Interpolant& step, const Suspect& of, const Sample& a,
                                               const Sample& b) {
  if (b.value > of.free) {
    if (!may_come_and_go(of, a, b)) return b.theta;
    const Sample between = look_between(step, of, a, b, 0.5);
    if (const auto found = first_touch(step, of, a, between)) return found;
    return first_touch(step, of, between, b);
  }
  const Place top = highest(of, a, b, more_inside);
  if (!(top.value > of.free) || b.theta - a.theta < narrowest) return {};
  if (looks_left_ == 0 && !approach_.limit(of.which).function) return {};
  const Sample between = look_between(step, of, a, b, std::clamp(top.at, inside, 1.0 - inside));
  if (const auto found = first_touch(step, of, a, between)) return found;
  return first_touch(step, of, between, b);
}

/// Between two places.
Place TouchSearch::highest(const Suspect& of, const Sample& a, const Sample& b, double more) const {
  const double width = b.theta - a.theta;
  const double M =
      bend(a.at_rest, width * a.rate_at_rest, b.at_rest, width * b.rate_at_rest, more) + bend_of_limit(of, a, b);
  if (!std::isfinite(M)) return {0.5, INFINITY};
  return highest_between(a.value, width * a.rate, b.value, width * b.rate, M);
}

/// What the second derivative of its limit is at most, over that interval; infinite where there is a break inside.
double TouchSearch::bend_of_limit(const Suspect& of, const Sample& a, const Sample& b) const {
  const Approach::Limit& limit = approach_.limit(of.which);
  if (!limit.function) return 0.0;
  const double from = t_ + a.theta * h_, to = t_ + b.theta * h_, slack = narrowest * h_;
  const auto next = std::upper_bound(limit.breaks.begin(), limit.breaks.end(), from + slack);
  if (next != limit.breaks.end() && *next < to - slack) return INFINITY;
  return (to - from) * (to - from) * limit.function->largest_acceleration(from, to);
}

/// Whether there may be a touch before the one that there is at b, and the bodies be apart in between.
bool TouchSearch::may_come_and_go(const Suspect& of, const Sample& a, const Sample& b) const {
  return bend_of_limit(of, a, b) > nearly_straight * (b.value - a.value) && b.theta - a.theta > narrowest;
}

TouchSearch::Sample TouchSearch::look_between(const Interpolant& step, const Suspect& of, const Sample& a,
                                              const Sample& b, double place) {
  look_for_interruption();
  if (looks_left_-- <= 0) refuse(of);
  return sample(look_at(step, a.theta + (b.theta - a.theta) * place), of);
}

void TouchSearch::refuse(const Suspect& of) const {
  const int element = approach_.owner(of.which).element;
  const Model& model = dynamics_.system().model();
  const std::string& kind = force_kinds()[model.forces()[static_cast<std::size_t>(element)].kind].info.name;
  const std::string name = model.force_names().name(element);
  char step[32];
  std::snprintf(step, sizeof step, "%.3g s", h_);
  ErrorDetails details;
  details.forces = {name};
  throw StepSizeError("touches",
                      kind + " '" + name + "': its end comes and goes too often to be followed through a step of " +
                          step + ": give a shorter step (step=), or an end that moves less often",
                      details);
}

TouchSearch::Look TouchSearch::look_at(const Interpolant& step, double theta) const {
  Look out{t_ + theta * h_, theta, h_, {}};
  step.interpolate(dynamics_.system(), theta, out.y);
  look_beside(out);
  return out;
}

/// Later than the start of the step, earlier than any other place.
void TouchSearch::look_beside(Look& look) const {
  const System& system = dynamics_.system();
  const int nq = system.q_size();
  VectorXd q_dot(nq);
  system.position_rates(look.y.head(nq), look.y.segment(nq, system.v_size()), q_dot);
  look.beside = look.theta > 0.0 ? -beside * look.h : beside * look.h;
  look.q_beside = look.y.head(nq) + look.beside * q_dot;
  look.q_beyond = look.y.head(nq) + 2.0 * look.beside * q_dot;
  system.normalize(look.q_beside);
  system.normalize(look.q_beyond);
}

double TouchSearch::depth(double t, const ConstVector& q, const ConstVector& v, int which) {
  const SwitchOwner& owner = approach_.owner(which);
  ForceElement& element = elements_.try_emplace(which, dynamics_.system(), owner.element).first->second;
  return element.switches(t, q, v, dynamics_.history())[static_cast<std::size_t>(owner.place)];
}

/// The rate by a difference that is exact for parabolas.
TouchSearch::Sample TouchSearch::sample(const Look& look, const Suspect& of) {
  const System& system = dynamics_.system();
  const Approach::Limit& limit = approach_.limit(of.which);
  const auto value_at = [&](double after, const ConstVector& q) {
    const double t = limit.function ? t_ : look.t + after;
    return value(of, depth(t, q, look.y.segment(system.q_size(), system.v_size()), of.which));
  };
  const double here = value_at(0.0, look.y.head(system.q_size()));
  const double near = value_at(look.beside, look.q_beside), far = value_at(2.0 * look.beside, look.q_beyond);
  const double rate = look.h * (4.0 * near - 3.0 * here - far) / (2.0 * look.beside);
  Sample out{look.theta, here, rate, here, rate};
  if (limit.function) move_limit(look, limit, out);
  return out;
}

void TouchSearch::move_limit(const Look& look, const Approach::Limit& limit, Sample& sample) const {
  const Signal<double> here = limit.function->evaluate(look.t), at_start = limit.function->evaluate(t_);
  sample.value += limit.sign * (here.value - at_start.value);
  sample.rate += limit.sign * look.h * here.rate;
}

double TouchSearch::clear_until(const Interpolant& step, const StepEnds& ends) {
  if (count_ == 0) return 1.0;
  begin(ends.y, depths(ends.t, ends.y), dynamics_.sides());
  double last = 0.0, first = INFINITY;
  if (suspects(ends, depths(ends.t + ends.h, ends.y_new)))
    if (const std::vector<Touch> found = find(step); !found.empty()) first = found.front().theta;
  for (int k = 1; k <= parts && last < first; ++k) {
    const double theta = std::min(static_cast<double>(k) / parts, first);
    if (theta == first || !clear_at(step, theta)) first = theta;
    else last = theta;
  }
  if (first > 1.0) return 1.0;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (last + first);
    (clear_at(step, middle) ? last : first) = middle;
  }
  return last;
}

bool TouchSearch::clear_at(const Interpolant& step, double theta) {
  VectorXd y;
  step.interpolate(dynamics_.system(), theta, y);
  const VectorXd now = depths(t_ + theta * h_, y);
  for (Eigen::Index k = 0; k < now.size(); ++k)
    if ((sides_[static_cast<std::size_t>(k)] ? -now[k] : now[k]) > least_) return false;
  return true;
}

VectorXd TouchSearch::depths(double t, const VectorXd& y) {
  const System& system = dynamics_.system();
  VectorXd out(static_cast<Eigen::Index>(count_));
  for (Eigen::Index k = 0; k < out.size(); ++k)
    out[k] = depth(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()), static_cast<int>(k));
  return out;
}

double TouchSearch::rate(Look look, int which) {
  look_beside(look);
  return sample(look, {which, 0.0, 0.0, {}, {}}).rate / look.h;
}

}  // namespace linkwork
