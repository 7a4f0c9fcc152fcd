#include "linkwork/integration/accumulated_error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace linkwork {
namespace {

constexpr double growth = 5.0;            // characteristic times L / V in which an error of a velocity moves positions
constexpr double followed = 0.9;          // share of a run: beyond, its end is known
constexpr double followed_to_end = 0.99;  // the same, where nothing may be left out
constexpr std::size_t few_followed = 2;   // errors at least that say how others grow
constexpr double of_energy = 4.0;         // times errors of steps: what they make of the energy, at most
constexpr double same_time = 1e-9;        // relative
constexpr double of_regular = 0.05;       // growth that counts
constexpr double irregular = 20.0;        // growth of errors, relative to t V / L: beyond, motion is unstable
constexpr double steep = 10.0;            // times the mean of its part: a change of accelerations out of the ordinary
constexpr double sudden = 2.0;            // mean turning, up to which peaks of accelerations are those of bursts alone
constexpr double burst = 0.5;             // of the largest acceleration: one, as of a bounce
constexpr double slowest = 0.1;           // pace from which errors along the path grow
constexpr double unloaded = 1e-9;         // of forces, or of those of the motion: reactions below are rounding
constexpr double least_energy = 1e-9;     // of a mechanism, relative to its amount
constexpr std::size_t rare = 10;          // one of so many
constexpr double still = 1e-6;  // relative to L, or to L / duration: below nothing moves, what is left is rounding

/// A part of a run with the steps that are known of it: one, or two, the second the steepest.
struct KnownPart {
  const RunPart* part;
  const StepError* first;
  const StepError* last;
  double remaining = 1.0;            ///< share of the energy of all bodies that forces have not taken away
  double returning = 1.0;            ///< the same where what comes back later was not taken away
  double share = 1.0, weight = 1.0;  ///< in a connected part

  KnownPart(const RunPart& of, const StepError& step) : part(&of), first(&step), last(&step) {}
  double steps() const { return static_cast<double>(part->steps); }

  /// A step alone that is far steeper than its part does not stand for all of it.
  void weigh(std::size_t connected) {
    const double mean = part->sums_of_changes[static_cast<Eigen::Index>(connected)] / steps();
    const double one = first->of_part[connected].change, steepest = last->of_part[connected].change;
    share = std::fmax(clipped((mean - one) / (steepest - one)), 1.0 / steps());
    weight = first == last ? std::fmax(std::fmin(steep * mean / one, 1.0), 1.0 / steps()) : 1.0;
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
  std::stable_sort(out.begin(), out.end(),
                   [](const KnownPart& a, const KnownPart& b) { return a.part->t < b.part->t; });
  return out;
}

double kinetic_energy(const StepError& step) {
  double sum = 0.0;
  for (const PartError& part : step.of_part) sum += part.kinetic;
  return sum;
}

/// Above the least potential V of all these: with T + V = W + constant it is W - min (W - T). Of the most up to there;
/// none where there was none yet.
void find_what_remains(std::vector<KnownPart>& parts) {
  double least = INFINITY, most = 0.0, most_ever = 0.0, later = -INFINITY;
  for (const KnownPart& part : parts) least = std::min(least, part.first->work - kinetic_energy(*part.first));
  for (KnownPart& part : parts) {
    const double there = part.first->work - least;
    most = std::max(most, there);
    part.remaining = most > 0.0 ? there / most : 0.0;
    most_ever = std::max({most_ever, there, part.part->work - least});
    part.returning = most_ever;
  }
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    later = std::max(later, part->first->work - least);
    part->returning = part->returning > 0.0 ? std::min(later / part->returning, 1.0) : 0.0;
    later = std::max(later, part->part->work - least);
  }
}

/// As errors of energies are weighed over the whole run.
double relative(const EnergyMade& it, double kinetic) {
  const double scale = std::max({kinetic + it.in_inerters, it.exchanged, it.rest, least_energy * it.amount});
  return it.largest > 0.0 ? it.largest / scale : 0.0;
}

/// In one connected part.
class Accumulation {
 public:
  /// Weighs the known parts of the run.
  Accumulation(const RunErrors& errors, std::vector<KnownPart>& parts, std::size_t part)
      : errors_(errors), parts_(parts), part_(part), judged_(errors.connected_parts[part]), L_(judged_.length) {
    for (KnownPart& it : parts) it.weigh(part);
  }

  /// Relative to the largest kinetic energy; with what the choice of steps leaves open, as energies come and go within
  /// the motion: by what differs from one part of the run to the next, but for rare large ones.
  double energy_made() const {
    double made = 0.0, in_inerters = 0.0;
    std::vector<double> energies, squares;
    for (const KnownPart& it : parts_) {
      const double one = of(*it.first).energy, last = of(*it.last).energy;
      in_inerters = std::max({in_inerters, of(*it.first).in_inerters, of(*it.last).in_inerters});
      made += it.weight * it.steps() * (one + it.share * (last - one));
      if (it.part->peaks.size() > 0) energies.push_back(it.steps() * one);  // else it is a step alone
    }
    if (!std::isfinite(made)) return INFINITY;
    for (std::size_t k = 1; k < energies.size(); ++k)
      squares.push_back(0.5 * std::pow(energies[k] - energies[k - 1], 2));
    std::sort(squares.begin(), squares.end());
    squares.resize(squares.size() - squares.size() / rare);
    const double open = std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.0));
    const double kinetic = judged_.kinetic + in_inerters;
    return kinetic > 0.0 ? missed_ * (std::abs(made) + open) / kinetic : 0.0;
  }

  AccumulatedError result() {
    find_scales();
    list_steps();
    const StateDifference corrections = errors_.corrections.empty() ? StateDifference() : errors_.corrections[part_];
    const double once = std::max(at_once(), error(corrections));
    out_.state = once + (judged_.rest ? away_from_rest() : judged_.resolved * accumulated());
    out_.at_most = judged_.rest ? out_.state : once + judged_.resolved * at_most();
    out_.local_error = sum([this](const StepError& it) { return error(of(it).end); }) / out_.seconds;
    out_.contacts_begin = std::any_of(errors_.steps.begin(), errors_.steps.end(),
                                      [this](const StepError& it) { return of(it).contact_begins; });
    out_.onset = sum([this](const StepError& it) { return of(it).onset; }) / body_speed_;
    const double path = sum([this](const StepError& it) { return of(it).displacement; });
    out_.rounding = std::max(sum([this](const StepError& it) { return of(it).rounding; }) / std::max(path, size_),
                             noise() / body_speed_);
    out_.rate = V_ / L_;
    find_slowness();
    out_.carried = judged_.speed_as_a_whole / V_;
    return std::move(out_);
  }

 private:
  double pose(const StateDifference& it) const { return std::max(it.position, L_ * it.rotation) / size_; }
  double speed(const StateDifference& it) const { return it.velocity / body_speed_; }
  double turning(const StateDifference& it) const { return L_ * it.omega / V_; }
  double velocity(const StateDifference& it) const { return std::max(speed(it), turning(it)); }
  double error(const StateDifference& it) const { return std::max(pose(it), velocity(it)); }
  const PartError& of(const StepError& it) const { return it.of_part[part_]; }
  /// |y_dot| by V / size: by how much the state is off where it is late, relative to how late.
  double pace(const StepError& step) const { return std::max(of(step).speed / V_, turning(step)); }

  double turning(const StepError& step) const {
    const PartError& it = of(step);
    return std::max(it.acceleration, L_ * it.spin_rate) * size_ / (V_ * V_);
  }

  /// An error of the energy is a share of it that is larger where there is less, and delays; but where motion turns, or
  /// where forces took that energy away, or gave none yet: as much was taken of the error. It counts as far as motion is
  /// fast once more, and, from where it was most sudden first, as in a bounce, as it accelerates then.
  void find_slowness() {
    const double usual = std::fmax(1.0, mean_turning() / sudden);
    const auto share = [this](const StepError& it) {
      const double turns = turning(it);
      return std::fmax(of(it).kinetic / judged_.kinetic, turns * turns);
    };
    const std::vector<const RunPart*> all = all_parts();
    auto of_all = all.rbegin();
    const double first = first_burst(all);
    double slow = 0.0, bursts = 0.0, seconds = 0.0, later = 0.0, steepest = 0.0;
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
      const double remaining = judged_.energy ? 1.0 : judged_.has_laws ? part->returning : part->remaining;
      const double step = part->part->seconds;
      later = std::fmin(std::fmax(later, std::fmax(share(*part->first), share(*part->last))), 1.0);
      for (; of_all != all.rend() && (*of_all)->t >= part->part->t; ++of_all)
        steepest = std::fmax(steepest, pace(**of_all) / usual);
      const double left = std::clamp(remaining > 0.0 ? share(*part->first) / remaining : 1.0, slowest * slowest, 1.0);
      slow += step * std::sqrt(later) / left;
      if (part->part->t > first) bursts += step * steepest / left;
      seconds += step;
    }
    if (seconds == 0.0) return;
    out_.slowness = judged_.nonlinearity * slow / seconds;
    if (judged_.bursts_late) out_.suddenness = judged_.nonlinearity * bursts / seconds;
  }

  /// When the part of the run begins in which there is one [s].
  double first_burst(const std::vector<const RunPart*>& all) const {
    const double most = largest_pace();
    for (const RunPart* it : all)
      if (pace(*it) >= burst * most) return it->t;
    return INFINITY;
  }

  /// As `turning` of a step, in the mean over the time of the run.
  double mean_turning() const {
    double seconds = 0.0, path = 0.0;
    for (const RunPart& part : errors_.parts) {
      if (part.velocity_paths.size() == 0) continue;
      seconds += part.seconds;
      path += part.velocity_paths[static_cast<Eigen::Index>(part_)];
    }
    return seconds > 0.0 ? path / seconds * size_ / (V_ * V_) : 0.0;
  }

  double pace(const RunPart& part) const {
    return part.peaks.size() > 0 ? part.peaks[static_cast<Eigen::Index>(part_)] * size_ / (V_ * V_) : 0.0;
  }

  double largest_pace() const {
    double most = 0.0;
    for (const RunPart& it : errors_.parts) most = std::fmax(most, pace(it));
    return most;
  }

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
      path += part.part->seconds * part.mean([this](const StepError& it) { return of(it).speed; });
    }
    missed_ = all / known;
    V_ = body_speed_ = std::max(still * L_ / out_.seconds, judged_.rest ? judged_.rest->speed : 0.0);
    for (const StepError& it : errors_.steps) {
      if (it.failed) continue;
      V_ = std::max(V_, judged_.fastest * of(it).speed);
      body_speed_ = std::max(body_speed_, judged_.fastest * of(it).body_speed);
    }
    size_ = judged_.rest ? L_ : std::max(std::min(L_, missed_ * path), still * L_);
  }

  void list_steps() {
    double largest = 0.0, reactions = 0.0, states = 0.0, yielded = NAN;
    const double of_motion = unloaded * judged_.kinetic / L_;
    for (const StepError& it : errors_.steps)
      if (!it.failed && std::isfinite(of(it).force))
        largest =
            std::max({largest, of_motion, unloaded * of(it).load, of(it).largest_force, of(it).largest_torque / L_});
    for (const StepError& it : errors_.steps) {
      if (it.failed) continue;
      const double reaction = largest > 0.0 ? std::max(of(it).force, of(it).torque / L_) / largest : NAN;
      yielded = std::fmax(yielded, std::fmax(of(it).yielded_force, of(it).yielded_torque / L_));
      const double state = error(of(it).end);
      out_.steps.push_back({it.t, it.h, state, reaction});
      out_.violation = std::max(out_.violation, it.violation);
      if (!std::isfinite(reaction) || !(state > 0.0)) continue;
      reactions += reaction;
      states += state;
    }
    out_.reactions_by_state = reactions / states;  // 0 / 0: not known
    out_.yielding = largest > 0.0 ? yielded / largest : NAN;
    std::stable_sort(out_.steps.begin(), out_.steps.end(),
                     [](const JudgedStep& a, const JudgedStep& b) { return a.t < b.t; });
  }

  /// Errors of velocities as they add up; `rate` [1/s] at which they move poses.
  struct Drift {
    double rate, sum = 0.0, moment = 0.0;

    void add(double velocity, double t) {
      sum += velocity;
      moment += velocity * t;
    }
    double moved(double t) const { return std::min(rate * (t * sum - moment), growth * sum); }
  };

  /// Those of poses, too.
  struct Sums {
    double poses = 0.0;
    Drift speeds, turnings;

    void add(double pose, double speed, double turning, double t) {
      poses += pose;
      speeds.add(speed, t);
      turnings.add(turning, t);
    }
    /// Of poses at t, of what velocities move the `share` that counts.
    double moved(double t, double share = 1.0) const {
      return poses + share * std::max(speeds.moved(t), turnings.moved(t));
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
    Sums sums{.speeds = {body_speed_ / size_}, .turnings = {V_ / size_}}, along = sums;
    auto known = parts_.begin();
    const StateDifference& first = of(*known->first).late;
    double late = 0.0, end = 0.0, velocities = velocity(first);
    for (Sums* it : {&sums, &along}) it->add(0.0, speed(first), turning(first), known->part->t);
    for (const RunPart* part : all_parts()) {
      const double t = part->t + part->seconds / 2;
      double fastest = pace(*part);
      if (known != parts_.end() && known->part == part) {
        const auto all = [&](auto size) {
          return missed_ * known->steps() * known->mean([&](const StepError& it) { return size(of(it).end); });
        };
        const double poses = all([this](const StateDifference& it) { return pose(it); });
        const double speeds = all([this](const StateDifference& it) { return speed(it); });
        const double turnings = all([this](const StateDifference& it) { return turning(it); });
        const double slow = 1.0 / std::clamp(pace(*known->first), slowest, 1.0);
        velocities += all([this](const StateDifference& it) { return velocity(it); });
        sums.add(poses, speeds, turnings, t);
        along.add(slow * poses, slow * speeds, slow * turnings, t);
        fastest = std::max({fastest, pace(*known->first), pace(*known->last)});
        end = std::max(end, part->t + part->seconds);
        ++known;
      }
      late = std::max(late, along.moved(t, judged_.nonlinearity) * fastest);
    }
    return std::max(sums.moved(end) + velocities, late);
  }

  double accumulated() {
    const double usual = state(), unstable = grown(), first = all_parts().front()->t;
    for (const ErrorGrowth& it : errors_.growth)
      if (it.lost) out_.lost = std::fmin(out_.lost, it.until);
    for (const ErrorGrowth& it : errors_.growth) {
      const bool unstable_there = irregularity(it) > 1.0;
      if ((it.until >= followed * out_.seconds + first && std::isnan(out_.lost)) || unstable_there)
        out_.growth = std::fmax(out_.growth, factor(it));
      if (unstable_there) out_.unstable = std::max(out_.unstable, factor(it));
    }
    out_.grows = unstable > usual && out_.unstable > 1.0;
    return std::max(usual, unstable);
  }

  double factor(const ErrorGrowth& it) const { return it.of_part[static_cast<Eigen::Index>(part_)]; }

  /// Growth relative to that in regular motion.
  double irregularity(const ErrorGrowth& it) const {
    const double regular = irregular * (1.0 + V_ / L_ * (it.until - it.t));
    return factor(it) / (regular * std::max(largest_pace(), 1.0));
  }

  /// That of regular motion, in proportion to time, counts by a part: what becomes of errors of energies there, which
  /// come and go, their balance says.
  double counted_factor(const ErrorGrowth& it) const {
    return std::max(factor(it) * std::clamp(irregularity(it), of_regular, 1.0), 1.0);
  }

  /// The largest of those followed in a part of the run, if any, and of those before and after it, if any.
  struct GrowthAbout {
    double within = 1.0, around = 1.0;
    bool followed = false;  ///< in the part itself
  };
  template <class Factor>
  GrowthAbout growth_about(const RunPart& part, const Factor& of) const {
    const std::vector<ErrorGrowth>& all = errors_.growth;
    const auto after = [&](double t) {
      return std::find_if(all.begin(), all.end(), [t](const ErrorGrowth& it) { return it.t > t; });
    };
    const auto own = after(part.t), next = after((1.0 + same_time) * (part.t + part.seconds));
    GrowthAbout out{.followed = own != next};
    for (auto it = own; it != next; ++it) out.within = std::max(out.within, of(*it));
    if (own != all.begin()) out.around = of(*(own - 1));
    if (next != all.end()) out.around = std::max(out.around, of(*next));
    return out;
  }

  /// Of errors that arise in a part of the run: the larger one of those followed before and after it. Where one of its
  /// own was, its growth if that is more, else the mean of both on a scale of powers: others of the part may grow more.
  /// That of steps alone counts in full.
  double growth_from(const RunPart& part) const {
    const bool alone = part.peaks.size() == 0;
    const auto [within, around, followed] =
        growth_about(part, [&](const ErrorGrowth& it) { return alone ? factor(it) : counted_factor(it); });
    return !followed || within > around ? std::max(within, around) : std::sqrt(within * around);
  }

  /// The errors of all steps as they have become, where it is known how they grow.
  double grown() const {
    if (errors_.growth.empty()) return 0.0;
    double sum = 0.0;
    for (const KnownPart& it : parts_)
      sum +=
          it.steps() * growth_from(*it.part) * it.mean([this](const StepError& step) { return error(of(step).end); });
    return missed_ * sum;
  }

  /// NaN where growth is not known to the end, or is that of unstable motion, of which few errors say little; and where
  /// the balance of energy shows what steps do not.
  double at_most() const {
    const double end = all_parts().front()->t + followed_to_end * out_.seconds;
    const auto known = [&](const ErrorGrowth& it) { return it.until >= end && irregularity(it) <= 1.0; };
    const std::vector<ErrorGrowth>& all = errors_.growth;
    if (all.size() < few_followed || !std::all_of(all.begin(), all.end(), known) || judged_.has_laws) return NAN;
    double sum = 0.0, local = 0.0;
    for (const KnownPart& it : parts_) {
      const double own = it.steps() * it.mean([this](const StepError& step) { return error(of(step).end); });
      const GrowthAbout growth = growth_about(*it.part, [this](const ErrorGrowth& error) { return factor(error); });
      sum += own * std::max(growth.within, growth.around);
      local += missed_ * own;
    }
    if (judged_.energy && !(relative(*judged_.energy, judged_.kinetic) <= of_energy * local)) return NAN;
    return missed_ * sum;
  }

  /// Of a part that rests: errors die out, or the run would have moved it.
  double away_from_rest() const {
    double largest = 0.0;
    for (const StepError& it : errors_.steps)
      if (!it.failed) largest = std::max(largest, error(of(it).end));
    return largest;
  }

  double noise() const {
    double largest = 0.0;
    for (const StepError& it : errors_.steps)
      if (!it.failed) largest = std::max(largest, of(it).noise);
    return largest;
  }

  double at_once() const {
    double largest = 0.0;
    for (const StepError& it : errors_.steps)
      if (!it.failed) largest = std::max({largest, error(of(it).inside), error(of(it).fading), error(of(it).late)});
    return largest;
  }

  const RunErrors& errors_;
  const std::vector<KnownPart>& parts_;
  std::size_t part_;
  const JudgedPart& judged_;
  double L_, V_ = 0.0, body_speed_ = 0.0, size_ = 0.0, missed_ = 1.0;
  AccumulatedError out_;
};

/// Takes over what counts of all parts, whichever is worst.
AccumulatedError worse(AccumulatedError a, AccumulatedError b) {
  const double reactions = std::fmax(a.reactions_by_state * a.state, b.reactions_by_state * b.state);
  const bool bounded = !std::isnan(a.at_most) && !std::isnan(b.at_most);
  const double at_most = bounded ? std::max(a.at_most, b.at_most) : NAN;
  const double onset = std::max(a.onset, b.onset), yielding = std::fmax(a.yielding, b.yielding);
  const double rounding = std::max(a.rounding, b.rounding), unstable = std::max(a.unstable, b.unstable);
  const bool contacts_begin = a.contacts_begin || b.contacts_begin;
  AccumulatedError out = b.state > a.state || std::isnan(b.state) ? std::move(b) : std::move(a);
  out.reactions_by_state = reactions / out.state;
  out.contacts_begin = contacts_begin;
  out.unstable = unstable;
  out.at_most = at_most;
  out.onset = onset;
  out.yielding = yielding;
  out.rounding = rounding;
  return out;
}

/// Whose the energy is, most of all.
std::size_t most_energetic(const std::vector<JudgedPart>& parts) {
  const auto less = [](const JudgedPart& a, const JudgedPart& b) { return a.kinetic < b.kinetic; };
  return static_cast<std::size_t>(std::max_element(parts.begin(), parts.end(), less) - parts.begin());
}

std::vector<Peaks> peaks_of(const RunErrors& errors) {
  std::vector<Peaks> out;
  for (const RunPart& it : errors.parts)
    if (it.peaks.size() > 0) out.push_back({it.t, it.t + it.seconds, it.peaks});
  std::stable_sort(out.begin(), out.end(), [](const Peaks& a, const Peaks& b) { return a.t < b.t; });
  return out;
}

void note_rest(const std::vector<JudgedPart>& parts, AccumulatedError& out) {
  bool all = true;
  for (const JudgedPart& part : parts) {
    out.rest.push_back(part.rest ? RestScales{part.length, part.rest->speed} : RestScales());
    out.rest_energy += part.rest ? part.rest->energy : 0.0;
    all = all && part.rest;
  }
  if (!all) out.rest_energy = 0.0;
}

}  // namespace

AccumulatedError accumulate(const RunErrors& errors) {
  AccumulatedError out;
  std::vector<KnownPart> known = known_parts(errors);
  const std::vector<JudgedPart>& parts = errors.connected_parts;
  const std::size_t energetic = most_energetic(parts);
  find_what_remains(known);
  double rate = 0.0, slowness = 1.0, suddenness = 0.0;
  std::vector<EnergyOfPart> energies;
  std::vector<double> speeds(parts.size(), 0.0);
  for (std::size_t part = 0; part < parts.size() && !known.empty(); ++part) {
    Accumulation accumulation(errors, known, part);
    AccumulatedError own = accumulation.result();
    own.body = parts.size() > 1 ? parts[part].first_body : -1;
    if (const std::optional<EnergyMade>& it = parts[part].energy)
      energies.push_back({parts[part].first_body, relative(*it, parts[part].kinetic), it->lasting, own.rate,
                          own.slowness, own.suddenness});
    if (parts[part].has_laws && parts[part].bursts_late && !parts[part].rest)
      energies.push_back({own.body, accumulation.energy_made(), 1.0, own.rate, own.slowness, own.suddenness});
    speeds[part] = own.rate * parts[part].length;
    if (part == energetic) rate = own.rate, slowness = own.slowness, suddenness = own.suddenness;
    out = part == 0 ? std::move(own) : worse(std::move(out), std::move(own));
  }
  out.speeds = std::move(speeds);
  out.peaks = peaks_of(errors);
  out.rate = rate;
  out.slowness = slowness;
  out.suddenness = suddenness;
  out.kinetic_share = errors.kinetic_share;
  out.energies = std::move(energies);
  for (const StepError& step : errors.steps) out.failed += step.failed ? 1 : 0;
  note_rest(parts, out);
  return out;
}

}  // namespace linkwork
