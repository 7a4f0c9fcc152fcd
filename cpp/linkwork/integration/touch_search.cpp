#include "linkwork/integration/touch_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace linkwork {
namespace {

constexpr double beside = 1e-4;                                   // of a step, for differences in time
constexpr std::array<double, 4> places = {0.25, 0.5, 0.75, 1.0};  // of a step: between two a depth rises and falls once
constexpr double inside = 1e-2;                                   // of an interval: no nearer to its ends
constexpr int most_looks = 40, every_other = 3;

}  // namespace

TouchSearch::TouchSearch(const Dynamics& dynamics, double least) : dynamics_(dynamics), least_(least) {
  if (!dynamics.system().switches().empty()) at_ = dynamics.system().make_evaluation();
  q_dot_.resize(dynamics.system().q_size());
}

void TouchSearch::begin(const VectorXd& y, const VectorXd& switches) {
  if (dynamics_.system().switches().empty()) return;
  const auto is_at_y = [&](const Mark& mark) { return mark.y.size() == y.size() && mark.y == y; };
  if (is_at_y(to_)) {
    std::swap(from_, to_);
  } else if (!is_at_y(from_)) {
    from_.y = y;
    from_.rates.resize(0);
  }
  from_.values = switches;
  to_.y.resize(0);
}

/// By a difference: of poses some `seconds` later, or earlier, along the motion.
void TouchSearch::find_rates(double t, double seconds, Mark& mark) {
  const System& system = dynamics_.system();
  const int nq = system.q_size();
  const auto v = mark.y.segment(nq, system.v_size());
  system.position_rates(mark.y.head(nq), v, q_dot_);
  moved_ = mark.y.head(nq) + seconds * q_dot_;
  system.normalize(moved_);
  system.evaluate_switches(t + seconds, moved_, v, dynamics_.history(), at_);
  mark.rates = (at_.switches - mark.values) / seconds;
}

bool TouchSearch::suspects(double t, double h, const VectorXd& y_new, const VectorXd& switches) {
  suspects_.clear();
  if (dynamics_.system().switches().empty()) return false;
  to_.values = switches;
  if (!((from_.values.array() < 0.0) && (to_.values.array() < 0.0)).any()) return false;
  to_.y = y_new;
  if (from_.rates.size() == 0) find_rates(t, beside * h, from_);
  find_rates(t + h, -beside * h, to_);
  for (int k = 0; k < from_.values.size(); ++k) {
    const Sample a{0.0, from_.values[k], h * from_.rates[k]}, b{1.0, to_.values[k], h * to_.rates[k]};
    if (a.value < 0.0 && b.value < 0.0 && may_touch(a, b)) suspects_.push_back(k);
  }
  return !suspects_.empty();
}

double TouchSearch::rate_at_end(double t, double h, const VectorXd& y_new, int which) {
  between_.y = y_new;
  between_.values = dynamics_.evaluation().switches;
  find_rates(t + h, -beside * h, between_);
  return between_.rates[which];
}

TouchSearch::Sample TouchSearch::where_tangents_meet(const Sample& a, const Sample& b) {
  const double width = b.theta - a.theta;
  const double part = (b.value - a.value - b.rate * width) / (a.rate - b.rate);
  return {a.theta + part, a.value + a.rate * part, 0.0};
}

/// One that does not rise and fall has its most at an end, unless the cubic of both ends says otherwise.
bool TouchSearch::may_touch(const Sample& a, const Sample& b) const {
  if (rises_and_falls(a, b)) return where_tangents_meet(a, b).value > least_;
  const double width = b.theta - a.theta;
  return std::any_of(places.begin(), places.end() - 1, [&](double s) {
    const double r = 1.0 - s;
    return r * r * ((1.0 + 2.0 * s) * a.value + s * width * a.rate) +
               s * s * ((1.0 + 2.0 * r) * b.value - r * width * b.rate) >
           least_;
  });
}

void TouchSearch::look(const Interpolant& step, double t, double h, double theta, Mark& mark) {
  const System& system = dynamics_.system();
  const int nq = system.q_size();
  step.interpolate(system, theta, mark.y);
  system.evaluate_switches(t + theta * h, mark.y.head(nq), mark.y.segment(nq, system.v_size()), dynamics_.history(),
                           at_);
  mark.values = at_.switches;
  find_rates(t + theta * h, -beside * h, mark);
}

/// NaN: there is none.
double TouchSearch::touch_between(const Interpolant& step, double t, double h, int which, Sample a, Sample b) {
  for (int k = 1; k <= most_looks && rises_and_falls(a, b); ++k) {
    const Sample meeting = where_tangents_meet(a, b);
    if (!(meeting.value > least_)) break;
    const double width = b.theta - a.theta, near = inside * width;
    const double theta =
        k % every_other == 0 ? a.theta + 0.5 * width : std::clamp(meeting.theta, a.theta + near, b.theta - near);
    look(step, t, h, theta, between_);
    const Sample sample{theta, between_.values[which], h * between_.rates[which]};
    if (sample.value > least_) return theta;
    (sample.rate > 0.0 ? a : b) = sample;
  }
  return NAN;
}

std::vector<TouchSearch::Touch> TouchSearch::find(const Interpolant& step, double t, double h) {
  std::vector<Touch> found;
  if (suspects_.empty()) return found;
  std::array<Mark, places.size()> marks;
  for (std::size_t p = 0; p + 1 < places.size(); ++p) look(step, t, h, places[p], marks[p]);
  marks.back() = to_;
  for (const int k : suspects_) {
    Sample a{0.0, from_.values[k], h * from_.rates[k]};
    for (std::size_t p = 0; p < places.size(); ++p) {
      const Sample b{places[p], marks[p].values[k], h * marks[p].rates[k]};
      const double theta = b.value > least_ ? b.theta : touch_between(step, t, h, k, a, b);
      if (!std::isnan(theta)) {
        found.push_back({k, theta});
        break;
      }
      a = b;
    }
  }
  std::sort(found.begin(), found.end(), [](const Touch& a, const Touch& b) { return a.theta < b.theta; });
  return found;
}

}  // namespace linkwork
