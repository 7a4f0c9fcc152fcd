#include "linkwork/integration/accumulated_error.hpp"

#include <algorithm>
#include <cmath>

namespace linkwork {
namespace {

constexpr double growth = 5.0;   // characteristic times L / V in which an error of a velocity moves positions
constexpr double steep = 10.0;   // times the mean of its part: a change of accelerations out of the ordinary
constexpr double slowest = 0.1;  // pace from which errors along the path grow
constexpr double still = 1e-6;   // relative to L, or to L / duration: below nothing moves, what is left is rounding

/// A part of a run with the steps that are known of it: one, or two, the second the steepest.
struct KnownPart {
  const RunPart* part;
  const StepError* first;
  const StepError* last;
  double share = 1.0, weight = 1.0;

  KnownPart(const RunPart& of, const StepError& step) : part(&of), first(&step), last(&step) {}
  double steps() const { return static_cast<double>(part->steps); }
  double mean_change() const { return part->sum_of_changes / steps(); }

  /// A step alone that is far steeper than its part does not stand for all of it.
  void weigh() {
    share = std::fmax(clipped((mean_change() - first->change) / (last->change - first->change)), 1.0 / steps());
    if (first == last) weight = std::fmax(std::fmin(steep * mean_change() / first->change, 1.0), 1.0 / steps());
  }

  template <class Value>
  double mean(Value value) const {
    const double one = value(*first), more = value(*last) - one;
    return weight * (one + std::max(share * more, more / steps()));
  }

 private:
  static double clipped(double x) { return x < 0.0 ? 0.0 : x > 1.0 ? 1.0 : x; }  // NaN stays
};

std::vector<KnownPart> known_parts(const RunErrors& errors) {
  std::vector<KnownPart> out;
  int last = -1;
  for (std::size_t k = 0; k < errors.steps.size(); ++k) {
    if (errors.steps[k].failed) continue;
    const int part = errors.part_of[k];
    if (part == last) out.back().last = &errors.steps[k];
    else out.emplace_back(errors.parts[part], errors.steps[k]);
    last = part;
  }
  for (KnownPart& part : out) part.weigh();
  std::stable_sort(out.begin(), out.end(),
                   [](const KnownPart& a, const KnownPart& b) { return a.part->t < b.part->t; });
  return out;
}

class Accumulation {
 public:
  Accumulation(const RunErrors& errors, double length)
      : errors_(errors), parts_(known_parts(errors)), L_(std::max(errors.diagonal / 2, length)) {}

  AccumulatedError result() {
    for (const StepError& step : errors_.steps) out_.failed += step.failed ? 1 : 0;
    if (parts_.empty()) return std::move(out_);
    find_scales();
    list_steps();
    const double once = std::max(at_once(), error(errors_.corrections));
    out_.state = once + (errors_.rest ? away_from_rest() : errors_.resolved * state());
    out_.local_error = sum([this](const StepError& it) { return error(it.end); }) / out_.seconds;
    out_.onset = sum([](const StepError& it) { return it.onset; }) / V_;
    out_.rate = V_ / L_;
    out_.carried = errors_.speed_as_a_whole / V_;
    out_.length = L_;
    out_.kinetic_share = errors_.kinetic_share;
    out_.rest = errors_.rest;
    return std::move(out_);
  }

 private:
  double pose(const StateDifference& it) const { return std::max(it.position, L_ * it.rotation) / size_; }
  double velocity(const StateDifference& it) const { return std::max(it.velocity, L_ * it.omega) / V_; }
  double error(const StateDifference& it) const { return std::max(pose(it), velocity(it)); }
  /// |y_dot| by V / size: by how much the state is off where it is late, relative to how late.
  double pace(const StepError& it) const {
    return std::max(it.speed / V_, std::max(it.acceleration, L_ * it.spin_rate) * size_ / (V_ * V_));
  }

  double pace(const RunPart& part) const { return part.peak * size_ / (V_ * V_); }

  /// Over all the run, parts of which no step is known included.
  template <class Value>
  double sum(Value value) const {
    double total = 0.0;
    for (const KnownPart& part : parts_) total += part.mean(value) * part.steps();
    return missed_ * total;
  }

  void find_scales() {
    double all = 0.0, known = 0.0, path = 0.0;
    for (const RunPart& part : errors_.parts) {
      all += static_cast<double>(part.steps);
      out_.seconds += part.seconds;
    }
    for (const KnownPart& part : parts_) {
      known += part.steps();
      path += part.part->seconds * part.mean([](const StepError& it) { return it.speed; });
    }
    missed_ = all / known;
    V_ = still * L_ / out_.seconds;
    for (const StepError& it : errors_.steps)
      if (!it.failed) V_ = std::max(V_, it.speed);
    size_ = std::max(std::min(L_, missed_ * path), still * L_);
    if (!errors_.rest) return;
    V_ = std::max(V_, errors_.rest->speed);
    size_ = L_;
  }

  void list_steps() {
    double largest = 0.0, reactions = 0.0, states = 0.0;
    for (const StepError& it : errors_.steps)
      if (!it.failed && std::isfinite(it.force))
        largest = std::max({largest, it.largest_force, it.largest_torque / L_});
    for (const StepError& it : errors_.steps) {
      if (it.failed) continue;
      const double reaction = largest > 0.0 ? std::max(it.force, it.torque / L_) / largest : NAN;
      const double state = error(it.end);
      out_.steps.push_back({it.t, it.h, state, reaction});
      out_.violation = std::max(out_.violation, it.violation);
      if (!std::isfinite(reaction) || !(state > 0.0)) continue;
      reactions += reaction;
      states += state;
    }
    out_.reactions_by_state = reactions / states;  // 0 / 0: not known
    std::stable_sort(out_.steps.begin(), out_.steps.end(),
                     [](const JudgedStep& a, const JudgedStep& b) { return a.t < b.t; });
  }

  /// Errors of poses and of velocities, as they add up.
  struct Sums {
    double poses = 0.0, velocities = 0.0, moments = 0.0;

    void add(double pose, double velocity, double t) {
      poses += pose;
      velocities += velocity;
      moments += velocity * t;
    }
    /// Of poses at t; `rate` [1/s] at which an error of a velocity moves them.
    double moved(double t, double rate) const {
      return poses + std::min(rate * (t * velocities - moments), growth * velocities);
    }
  };

  /// By time.
  std::vector<const RunPart*> all_parts() const {
    std::vector<const RunPart*> out;
    for (const RunPart& part : errors_.parts) out.push_back(&part);
    std::stable_sort(out.begin(), out.end(), [](const RunPart* a, const RunPart* b) { return a->t < b->t; });
    return out;
  }

  /// The larger of both at any time.
  double state() const {
    const double rate = V_ / size_;
    Sums sums, along;
    double late = 0.0, end = 0.0;
    auto known = parts_.begin();
    for (const RunPart* part : all_parts()) {
      const double t = part->t + part->seconds / 2;
      double fastest = pace(*part);
      if (known != parts_.end() && known->part == part) {
        const double steps = missed_ * known->steps();
        const double poses = steps * known->mean([this](const StepError& it) { return pose(it.end); });
        const double velocities = steps * known->mean([this](const StepError& it) { return velocity(it.end); });
        const double slow = 1.0 / std::clamp(pace(*known->first), slowest, 1.0);
        sums.add(poses, velocities, t);
        along.add(slow * poses, slow * velocities, t);
        fastest = std::max({fastest, pace(*known->first), pace(*known->last)});
        end = std::max(end, part->t + part->seconds);
        ++known;
      }
      late = std::max(late, along.moved(t, rate) * fastest);
    }
    return std::max(sums.moved(end, rate) + sums.velocities, late);
  }

  /// Of a mechanism that rests: errors die out, or the run would have moved it.
  double away_from_rest() const {
    double largest = 0.0;
    for (const StepError& it : errors_.steps)
      if (!it.failed) largest = std::max(largest, error(it.end));
    return largest;
  }

  double at_once() const {
    double largest = 0.0;
    for (const StepError& it : errors_.steps)
      if (!it.failed) largest = std::max({largest, error(it.inside), error(it.fading)});
    return largest;
  }

  const RunErrors& errors_;
  std::vector<KnownPart> parts_;
  double L_, V_ = 0.0, size_ = 0.0, missed_ = 1.0;
  AccumulatedError out_;
};

}  // namespace

AccumulatedError accumulate(const RunErrors& errors, double length) { return Accumulation(errors, length).result(); }

}  // namespace linkwork
