#include "linkwork/integration/error_growth.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "linkwork/integration/log_smoothness.hpp"
#include "linkwork/math/brent.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double fewest_errors = 1.0, most_errors = 6.0;
constexpr std::size_t enough_errors = 4;  // to know how others grow, which may be more
// From one state to the next, at most: of lengths, speeds and angles; rate of an error times the time between.
constexpr double near = 0.25, resolved = 0.6;
// By how much two stages of a step may differ, relative to the error; far beyond the step is taken again in parts.
constexpr double usual_difference = 5e-3, fine_difference = 4e-5, too_far = 10.0;
// Share of a way, or depth relative to what it is at the other end: there touches begin or end where the way does.
constexpr double at_end = 1e-6;
constexpr double vanished = 1e-9;  // of an error
constexpr double most_parts = 64.0, least_way = 0.1, least_density = 0.5;
// Of what evaluations were enough for once, what they are for fewer errors.
constexpr double sure = 0.9;
// Steps for each that the motion alone would ask for; evaluations in one, of each error as errors begin later.
constexpr double usual_density = 2.0, of_motion = 2.0, of_error = 2.4;
// Growth, relative to that of regular motion, from which it is followed farther, and from which it is found again in
// finer steps; by so many times the evaluations.
constexpr double suspicious = 2.0, doubtful = 20.0;
constexpr std::int64_t more = 5, most_of_bodies = 1'500'000;  // evaluations of one

/// One of the errors.
struct Followed {
  std::size_t place;  ///< among the errors that were asked for
  VectorXd largest;   ///< of each part, relative to what it was, so far
  Perturbation now;
};

/// That of regular motion is in proportion to time.
double relative_growth(const ErrorGrowth& it, Eigen::Index part, const VectorXd& lengths, const VectorXd& speeds) {
  return it.of_part[part] / (1.0 + speeds[part] / lengths[part] * (it.until - it.t));
}

class GrowthSearch {
 public:
  GrowthSearch(Dynamics& dynamics, const StateLog& log, const MovingAxes& axes, const VectorXd& lengths,
               const VectorXd& speeds, double difference)
      : system_(dynamics.system()),
        connected_(ConnectedParts::of(system_)),
        log_(log),
        axes_(axes),
        lengths_(lengths),
        speeds_(speeds),
        most_difference_(difference),
        smoothness_(system_, log, axes, lengths, speeds),
        motion_(dynamics, lengths, speeds) {}

  struct Plan {
    std::size_t count;  ///< of errors to follow
    double until;       ///< [s]
  };

  /// What so many evaluations are enough for, as far as the motion tells.
  Plan plan(std::int64_t most) const {
    const double steps = static_cast<double>(most) / usual_density, fewest = of_motion + of_error * fewest_errors;
    double taken = 0.0;
    std::size_t k = 0;
    while (k + 1 < log_.size() && taken * fewest < steps) {
      const std::size_t following = next_state(k, INFINITY);
      taken += std::max(std::ceil(distance(k, following)), 1.0);
      k = following;
    }
    const double count = (steps / std::max(taken, 1.0) - of_motion) / of_error;
    return {static_cast<std::size_t>(std::clamp(count, fewest_errors, most_errors)), log_.t(k)};
  }

  std::vector<ErrorGrowth> find(const std::vector<StepDifference>& errors, std::int64_t most) {
    motion_.afford(most);
    std::vector<ErrorGrowth> out;
    succeeds([&] { return follow(errors, out); });
    leave_off(out);
    for (ErrorGrowth& it : out)
      if (it.until == it.t && !it.lost) it.until = reached_;  // it has vanished
    for (auto it = out.rbegin(); it != out.rend(); ++it)
      if (it->until < reached_) it->of_part.array() *= growth_beyond(it->until, out).array();
    return out;
  }

 private:
  static Eigen::Index r_of(int body) { return position_size * static_cast<Eigen::Index>(body); }
  static Eigen::Index v_of(int body) { return velocity_size * static_cast<Eigen::Index>(body); }

  /// As far as the log and the evaluations go.
  bool follow(const std::vector<StepDifference>& errors, std::vector<ErrorGrowth>& out) {
    std::size_t next = 0;
    if (!motion_.go_to(log_.t(0), log_.y(0), log_.history(0))) return false;
    reached_ = log_.t(0);
    for (std::size_t k = 0;;) {
      for (; next < errors.size() && errors[next].t <= log_.t(k); ++next)
        if (begin(out.size(), errors[next])) out.push_back({errors[next].t, errors[next].t, carried_.back().largest});
      if (k + 1 == log_.size()) return true;
      const std::size_t following = next_state(k, next < errors.size() ? errors[next].t : INFINITY);
      const bool goes_on = succeeds([&] { return carry(k, following); });
      drop_vanished(out);
      if (goes_on) {
        k = following;
        continue;
      }
      for (const Followed& it : carried_) out[it.place].lost = motion_.affords_more();
      leave_off(out);
      k = beyond(following);
      while (next < errors.size() && errors[next].t < log_.t(k)) ++next;
      if (next == errors.size() || k + 1 == log_.size() || !motion_.affords_more()) return false;
      reached_ = log_.t(k);
    }
  }

  /// Those of which nothing is left, as of a mechanism that drivers move, stay so.
  void drop_vanished(std::vector<ErrorGrowth>& out) {
    std::erase_if(carried_, [&](const Followed& it) {
      if (!(motion_.size(it.now).maxCoeff() <= vanished * it.now.first.maxCoeff())) return false;
      out[it.place].of_part = it.largest;
      return true;
    });
  }

  /// What is carried goes no farther.
  void leave_off(std::vector<ErrorGrowth>& out) {
    for (const Followed& it : carried_) {
      out[it.place].of_part = it.largest;
      out[it.place].until = reached_;
    }
    carried_.clear();
  }

  /// The first state from `k` on at which errors can begin anew, behind one where nothing is known of how they go on, as
  /// where a mechanism is singular or a law has a kink; or the last.
  std::size_t beyond(std::size_t k) {
    const auto goes_on = [&] { return motion_.go_to(log_.t(k), log_.y(k), log_.history(k)); };
    while (k + 1 < log_.size() && motion_.affords_more() && !succeeds(goes_on)) ++k;
    return k;
  }

  /// Whether that can be done. What interrupts the run is thrown.
  template <class Function>
  static bool succeeds(const Function& function) {
    try {
      return function();
    } catch (const std::exception& error) {  // functions of the user's throw what they like
      if (is_interruption(error)) throw;
      return false;
    }
  }

  /// Of each part, by which errors grow that begin later, where that is more than in regular motion: by about as much
  /// those grow that came there before.
  VectorXd growth_beyond(double t, const std::vector<ErrorGrowth>& all) const {
    VectorXd out = VectorXd::Ones(lengths_.size());
    for (const ErrorGrowth& it : all)
      for (Eigen::Index part = 0; it.t >= t && part < out.size(); ++part)
        if (relative_growth(it, part, lengths_, speeds_) > suspicious)
          out[part] = std::max(out[part], it.of_part[part]);
    return out;
  }

  bool begin(std::size_t place, const StepDifference& step) {
    std::optional<Perturbation> error = motion_.error(step);
    if (!error) return false;
    carried_.push_back({place, VectorXd::Ones(lengths_.size()), std::move(*error)});
    return true;
  }

  /// How far one state is from another, by what of that is resolved.
  double distance(std::size_t from, std::size_t k) const {
    double rate = 0.0;
    for (const Followed& it : carried_) rate = std::max(rate, it.now.rate);
    const double h = log_.t(k) - log_.t(from);
    double out = rate * h / resolved;
    const Eigen::Map<const VectorXd> y = log_.y(k), before = log_.y(from);
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      const Eigen::Index r = r_of(body), v = system_.q_size() + v_of(body);
      if (!(speeds_[part] > 0.0)) continue;
      Vec3<double> way = y.segment<3>(r) - before.segment<3>(r);
      if (!axes_.part.empty()) way -= h * axes_.velocity.col(part);
      out = std::max({out, way.norm() / (near * lengths_[part]),
                      2.0 * (y.segment<4>(r + 3) - before.segment<4>(r + 3)).norm() / near,
                      (y.segment<3>(v) - before.segment<3>(v)).norm() / (near * speeds_[part])});
    }
    return density_ * out;
  }

  /// The last one of the log, or up to a time, that is near enough.
  std::size_t next_state(std::size_t k, double until) const {
    std::size_t out = k + 1;
    const auto goes_on = [&] {
      return out + 1 < log_.size() && log_.t(out) < until && !log_.touches_about(k) && !log_.touches_about(out + 1) &&
             distance(k, out + 1) <= 1.0 && smoothness_.halfway(k, out + 1);
    };
    while (goes_on()) ++out;
    while (!smoothness_.everywhere(k, out)) out = k + (out - k + 1) / 2;
    return out;
  }

  /// All of them on to a state of the log, by some between where it is far, or where stages differ too much.
  bool carry(std::size_t k, std::size_t following) {
    const double way = distance(k, following) / density_, h = log_.t(following) - log_.t(k);
    const LinearizedMotion::Place first = motion_.place();
    if (!motion_.go_to(log_.t(following), log_.y(following), log_.history(following))) return false;
    const MovingState last = motion_.here();
    const VectorXd switches = motion_.place().switches;
    const std::vector<double> touches = touches_between(first, last, switches, k);
    motion_.go_back_to(first);
    double parts = std::max(std::ceil(density_ * way), 1.0), share = 0.0, worst = 0.0;
    while (share < 1.0) {
      if (!(parts <= most_parts * std::max(way, 1.0))) return false;
      const auto touch = std::upper_bound(touches.begin(), touches.end(), share);
      const double most = touch == touches.end() ? 1.0 : *touch;
      const double next = share + 1.5 / parts < most ? share + 1.0 / parts : most;
      const auto at = [&](double s) { return s == 1.0 ? last.y : quintic_between(system_, first.state, last, s); };
      const LinearizedMotion::Place before = motion_.place();
      std::vector<Followed> carried = carried_;
      if (!carry_to(log_.t(k) + h * next, at(next), at(0.5 * (share + next)), k)) return false;
      if (stages_apart_ > too_far * most_difference_) {
        motion_.go_back_to(before);
        carried_ = std::move(carried);
        parts *= 2.0;
        continue;
      }
      share = next;
      worst = std::max(worst, stages_apart_);
    }
    const double wanted = parts / std::max(way, least_way) * std::sqrt(worst / most_difference_);
    density_ = std::clamp(std::clamp(wanted, density_ / 2.0, density_ * 2.0), least_density, most_parts);
    return true;
  }

  /// Shares of the way from a state of the log to another at which contacts and stops begin or end, ascending.
  std::vector<double> touches_between(const LinearizedMotion::Place& first, const MovingState& last,
                                      const VectorXd& switches, std::size_t k) {
    std::vector<double> out;
    for (Eigen::Index it = 0; it < switches.size(); ++it) {
      const double before = first.switches[it], after = switches[it];
      if ((before > 0.0) == (after > 0.0)) continue;
      if (std::min(std::abs(before), std::abs(after)) < at_end * std::max(std::abs(before), std::abs(after))) continue;
      const auto depth = [&](double share) {
        const double t = first.state.t + share * (last.t - first.state.t);
        motion_.go_to(t, quintic_between(system_, first.state, last, share), log_.history(k));
        return motion_.place().switches[it];
      };
      out.push_back(brent(depth, 0.0, before, 1.0, after, at_end));
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  /// By the classical Runge-Kutta method; `y` is the state there, `middle` that on the way.
  bool carry_to(double t, const VectorXd& y, const VectorXd& middle, std::size_t k) {
    const VectorXd history = log_.history(k);
    const double begin = motion_.here().t, h = t - begin;
    const LinearizedMotion::Place first = motion_.place();
    if (!motion_.go_to(begin + 0.5 * h, middle, history)) return false;
    const LinearizedMotion::Place halfway = motion_.place();
    motion_.go_back_to(first);
    const bool other_side = motion_.take_sides_of(halfway);
    std::vector<Perturbation> start;
    for (const Followed& it : carried_) start.push_back(it.now);
    if (other_side && !accelerate(start)) return false;
    std::vector<Perturbation> sum = start, stage = start;
    const auto add = [&](double of_sum, double of_stage) {
      for (std::size_t n = 0; n < start.size(); ++n) {
        VectorXd rate = stage[n].velocity;
        motion_.turn(rate);
        sum[n].way += of_sum * h * rate;
        sum[n].velocity += of_sum * h * stage[n].acceleration;
        stage[n].way = start[n].way + of_stage * h * rate;
        stage[n].velocity = start[n].velocity + of_stage * h * stage[n].acceleration;
      }
    };
    add(1.0 / 6.0, 0.5);
    motion_.go_back_to(halfway);
    motion_.take_sides_of(halfway);
    if (!accelerate(stage)) return false;
    const std::vector<Perturbation> second = stage;
    add(1.0 / 3.0, 0.5);
    if (!accelerate(stage)) return false;
    stages_apart_ = 0.0;
    for (std::size_t n = 0; n < stage.size(); ++n)
      stages_apart_ = std::max(stages_apart_, difference(second[n], stage[n], h));
    add(1.0 / 3.0, 1.0);
    if (!motion_.go_to(t, y, history) || !accelerate(stage)) return false;
    add(1.0 / 6.0, 0.0);
    for (std::size_t n = 0; n < sum.size(); ++n) carried_[n].now = std::move(sum[n]);
    if (!settle()) return false;
    reached_ = t;
    return true;
  }

  bool accelerate(std::vector<Perturbation>& all) {
    return std::all_of(all.begin(), all.end(), [this](Perturbation& it) { return motion_.find_acceleration(it); });
  }

  /// Where a step ends.
  bool settle() {
    std::erase_if(carried_, [this](const Followed& it) { return !motion_.is_some(motion_.size(it.now)); });
    for (Followed& it : carried_) {
      if (!motion_.find_acceleration(it.now)) return false;
      motion_.take_back(it.now);
      note(it);
    }
    return true;
  }

  /// Of two stages of a step, relative to the error.
  double difference(const Perturbation& a, const Perturbation& b, double h) const {
    VectorXd rate = b.velocity - a.velocity;
    motion_.turn(rate);
    return h * (motion_.size(rate, b.acceleration - a.acceleration).maxCoeff() / motion_.size(b).maxCoeff());
  }

  void note(Followed& it) const {
    const VectorXd now = motion_.size(it.now);
    for (Eigen::Index part = 0; part < now.size(); ++part)
      if (it.now.first[part] > 0.0) it.largest[part] = std::max(it.largest[part], now[part] / it.now.first[part]);
  }

  const System& system_;
  const ConnectedParts& connected_;
  const StateLog& log_;
  const MovingAxes& axes_;
  const VectorXd &lengths_, &speeds_;
  double most_difference_;
  LogSmoothness smoothness_;
  LinearizedMotion motion_;    ///< about a state of the log, or on the way to the next
  double reached_ = 0.0;       ///< up to where errors were carried [s]
  double density_ = 1.0;       ///< of states on the way, by what `distance` takes for far
  double stages_apart_ = 0.0;  ///< of the last step
  std::vector<Followed> carried_;
};

/// The largest growth relative to that of regular motion.
double irregularity(const std::vector<ErrorGrowth>& found, const VectorXd& lengths, const VectorXd& speeds) {
  double out = 0.0;
  for (const ErrorGrowth& it : found)
    for (Eigen::Index part = 0; part < lengths.size(); ++part)
      out = std::max(out, relative_growth(it, part, lengths, speeds));
  return out;
}

/// Up to where errors were followed [s].
double reached_by(const std::vector<ErrorGrowth>& found) {
  double out = found.front().until;
  for (const ErrorGrowth& it : found) out = std::max(out, it.until);
  return out;
}

}  // namespace

std::vector<ErrorGrowth> find_error_growth(Dynamics& dynamics, const StateLog& log, const ErrorsToFollow& errors,
                                           const MovingAxes& axes, const VectorXd& lengths, const VectorXd& speeds,
                                           std::int64_t most_evaluations) {
  if (log.size() < 2) return {};
  const auto search = [&](double difference) { return GrowthSearch(dynamics, log, axes, lengths, speeds, difference); };
  const auto planned = [&](std::int64_t most) {
    const auto [count, until] = search(usual_difference).plan(most);
    return errors(count, until);
  };
  std::vector<StepDifference> followed = planned(most_evaluations);
  std::vector<ErrorGrowth> found = search(usual_difference).find(followed, most_evaluations);
  if (found.empty()) return found;
  const double begin = log.t(0), end = log.t(log.size() - 1), until = reached_by(found);
  if ((until < end || followed.size() < enough_errors) && irregularity(found, lengths, speeds) > suspicious) {
    followed = planned(more * most_evaluations);
    found = search(usual_difference).find(followed, more * most_evaluations);
  } else if (until < end) {
    const double of_step = of_motion + of_error * static_cast<double>(followed.size());
    const double fewer = (of_step * sure * (until - begin) / (end - begin) - of_motion) / of_error;
    followed = errors(static_cast<std::size_t>(std::max(fewer, fewest_errors)), end);
    found = search(usual_difference).find(followed, fewer < fewest_errors ? more * most_evaluations : most_evaluations);
  }
  if (!(irregularity(found, lengths, speeds) > doubtful)) return found;
  const std::int64_t affordable = most_of_bodies / dynamics.system().body_count();
  std::vector<ErrorGrowth> again =
      search(fine_difference).find(followed, std::min(more * more * most_evaluations, affordable));
  const bool as_far = again.size() == found.size() && again.front().until >= found.front().until;
  return as_far && reached_by(again) >= reached_by(found) ? again : found;
}

}  // namespace linkwork
