#include "linkwork/integration/step_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/math/interruption.hpp"
#include "linkwork/math/rotation.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork {
namespace {

constexpr std::size_t usual_parts = 40;                // with one or two steps each
constexpr std::size_t most_bytes = 1u << 27;           // that kept steps may take
constexpr int small_model = 50, most_looked_at = 500;  // bodies
constexpr std::int64_t affordable = 50;                // steps, of 10 000
constexpr double steeper = 1.1;                        // than the steepest so far, to be worth a copy
constexpr std::size_t most_outliers = 4;
constexpr std::size_t most_broken = 16, most_switched = 20;
constexpr double same_time = 1e-9;  // relative to the step
constexpr double far_more = 20.0;   // than the mean, for a jump of energy to be out of the ordinary
constexpr double more = 2.0;        // the same, than the largest of the steps that are taken again anyway
constexpr double energy_noise = 1e-13;
constexpr double golden = 0.6180339887498949;  // spreads places evenly and in step with no period of the motion

/// Mean square of the distances of joints from centers of mass, in the metric that makes v and omega comparable.
double squared_length_of(const System& system) {
  double sum = 0.0, mass = 0.0;
  for (int body = 0; body < system.body_count(); ++body) {
    if (!(system.mass(body) > 0.0)) continue;
    sum += system.inertia(body).trace();
    mass += system.mass(body);
  }
  return mass > 0.0 && sum > 0.0 ? sum / mass : 1.0;
}

std::size_t bytes_of_part(const Dynamics& dynamics) {
  return 2 * sizeof(double) *
         (2 * static_cast<std::size_t>(dynamics.y_size()) + static_cast<std::size_t>(dynamics.history().size()));
}

double change_of(const KeptStep& step) { return step.change; }
double change_of(const KeptStep* step) { return step->change; }

/// Two parts that follow each other as one. `left`: which of the steps that no acceleration chose stays one.
template <class Step>
PartOfRun<Step> joined(PartOfRun<Step> a, PartOfRun<Step> b, bool left) {
  Step* steepest = &a.steepest;
  for (Step* other : {&b.steepest, left ? &b.any : &a.any})
    if (change_of(*other) > change_of(*steepest)) steepest = other;
  PartOfRun<Step> out;
  out.steps = a.steps + b.steps;
  out.t = a.t;
  out.seconds = a.seconds + b.seconds;
  out.sum_of_changes = a.sum_of_changes + b.sum_of_changes;
  out.peak = std::max(a.peak, b.peak);
  out.steepest = std::move(*steepest);
  out.any = std::move(left ? a.any : b.any);
  return out;
}

/// All but the first, which has one step.
template <class Step>
std::vector<PartOfRun<Step>> join_pairs(std::vector<PartOfRun<Step>> parts) {
  std::vector<PartOfRun<Step>> out;
  out.push_back(std::move(parts.front()));
  for (std::size_t k = 1; k + 1 < parts.size(); k += 2)
    out.push_back(joined(std::move(parts[k]), std::move(parts[k + 1]), out.size() % 2 == 0));
  if (parts.size() % 2 == 0) out.push_back(std::move(parts.back()));
  return out;
}

}  // namespace

void StateDifference::raise(const StateDifference& other) {
  position = std::max(position, other.position);
  rotation = std::max(rotation, other.rotation);
  velocity = std::max(velocity, other.velocity);
  omega = std::max(omega, other.omega);
}

void StateDifference::lower(const StateDifference& by) {
  position = std::max(position - by.position, 0.0);
  rotation = std::max(rotation - by.rotation, 0.0);
  velocity = std::max(velocity - by.velocity, 0.0);
  omega = std::max(omega - by.omega, 0.0);
}

void StateDifference::raise(const System& system, const VectorXd& a, const VectorXd& b) {
  for (int body = 0; body < system.body_count(); ++body) {
    const int r = position_size * body, p = r + 3, v = system.q_size() + velocity_size * body;
    const Vec4<double> other = b.segment<4>(p);
    const Vec4<double> turn =
        quaternion_product<double>({other[0], -other[1], -other[2], -other[3]}, a.segment<4>(p) - other);
    position = std::max(position, (a.segment<3>(r) - b.segment<3>(r)).norm());
    rotation = std::max(rotation, 2.0 * turn.tail<3>().norm());
    velocity = std::max(velocity, (a.segment<3>(v) - b.segment<3>(v)).norm());
    omega = std::max(omega, (a.segment<3>(v + 3) - b.segment<3>(v + 3)).norm());
  }
}

StepSampling::StepSampling(const Dynamics& dynamics)
    : q_size_(dynamics.system().q_size()),
      body_count_(dynamics.system().body_count()),
      every_body_(1 + body_count_ / most_looked_at),
      squared_length_(squared_length_of(dynamics.system())),
      most_parts_(std::clamp(most_bytes / bytes_of_part(dynamics) / 2, std::size_t{1}, usual_parts)),
      rates_(VectorXd::Zero(dynamics.system().v_size())),
      system_(&dynamics.system()) {
  parts_.reserve(2 * most_parts_ + 2);
}

// A step costs three when it is taken again with all that belongs to it: 1.5 % of 10 000 steps. Of shorter runs more
// than a hundredth is needed to say something: all of a few, then 20, which takes no time in a small mechanism and up
// to 40 % in a large one of 100 steps.
std::int64_t StepSampling::samples(std::int64_t steps, int bodies) {
  const std::int64_t few = bodies <= small_model ? 20 : std::clamp<std::int64_t>(steps / 10, 5, 20);
  if (steps <= few) return steps;
  return std::clamp<std::int64_t>(std::min(steps / 20, std::max(affordable, steps / 200)), few,
                                  2 * static_cast<std::int64_t>(usual_parts));
}

void StepSampling::expect(std::int64_t steps) {
  const std::int64_t wanted = samples(steps, body_count_), most = static_cast<std::int64_t>(most_parts_);
  const std::int64_t count = std::clamp<std::int64_t>(wanted < steps ? wanted / 2 : wanted, 1, most);
  width_ = std::max<std::int64_t>((steps + count - 1) / count, 1);
}

void StepSampling::begin_anew(const Dynamics& dynamics, double work) {
  StepSampling fresh(dynamics);
  fresh.width_ = width_;
  fresh.breaks_ = std::move(breaks_);
  fresh.memory_ = memory_;
  fresh.work_before_ = work;
  *this = std::move(fresh);
}

void StepSampling::before(const Dynamics& dynamics, const VectorXd& y) {
  const Evaluation& at = dynamics.evaluation();
  const double kinetic = system_->kinetic_energy(at, y.segment(q_size_, system_->v_size()));
  before(dynamics, y, kinetic, at.potential, at.switches);
}

void StepSampling::before(const Dynamics& dynamics, const VectorXd& y, double kinetic, double potential,
                          const VectorXd& switches) {
  const VectorXd& history = dynamics.history();
  if (switches.size() > 0) look_for_switches(history, switches, y);
  balance(y, kinetic, potential);
  if (history.size() > 0) history_ = history;
  correction_length_ = dynamics.correction_length();
  if (const std::vector<int>& rows = dynamics.dropped().rows(); left_out_ != rows) left_out_ = rows;
}

/// A variable that was zero is the speed of a contact that has begun.
void StepSampling::look_for_switches(const VectorXd& history, const VectorXd& switches, const VectorXd& y) {
  const bool begun = last_.kept() && history_.size() == history.size() &&
                     ((history_.array() == 0.0) && (history.array() != 0.0)).any();
  const bool passed = pass_switches(switches);
  since_switch_ = passed || begun ? 0 : since_switch_ + 1;
  if (!last_.kept() || since_switch_ > memory_) return;
  for (KeptStep* step : {&parts_.back().any, &parts_.back().steepest})
    if (step->kept() && step->t == last_.t) step->switched = true;
  keep_switched(y);
  if (begun && switched_.back().step.t == last_.t) switched_.back().step.history_new = history;
}

bool StepSampling::pass_switches(const VectorXd& switches) {
  bool passed = false;
  const bool known = sides_.size() == static_cast<std::size_t>(switches.size());
  sides_.resize(switches.size());
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const char side = switches[static_cast<Eigen::Index>(k)] > 0.0;
    passed = passed || sides_[k] != side;
    sides_[k] = side;
  }
  return known && passed;
}

/// Multiples of the golden ratio are spread evenly whichever of them are taken: of many steps those that are small.
void StepSampling::keep_switched(const VectorXd& y_new) {
  const double multiple = golden * static_cast<double>(switched_steps_++), place = multiple - std::floor(multiple);
  if (place >= share_switched_) return;
  switched_.push_back({place, {}});
  keep(switched_.back().step, last_.t, last_.h, last_.change, last_.y, y_new);
  while (switched_.size() > std::min(most_switched, most_parts_)) {
    share_switched_ *= golden;
    std::erase_if(switched_, [&](const Switched& it) { return it.place >= share_switched_; });
  }
}

void StepSampling::balance(const VectorXd& y, double kinetic, double potential) {
  const double work = y[y.size() - 1];
  const double balance = kinetic + potential - work;
  energies_.kinetic = std::max(energies_.kinetic, kinetic);
  energies_.work = std::max(energies_.work, std::abs(work - work_before_));
  energies_.least_potential = std::min(energies_.least_potential, potential);
  energies_.largest_potential = std::max(energies_.largest_potential, potential);
  const double noise = energy_noise * std::max({kinetic, std::abs(potential), std::abs(work)});
  const double made = std::abs(balance - balance_);
  if (last_.kept() && made > noise) keep_jump(made / std::sqrt(4.0 * kinetic_ + made), y);
  last_.h = 0.0;
  kinetic_ = kinetic;
  balance_ = balance;
}

void StepSampling::keep_jump(double jump, const VectorXd& y_new) {
  sum_of_jumps_ += jump;
  for (KeptStep* step : {&parts_.back().any, &parts_.back().steepest})
    if (step->kept() && step->t == last_.t) step->jump = jump;
  if (jump <= least_jump_) return;
  const auto smaller = [](const KeptStep& a, const KeptStep& b) { return a.jump < b.jump; };
  if (worst_.size() < most_outliers) worst_.emplace_back();
  const auto least = std::min_element(worst_.begin(), worst_.end(), smaller);
  keep(*least, last_.t, last_.h, last_.change, last_.y, y_new);
  least->jump = jump;
  if (worst_.size() == most_outliers) least_jump_ = std::min_element(worst_.begin(), worst_.end(), smaller)->jump;
}

void StepSampling::after(double t, double h, const VectorXd& y, const VectorXd& y_new) {
  after(t, h, y, y_new, look_at_rates(h, y, y_new));
}

void StepSampling::after(double t, double h, const VectorXd& y, const VectorXd& y_new, const Rates& rates) {
  if (steps_ <= 1 || parts_.back().steps == width_) begin_part(t);
  RunPart& part = parts_.back();
  const double changed = std::exchange(compared_, true) ? rates.change : 0.0;
  if (next_break_ < breaks_.size() && breaks_[next_break_] <= t + (1.0 + same_time) * h) meet_break(t, h, y, y_new);
  if (part.steps == chosen_ && part.any.change > part.steepest.change) part.steepest = std::move(part.any);
  if (part.steps == 0 || part.steps == chosen_) keep(part.any, t, h, changed, y, y_new);
  else if (changed > steeper * std::max(part.steepest.change, part.any.change))
    keep(part.steepest, t, h, changed, y, y_new);
  last_.t = t;
  last_.h = h;
  last_.change = changed;
  last_.y = y;
  part.steps += 1;
  part.seconds += h;
  part.sum_of_changes += changed;
  part.peak = std::max(part.peak, rates.largest);
  steps_ += 1;
}

/// A break at the end is met here, where the last stage may be, and not once more where the next step begins. Of many
/// breaks those are kept that spread over all of them.
void StepSampling::meet_break(double t, double h, const VectorXd& y, const VectorXd& y_new) {
  const std::size_t every = 1 + breaks_.size() / std::min(most_broken, most_parts_), first = next_break_;
  while (next_break_ < breaks_.size() && breaks_[next_break_] <= t + (1.0 + same_time) * h) ++next_break_;
  if (breaks_[next_break_ - 1] < t - same_time * h) return;
  steps_with_breaks_ += 1;
  if ((first + every - 1) / every == (next_break_ + every - 1) / every) return;
  broken_.emplace_back();
  keep(broken_.back(), t, h, 0.0, y, y_new);
}

/// Of (v_new - v)/h.
Rates StepSampling::look_at_rates(double h, const VectorXd& y, const VectorXd& y_new) {
  double sum = 0.0, largest = 0.0;
  const double per_second = 1.0 / h;
  for (int body = 0; body < body_count_; body += every_body_) {
    const Eigen::Index v = q_size_ + velocity_size * body, own = velocity_size * body;
    const Eigen::Matrix<double, 6, 1> rate = (y_new.segment<6>(v) - y.segment<6>(v)) * per_second;
    const Eigen::Matrix<double, 6, 1> other = rate - rates_.segment<6>(own);
    sum += other.head<3>().squaredNorm() + squared_length_ * other.tail<3>().squaredNorm();
    largest = std::max(largest, rate.head<3>().squaredNorm() + squared_length_ * rate.tail<3>().squaredNorm());
    rates_.segment<6>(own) = rate;
  }
  return {std::sqrt(sum), std::sqrt(largest)};
}

void StepSampling::begin_part(double t) {
  if (parts_.size() == 2 * most_parts_ + 1) {
    parts_ = join_pairs(std::move(parts_));
    parts_.reserve(2 * most_parts_ + 2);
    width_ *= 2;
  }
  const double place = golden * static_cast<double>(parts_.size() + 1);
  chosen_ = static_cast<std::int64_t>(static_cast<double>(width_) * (place - std::floor(place)));
  parts_.emplace_back();
  parts_.back().t = t;
}

void StepSampling::keep(KeptStep& place, double t, double h, double change, const VectorXd& y,
                        const VectorXd& y_new) const {
  place.t = t;
  place.h = h;
  place.change = change;
  place.jump = 0.0;
  place.y = y;
  place.y_new = y_new;
  place.history = history_;
  place.correction_length = correction_length_;
  place.left_out = left_out_;
  place.switched = false;
}

std::vector<RunPart> StepSampling::parts() const {
  std::vector<PartOfRun<const KeptStep*>> chosen;
  for (const RunPart& it : parts_)
    chosen.push_back({it.steps, it.t, it.seconds, it.sum_of_changes, it.peak, &it.any, &it.steepest});
  const auto wanted = static_cast<std::size_t>(samples(steps_, body_count_));
  while (chosen.size() > 2 && chosen.size() < static_cast<std::size_t>(steps_) && 2 * chosen.size() > wanted + 1)
    chosen = join_pairs(std::move(chosen));
  std::vector<RunPart> out;
  InterruptionMeter meter;
  for (const auto& it : chosen) {
    meter.add(body_count_);
    out.push_back({it.steps, it.t, it.seconds, it.sum_of_changes, it.peak, *it.any, *it.steepest});
  }
  return out;
}

std::vector<KeptStep> StepSampling::outliers(const std::vector<RunPart>& parts) const {
  const double usual = sum_of_jumps_ / static_cast<double>(std::max<std::int64_t>(steps_, 1));
  double largest = 0.0;
  std::vector<double> there;
  for (const RunPart& part : parts)
    for (const KeptStep* step : {&part.any, &part.steepest}) {
      if (!step->kept()) continue;
      largest = std::max(largest, step->jump);
      there.push_back(step->t);
    }
  std::vector<KeptStep> out;
  for (const KeptStep& one : worst_)
    if (one.jump > std::min(far_more * usual, more * largest) &&
        std::find(there.begin(), there.end(), one.t) == there.end())
      out.push_back(one);
  return out;
}

namespace {

/// One for each of these steps, of which there were so many.
std::vector<RunPart> parts_of(const std::vector<KeptStep>& kept, std::int64_t count) {
  std::vector<RunPart> out;
  const std::int64_t each = kept.empty() ? 0 : (count - 1) / static_cast<std::int64_t>(kept.size()) + 1;
  for (const KeptStep& step : kept) {
    out.emplace_back();
    out.back().steps = each;
    out.back().t = step.t;
    out.back().seconds = static_cast<double>(each) * step.h;
    out.back().sum_of_changes = static_cast<double>(each) * step.change;
    out.back().any = step;
  }
  return out;
}

}  // namespace

std::vector<RunPart> StepSampling::broken() const { return parts_of(broken_, steps_with_breaks_); }

std::vector<RunPart> StepSampling::switched() const {
  std::vector<KeptStep> kept;
  for (const Switched& it : switched_) kept.push_back(it.step);
  return parts_of(kept, switched_steps_);
}

double time_sampling(const Dynamics& dynamics, std::int64_t steps) {
  StepSampling sampling(dynamics);
  const VectorXd y = dynamics.initial_y(), y_new = 1.001 * y;
  double seconds = 0.0;
  sampling.expect(steps);
  {
    const Stopwatch watch(seconds, 1);
    for (std::int64_t step = 0; step < steps; ++step) {
      sampling.before(dynamics, step % 2 == 0 ? y : y_new);
      sampling.after(static_cast<double>(step), 1.0, step % 2 == 0 ? y : y_new, step % 2 == 0 ? y_new : y);
    }
  }
  return seconds;
}

}  // namespace linkwork
