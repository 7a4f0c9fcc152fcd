#include "linkwork/integration/step_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/integration/step_parts.hpp"
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
constexpr double same_time = 1e-9;  // relative to the step
constexpr double far_more = 20.0;   // than the mean, for a jump of energy to be out of the ordinary
constexpr double more = 2.0;        // energy than by any of the steps that are taken again anyway
constexpr double energy_noise = 1e-13;
constexpr double rounding = 1e-13;  // of velocities: beside, what they change in a step is none
constexpr double at_rest = 1e-8;    // of gravity: beside, what accelerations change is none
constexpr double no_error = 1e-3;   // of the tolerances

/// Of each connected part, in the metric that makes v and omega comparable: mean square of the distances of joints from
/// centers of mass.
VectorXd squared_lengths_of(const System& system) {
  const ConnectedParts& parts = ConnectedParts::of(system);
  VectorXd sum = VectorXd::Zero(std::max(parts.count(), 1)), mass = sum;
  for (int body = 0; body < system.body_count(); ++body) {
    if (!(system.mass(body) > 0.0)) continue;
    sum[parts.of_body(body)] += system.inertia(body).trace();
    mass[parts.of_body(body)] += system.mass(body);
  }
  for (Eigen::Index k = 0; k < sum.size(); ++k) sum[k] = mass[k] > 0.0 && sum[k] > 0.0 ? sum[k] / mass[k] : 1.0;
  return sum;
}

std::size_t bytes_of_part(const Dynamics& dynamics) {
  return 2 * sizeof(double) *
         (2 * static_cast<std::size_t>(dynamics.y_size()) + static_cast<std::size_t>(dynamics.history().size()));
}

int groups_of(const std::vector<int>& of_each) {
  return of_each.empty() ? 0 : 1 + *std::max_element(of_each.begin(), of_each.end());
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
  out.work = std::max(a.work, b.work);
  out.sums_of_changes = a.sums_of_changes + b.sums_of_changes;
  out.peaks = a.peaks.cwiseMax(b.peaks);
  out.velocity_paths = a.velocity_paths + b.velocity_paths;
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

StepSampling::StepSampling(const Dynamics& dynamics)
    : q_size_(dynamics.system().q_size()),
      body_count_(dynamics.system().body_count()),
      every_body_(1 + body_count_ / most_looked_at),
      squared_lengths_(squared_lengths_of(dynamics.system())),
      most_parts_(std::clamp(most_bytes / bytes_of_part(dynamics) / 2, std::size_t{1}, usual_parts)),
      rates_(VectorXd::Zero(dynamics.system().v_size())),
      changes_(VectorXd::Zero(squared_lengths_.size())),
      sums_of_changes_(changes_),
      largest_(changes_),
      speeds_(changes_),
      fastest_(changes_),
      usual_changes_(changes_),
      system_(&dynamics.system()),
      connected_(&ConnectedParts::of(dynamics.system())) {
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

void StepSampling::expect_breaks(std::vector<double> times) {
  breaks_ = std::move(times);
  group_of_break_ = groups_of_breaks(system_->model(), breaks_);
  broken_ = StepGroups(groups_of(group_of_break_), most_parts_);
}

void StepSampling::log_states() {
  logs_ = true;
  log_ = StateLog(body_count_, system_->history_size());
}

void StepSampling::begin_anew(const Dynamics& dynamics, const VectorXd& y, double start) {
  StepSampling fresh(dynamics);
  fresh.width_ = width_;
  fresh.breaks_ = std::move(breaks_);
  fresh.group_of_break_ = std::move(group_of_break_);
  fresh.broken_ = StepGroups(groups_of(fresh.group_of_break_), most_parts_);
  fresh.memory_ = memory_;
  if (logs_) fresh.log_states();
  fresh.work_before_ = y[y.size() - 1];
  if (last_.kept() && last_.t + (1.0 - same_time) * last_.h > start) {
    fresh.history_ = history_;
    fresh.left_out_ = left_out_;
    fresh.correction_length_ = correction_length_;
    fresh.kinetic_ = kinetic_;
    fresh.balance_ = balance_;
    fresh.sides_ = sides_;
    fresh.after(last_.t, last_.h, last_.y, y);
  }
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
  if (!kinks_) {
    kinks_.emplace(*system_);
    reversals_.emplace(*system_);
  }
  touches_ = (switches.array() > 0.0).any();
  if (switches.size() > 0 || !kinks_->empty() || !reversals_->empty()) look_for_switches(history, switches, y);
  balance(y, kinetic, potential);
  if (history.size() > 0) history_ = history;
  correction_length_ = dynamics.correction_length();
  if (const std::vector<int>& rows = dynamics.dropped().rows(); left_out_ != rows) left_out_ = rows;
}

void StepSampling::look_for_switches(const VectorXd& history, const VectorXd& switches, const VectorXd& y) {
  const bool begun = pass_switches(history, switches);
  if (!kinks_->empty()) pass_kinks(history, y);
  if (!reversals_->empty()) pass_reversals(y);
  groups_of_step_.clear();
  bool depends = false;
  for (std::size_t group = 0; group < since_switch_.size(); ++group) {
    depends = depends || std::min(since_switch_[group], since_kink_[group]) <= memory_;
    if (since_switch_[group] <= memory_ || since_kink_[group] == 0) groups_of_step_.push_back(static_cast<int>(group));
  }
  if (!last_.kept() || !depends) return;
  for (KeptStep* step : {&parts_.back().any, &parts_.back().steepest})
    if (step->kept() && step->t == last_.t) step->switched = true;
  KeptStep* place = groups_of_step_.empty() ? nullptr : switched_.take(groups_of_step_);
  if (!place) return;
  keep(*place, y);
  if (begun) place->history_new = history;
}

/// Whether a contact has begun: a variable that was zero is the speed of it.
bool StepSampling::pass_switches(const VectorXd& history, const VectorXd& switches) {
  if (since_switch_.empty()) {
    std::vector<int> elements = kinks_->elements();
    elements.insert(elements.end(), reversals_->elements().begin(), reversals_->elements().end());
    groups_ = GroupsOfSwitches::of(*system_, elements);
    switched_ = StepGroups(groups_.count, most_parts_);
    since_switch_.assign(static_cast<std::size_t>(groups_.count), std::numeric_limits<int>::max());
    since_kink_ = since_switch_;
  }
  for (std::vector<std::int64_t>* all : {&since_switch_, &since_kink_})
    for (std::int64_t& since : *all) since += 1;
  const bool known = sides_.size() == static_cast<std::size_t>(switches.size());
  sides_.resize(static_cast<std::size_t>(switches.size()));
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const char side = switches[static_cast<Eigen::Index>(k)] > 0.0;
    if (known && sides_[k] != side) since_switch_[static_cast<std::size_t>(groups_.of_switch[k])] = 0;
    sides_[k] = side;
  }
  bool begun = false;
  for (Eigen::Index k = 0; last_.kept() && history_.size() == history.size() && k < history.size(); ++k) {
    if (system_->history_owners()[static_cast<std::size_t>(k)].kind != HistoryKind::onset) continue;
    if (history_[k] != 0.0 || history[k] == 0.0) continue;
    since_switch_[static_cast<std::size_t>(groups_.of_history[static_cast<std::size_t>(k)])] = 0;
    begun = true;
  }
  return begun;
}

/// Of steps of a multistep method that depend on one with a kink only that counts: forces go on there without a jump, and
/// what the others are off takes most of its error back.
void StepSampling::pass_kinks(const VectorXd& history, const VectorXd& y) {
  if (!last_.kept()) return;
  const double t = last_.t + last_.h;
  if (pieces_.empty()) pieces_ = pieces(last_.t, last_.y, history_);
  const std::vector<int>& now = pieces(t, y, history);
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (now[k] == pieces_[k]) continue;
    since_kink_[static_cast<std::size_t>(groups_.of_kink[k])] = 0;
    log_.end();  // steps go over them: what errors become there is not known
  }
  pieces_ = now;
}

/// Steps in which friction begins to act the other way may err far more than others.
void StepSampling::pass_reversals(const VectorXd& y) {
  if (!last_.kept()) return;
  if (directions_.empty()) directions_ = reversals_->directions(last_.y);
  const std::vector<int>& now = reversals_->directions(y);
  const std::size_t first = groups_.of_kink.size() - now.size();
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] != directions_[k]) since_kink_[static_cast<std::size_t>(groups_.of_kink[first + k])] = 0;
  directions_ = now;
}

const std::vector<int>& StepSampling::pieces(double t, const VectorXd& y, const VectorXd& history) {
  return kinks_->pieces(t, y.head(q_size_), y.segment(q_size_, system_->v_size()), history);
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
  if (last_.kept() && made > noise) keep_jump(made, y);
  last_.h = 0.0;
  kinetic_ = kinetic;
  balance_ = balance;
}

void StepSampling::keep_jump(double made, const VectorXd& y_new) {
  const double jump = made / std::sqrt(4.0 * kinetic_ + made);
  sum_of_jumps_ += jump;
  for (KeptStep* step : {&parts_.back().any, &parts_.back().steepest})
    if (step->kept() && step->t == last_.t) step->made = made;
  keep_largest(by_jump_, jump, y_new);
  keep_largest(by_energy_, made, y_new);
}

void StepSampling::keep_largest(Largest& list, double number, const VectorXd& y_new) const {
  if (number <= list.least) return;
  const auto smaller = [](const auto& a, const auto& b) { return a.first < b.first; };
  const std::size_t most = std::min(most_outliers, most_parts_);
  if (list.steps.size() < most) list.steps.emplace_back();
  const auto least = std::min_element(list.steps.begin(), list.steps.end(), smaller);
  least->first = number;
  keep(least->second, y_new);
  if (list.steps.size() == most) list.least = std::min_element(list.steps.begin(), list.steps.end(), smaller)->first;
}

void StepSampling::after(double t, double h, const VectorXd& y, const VectorXd& y_new) {
  begin_part_if_full(t);
  look_at_rates(h, y, y_new);
  note_speeds(y);
  const double resting = at_rest * system_->model().gravity().norm();
  follow(t, h, y, y_new, change_of_all((rounding / h * speeds_.cwiseSqrt()).cwiseMax(resting)));
}

void StepSampling::after(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& errors) {
  begin_part_if_full(t);
  look_at_rates(h, y, y_new);
  note_speeds(y);
  changes_ = errors;
  compared_ = true;
  follow(t, h, y, y_new, change_of_all(VectorXd::Constant(changes_.size(), no_error)));
}

void StepSampling::after(double t, double h, const VectorXd& y, const VectorXd& y_new, const Rates& rates) {
  if (largest_.size() > 1) return after(t, h, y, y_new);
  begin_part_if_full(t);
  changes_[0] = rates.change;
  largest_[0] = rates.largest;
  follow(t, h, y, y_new, rates.change);
}

void StepSampling::follow(double t, double h, const VectorXd& y, const VectorXd& y_new, double change) {
  RunPart& part = parts_.back();
  if (!std::exchange(compared_, true)) {
    changes_.setZero();
    change = 0.0;
  }
  last_.t = t;
  last_.h = h;
  last_.change = change;
  last_.changes = changes_;
  last_.y = y;
  const bool reached = next_break_ < breaks_.size() && breaks_[next_break_] <= t + (1.0 + same_time) * h;
  if (!reached || !meet_break(t, h, y_new)) choose(part, change, y_new);
  part.steps += 1;
  part.seconds += h;
  part.work = std::max({part.work, y[y.size() - 1], y_new[y.size() - 1]});
  part.sums_of_changes += changes_;
  part.peaks = part.peaks.cwiseMax(largest_);
  part.velocity_paths += h * largest_;
  steps_ += 1;
  log_.add(t, y, history_, touches_);
}

void StepSampling::choose(RunPart& part, double change, const VectorXd& y_new) {
  const bool chosen = part.steps == chosen_;
  if (chosen && part.any.change > part.steepest.change) part.steepest = std::move(part.any);
  if (chosen || !part.any.kept()) keep(part.any, y_new);
  else if (change > steeper * std::max(part.steepest.change, part.any.change)) keep(part.steepest, y_new);
}

/// Whether there is one in this step. At its end it is met here, where the last stage may be, and not once more where
/// the next step begins.
bool StepSampling::meet_break(double t, double h, const VectorXd& y_new) {
  const auto groups = group_of_break_.begin();
  const auto first = groups + static_cast<std::ptrdiff_t>(next_break_);
  while (next_break_ < breaks_.size() && breaks_[next_break_] <= t + (1.0 + same_time) * h) ++next_break_;
  if (breaks_[next_break_ - 1] < t - same_time * h) return false;
  groups_of_step_.assign(first, groups + static_cast<std::ptrdiff_t>(next_break_));
  if (KeptStep* place = broken_.take(groups_of_step_)) keep(*place, y_new);
  return true;
}

/// Of (v_new - v)/h: by how much they change, see StepSampling.
void StepSampling::look_at_rates(double h, const VectorXd& y, const VectorXd& y_new) {
  changes_.setZero();
  largest_.setZero();
  const double per_second = 1.0 / h;
  for (int body = 0; body < body_count_; body += every_body_) {
    const int part = connected_->of_body(body);
    const Eigen::Index v = q_size_ + velocity_size * body, own = velocity_size * body;
    const Eigen::Matrix<double, 6, 1> rate = (y_new.segment<6>(v) - y.segment<6>(v)) * per_second;
    const Eigen::Matrix<double, 6, 1> other = rate - rates_.segment<6>(own);
    const double squared = squared_lengths_[part];
    changes_[part] += other.head<3>().squaredNorm() + squared * other.tail<3>().squaredNorm();
    largest_[part] = std::max(largest_[part], rate.head<3>().squaredNorm() + squared * rate.tail<3>().squaredNorm());
    rates_.segment<6>(own) = rate;
  }
  changes_ = changes_.cwiseSqrt();
  largest_ = largest_.cwiseSqrt();
}

/// Where there are several parts.
void StepSampling::note_speeds(const VectorXd& y) {
  if (speeds_.size() == 1) return;
  find_squared_speeds(y, speeds_);
  fastest_ = fastest_.cwiseMax(speeds_);
}

void StepSampling::find_squared_speeds(const VectorXd& y, VectorXd& out) const {
  out.setZero(squared_lengths_.size());
  for (int body = 0; body < body_count_; body += every_body_) {
    const int part = connected_->of_body(body);
    const Eigen::Index v = q_size_ + velocity_size * body;
    out[part] =
        std::max(out[part], y.segment<3>(v).squaredNorm() + squared_lengths_[part] * y.segment<3>(v + 3).squaredNorm());
  }
}

/// Of several parts relative to their means, of what has been at rest to the `least` that counts. The means are held in a
/// part of the run, so that steps there compare as they would without what is beside.
double StepSampling::change_of_all(const VectorXd& least) {
  if (changes_.size() == 1) return changes_[0];
  if (!compared_) return 0.0;
  compared_steps_ += 1.0;
  sums_of_changes_ += changes_;
  double squares = 0.0;
  for (Eigen::Index part = 0; part < changes_.size(); ++part) {
    if (!(changes_[part] > 0.0)) continue;
    double& usual = usual_changes_[part];
    if (usual == 0.0) usual = changes_[part] / compared_steps_;
    const double by_mean = changes_[part] / std::max(usual, least[part]);
    squares += by_mean * by_mean;
  }
  return std::sqrt(squares);
}

void StepSampling::correct(const VectorXd& y, const VectorXd& corrected) {
  const DifferencesOfParts by = differences(*system_, y, corrected);
  corrections_.resize(by.size());
  for (std::size_t part = 0; part < by.size(); ++part) corrections_[part].raise(by[part]);
}

void StepSampling::begin_part_if_full(double t) {
  if (steps_ > 1 && parts_.back().steps < width_) return;
  if (parts_.size() == 2 * most_parts_ + 1) {
    parts_ = join_pairs(std::move(parts_));
    parts_.reserve(2 * most_parts_ + 2);
    width_ *= 2;
  }
  // spreads places evenly and in step with no period of the motion
  const double place = golden_share * static_cast<double>(parts_.size() + 1);
  chosen_ = static_cast<std::int64_t>(static_cast<double>(width_) * (place - std::floor(place)));
  parts_.emplace_back();
  parts_.back().t = t;
  parts_.back().peaks.setZero(largest_.size());
  parts_.back().velocity_paths.setZero(largest_.size());
  parts_.back().sums_of_changes.setZero(largest_.size());
  usual_changes_ = sums_of_changes_ / std::max(compared_steps_, 1.0);
}

/// The last step, as it went to y_new.
void StepSampling::keep(KeptStep& place, const VectorXd& y_new) const {
  place = last_;
  place.y_new = y_new;
  place.history = history_;
  place.correction_length = correction_length_;
  place.left_out = left_out_;
}

std::vector<RunPart> StepSampling::parts() const {
  std::vector<PartOfRun<const KeptStep*>> chosen;
  for (const RunPart& it : parts_)
    chosen.push_back(
        {it.steps, it.t, it.seconds, it.sums_of_changes, it.peaks, it.velocity_paths, &it.any, &it.steepest, it.work});
  const auto wanted = static_cast<std::size_t>(samples(steps_, body_count_));
  while (chosen.size() > 2 && chosen.size() < static_cast<std::size_t>(steps_) && 2 * chosen.size() > wanted + 1)
    chosen = join_pairs(std::move(chosen));
  std::vector<RunPart> out;
  InterruptionMeter meter;
  for (const auto& it : chosen) {
    meter.add(body_count_);
    out.push_back(
        {it.steps, it.t, it.seconds, it.sums_of_changes, it.peaks, it.velocity_paths, *it.any, *it.steepest, it.work});
  }
  return out;
}

namespace {

std::vector<const KeptStep*> steps_of(const std::vector<RunPart>& parts) {
  std::vector<const KeptStep*> out;
  for (const RunPart& part : parts)
    for (const KeptStep* step : {&part.any, &part.steepest})
      if (step->kept()) out.push_back(step);
  return out;
}

}  // namespace

std::vector<KeptStep> StepSampling::Largest::above(double limit, const std::vector<const KeptStep*>& there) const {
  std::vector<KeptStep> out;
  for (const auto& [number, step] : steps) {
    const auto same = [&](const KeptStep* other) { return other->t == step.t; };
    if (number > limit && std::none_of(there.begin(), there.end(), same)) out.push_back(step);
  }
  return out;
}

std::vector<KeptStep> StepSampling::outliers(const std::vector<RunPart>& parts) const {
  const double usual = sum_of_jumps_ / static_cast<double>(std::max<std::int64_t>(steps_, 1));
  return by_jump_.above(far_more * usual, steps_of(parts));
}

std::vector<KeptStep> StepSampling::suspects(const std::vector<RunPart>& parts) const {
  const std::vector<const KeptStep*> there = steps_of(parts);
  double most = 0.0;
  for (const KeptStep* step : there) most = std::max(most, step->made);
  return by_energy_.above(more * most, there);
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
