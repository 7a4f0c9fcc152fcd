#include "linkwork/integration/singular_pose_search.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/integration/hermite_step.hpp"
#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double passed = 0.9;       // of the usual root of pivots: a pose was passed only if the least is below
constexpr double away = 1e-3;        // of the same: as far the motion has been from the last pose
constexpr double vanishing = 0.1;    // value in the pose, part of the least around it
constexpr double found = 1e-6;       // the same, for the search to end
constexpr double at_rest = 1e-4;     // of the usual root of pivots: at the end of the motion
constexpr double same_pose = 1e-2;   // relative to the time between states
constexpr double golden = 0.381966;  // part of the larger side of a bracket
constexpr double places_beside[] = {0.02, 0.08, 0.25, 0.55,
                                    1.0};  // of the way from a pose: between them another may be
constexpr double no_zero = 0.7;            // a guess that lowers the least by no more finds no zero
constexpr int most_guesses = 24, few_guesses = 4;

/// |log| of the ratio of two slopes.
double mismatch(double rise, double run, double other_rise, double other_run) {
  return std::abs(elementary::logarithm(rise / run * other_run / other_rise));
}

}  // namespace

// The value is taken for linear on both sides of its zero; b is on one of them, that with which both slopes agree
// better. Where that does not close in, by golden section.
SingularValueAt least_value(SingularValueAt a, SingularValueAt b, SingularValueAt c,
                            const std::function<double(double)>& value_at) {
  const double around = std::min(a.value, c.value);
  for (int k = 0; k < most_guesses && b.value > found * around; ++k) {
    const double left = b.at - a.at, right = c.at - b.at;
    const bool zero_is_left = !(mismatch(a.value + b.value, left, c.value - b.value, right) >
                                mismatch(b.value + c.value, right, a.value - b.value, left));
    double at =
        zero_is_left ? a.at + left * a.value / (a.value + b.value) : b.at + right * b.value / (b.value + c.value);
    if (k % 3 == 2) at = right > left ? b.at + golden * right : b.at - golden * left;
    if (!(at > a.at && at < c.at) || at == b.at) break;
    const SingularValueAt guess{at, value_at(at)};
    if (k >= few_guesses && std::min(guess.value, b.value) > no_zero * around) break;
    if (guess.value < b.value) {
      (at < b.at ? c : a) = b;
      b = guess;
    } else {
      (at < b.at ? a : c) = guess;
    }
  }
  return b;
}

bool vanishes(const SingularValueAt& a, const SingularValueAt& least, const SingularValueAt& c) {
  return least.value <= vanishing * std::min(a.value, c.value);
}

namespace {

/// Between a zero and the end of a way from it: the value is looked at in places, closer ones near the zero, and between
/// them where lines down to another zero would meet.
void append_other_zeros(const SingularValueAt& zero, const SingularValueAt& end,
                        const std::function<double(double)>& value_at, std::vector<SingularValueAt>& zeros) {
  const auto place = [&](double part) { return zero.at + part * (end.at - zero.at); };
  std::vector<SingularValueAt> samples = {zero};
  for (const double part : places_beside) {
    const SingularValueAt next = part < 1.0 ? SingularValueAt{place(part), value_at(place(part))} : end;
    const SingularValueAt last = samples.back();
    if (samples.size() > 1 && last.value > 0.0 && next.value > 0.0) {
      const double at = last.at + (next.at - last.at) * last.value / (last.value + next.value);
      samples.push_back({at, value_at(at)});
    }
    samples.push_back(next);
  }
  if (end.at < zero.at) std::reverse(samples.begin(), samples.end());
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const SingularValueAt &a = samples[k - 1], &b = samples[k], &c = samples[k + 1];
    if (!(b.value < a.value && b.value < c.value)) continue;
    if (const SingularValueAt least = least_value(a, b, c, value_at); vanishes(a, least, c)) zeros.push_back(least);
  }
}

}  // namespace

std::vector<SingularValueAt> zeros_around(const SingularValueAt& zero, const SingularValueAt& before,
                                          const SingularValueAt& after, const std::function<double(double)>& value_at) {
  std::vector<SingularValueAt> zeros;
  if (before.at < zero.at) append_other_zeros(zero, before, value_at, zeros);
  zeros.push_back(zero);
  if (after.at > zero.at) append_other_zeros(zero, after, value_at, zeros);
  return zeros;
}

void SingularPoseSearch::restart(bool away) {
  count_ = 0;
  highest_ = 0.0;
  away_ = away;
}

bool SingularPoseSearch::worth_a_search(double value) const {
  const double level = dynamics_.formulation().usual_root();
  return value < passed * level && (highest_ > away * level || away_);
}

bool SingularPoseSearch::pass(double t, double value, const VectorXd& y, int parts) {
  if (count_ == 0 || parts == 1) return mark(t, value, y);
  const Mark before = marks_[2], after{t, value, y};
  for (int k = 1; k < parts; ++k) {
    Mark between{before.t + (t - before.t) * k / parts, 0.0, {}};
    interpolate(before, after, between.t, between.y);
    between.value = value_at(between.t, between.y);
    mark(between.t, between.value, between.y);
  }
  mark(t, value, y);
  return true;
}

bool SingularPoseSearch::mark(double t, double value, const VectorXd& y) {
  auto& [a, b, c] = marks_;
  std::swap(earlier_, a);
  std::swap(a, b);
  std::swap(b, c);
  c.t = t;
  c.value = value;
  c.y = y;
  count_ = std::min(count_ + 1, 4);
  highest_ = std::max(highest_, c.value);
  if (count_ < 2 || !worth_a_search(b.value)) return false;
  if (count_ == 2) search_between(b, c);
  else if (b.value <= a.value && b.value < c.value) search_around();
  else if (last_listed_ > a.t) search_next();
  else return false;
  return true;
}

SingularValueAt SingularPoseSearch::sample(const Mark& mark) { return {mark.t, value_at(mark.t, mark.y)}; }

/// The roots of pivots lead here, the singular values go on. Of two poses near each other one may be before the three.
void SingularPoseSearch::search_around() {
  const auto& [a, b, c] = marks_;
  const SingularValueAt from = sample(a), middle = sample(b), to = sample(c);
  if (count_ > 3) search_single(sample(earlier_), from);
  if (middle.value <= std::min(from.value, to.value)) search(from, middle, to);
  else if (!search_single(from, middle)) search_single(middle, to);
}

/// Or after them.
void SingularPoseSearch::search_next() { search_single(sample(marks_[1]), sample(marks_[2])); }

SingularValueAt SingularPoseSearch::sample_between(const SingularValueAt& a, const SingularValueAt& c, double part) {
  const double t = a.at + (c.at - a.at) * part;
  interpolate(t, y_);
  return {t, value_at(t, y_)};
}

/// A zero that is the only one between; true where a pose was listed.
bool SingularPoseSearch::search_single(const SingularValueAt& a, const SingularValueAt& c) {
  if (!(a.value > 0.0 && c.value > 0.0)) return false;
  const SingularValueAt b = sample_between(a, c, a.value / (a.value + c.value));
  return b.value < no_zero * std::min(a.value, c.value) && search(a, b, c);
}

/// The same of states that follow each other: at some places, at that of a single zero, and beside the ends.
bool SingularPoseSearch::search_between(const Mark& before, const Mark& after) {
  const SingularValueAt a{before.t, value_at(before.t, before.y)}, c{after.t, value_at(after.t, after.y)};
  const auto between = [&](double part) { return sample_between(a, c, part); };
  std::array<SingularValueAt, 6> samples = {a, a, between(0.25), between(0.5), between(0.75), c};
  if (a.value > 0.0 && c.value > 0.0) samples[1] = between(a.value / (a.value + c.value));
  std::sort(samples.begin(), samples.end(),
            [](const SingularValueAt& a, const SingularValueAt& b) { return a.at < b.at; });
  bool listed = samples[0].value < samples[1].value && search_single(samples[0], samples[1]);
  for (std::size_t k = 1; k + 1 < samples.size(); ++k)
    if (samples[k].value < samples[k - 1].value && samples[k].value < samples[k + 1].value)
      listed = search(samples[k - 1], samples[k], samples[k + 1]) || listed;
  return (samples[5].value < samples[4].value && search_single(samples[4], samples[5])) || listed;
}

double SingularPoseSearch::look_to(double t, const VectorXd& y, int parts) {
  const double value = value_at(t, y);
  if (count_ == 0 || marks_[2].t < t) pass(t, value, y, parts);
  if (count_ > 1 && value < marks_[1].value && worth_a_search(value)) search_between(marks_[1], marks_[2]);
  return value;
}

void SingularPoseSearch::finish(double t, const VectorXd& y, int parts) {
  const double value = look_to(t, y, parts);
  const double level = dynamics_.formulation().usual_root();
  if (!(value < at_rest * level && highest_ > away * level)) return;
  value_at(t, y);
  if (dynamics_.formulation().cross(y.head(dynamics_.system().q_size()), value * value)) highest_ = 0.0;
}

void SingularPoseSearch::list(double t, const VectorXd& y) {
  const double value = value_at(t, y);
  dynamics_.formulation().cross(y.head(dynamics_.system().q_size()), value * value);
  restart();
  last_listed_ = t;
}

double SingularPoseSearch::value_at(double t, const VectorXd& y) {
  dynamics_.observe_now();  // what waits for a solution is not to get it from here
  const Unwatched unwatched(dynamics_);
  dynamics_.evaluate(t, y);
  return dynamics_.formulation().least_singular_value();
}

bool SingularPoseSearch::search(SingularValueAt a, SingularValueAt b, SingularValueAt c) {
  const auto value = [this](double t) {
    interpolate(t, y_);
    return value_at(t, y_);
  };
  const SingularValueAt least = least_value(a, b, c, value);
  if (!vanishes(a, least, c) || least.at <= last_listed_ + same_pose * (c.at - a.at)) return false;
  bool listed = false;
  for (const SingularValueAt& zero : zeros_around(least, a, c, value))
    if (zero.at > last_listed_) listed = list_zero(zero) || listed;
  return listed;
}

bool SingularPoseSearch::list_zero(const SingularValueAt& zero) {
  interpolate(zero.at, y_);
  const double value = value_at(zero.at, y_);
  if (!dynamics_.formulation().cross(y_.head(dynamics_.system().q_size()), value * value)) return false;
  highest_ = marks_[2].value;
  away_ = false;
  last_listed_ = zero.at;
  return true;
}

void SingularPoseSearch::interpolate(double t, VectorXd& y) const {
  if (count_ < 3 || t >= marks_[1].t) interpolate(marks_[1], marks_[2], t, y);
  else if (t >= marks_[0].t) interpolate(marks_[0], marks_[1], t, y);
  else interpolate(earlier_, marks_[0], t, y);
}

void SingularPoseSearch::interpolate(const Mark& from, const Mark& to, double t, VectorXd& y) const {
  const System& system = dynamics_.system();
  const double h = to.t - from.t;
  HermiteStep(system, from.y, to.y, h).interpolate(system, (t - from.t) / h, y);
}

}  // namespace linkwork
