#include "linkwork/integration/run_judge.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/integration/nonlinearity.hpp"

namespace linkwork {
namespace {

constexpr std::int64_t few_steps = 50;         // which are often long ones
constexpr std::int64_t of_many_periods = 300;  // steps at least; in fewer ones nothing grows far
constexpr std::size_t every_reaction = 6;      // steps of which reactions are compared, too
constexpr std::size_t every_inside = 3;        // the same for what is recorded inside, where there are not few
constexpr std::size_t worst_parts = 3;         // of a mechanism that is not connected
constexpr std::size_t worst = 3;               // steps of each that are looked at once more, in so many parts:
// Evaluations to follow errors, of all bodies, and where laws of the user's own act, beside one for each second step.
constexpr std::int64_t affordable = 10'000, affordable_of_bodies = 100'000, affordable_of_laws = 2000, most_of_step = 6;
constexpr std::size_t few_errors = 3;  // that are followed
constexpr double far_worse = 3.0;      // than the worst of the others, for a suspect to count
constexpr int usual_divisions = 1, few_divisions = 2, divisions_of_worst = 3;  // powers of two

/// A part of the run for each.
void append_each(const std::vector<KeptStep>& steps, std::vector<RunPart>& out) {
  for (const KeptStep& step : steps) {
    out.push_back({1, step.t, step.h, step.changes, {}, {}, {}, {}});
    out.back().any = step;
  }
}

std::vector<RunPart> parts_to_judge(const StepSampling& sampling) {
  std::vector<RunPart> out = sampling.parts();
  for (RunPart& part : out)
    for (KeptStep* step : {&part.any, &part.steepest})
      if (step->switched) *step = {};
  for (RunPart& part : sampling.broken()) out.push_back(std::move(part));
  for (RunPart& part : sampling.switched()) out.push_back(std::move(part));
  append_each(sampling.outliers(out), out);
  return out;
}

std::vector<std::vector<int>> choices_of_rows(const std::vector<const KeptStep*>& steps, const std::vector<int>& last) {
  std::vector<std::vector<int>> out = {last};
  for (const KeptStep* step : steps)
    if (std::find(out.begin(), out.end(), step->left_out) == out.end()) out.push_back(step->left_out);
  return out;
}

/// The places of the `most` of so many that are largest, the largest first.
template <class Size>
std::vector<std::size_t> largest_of(std::size_t count, std::size_t most, const Size& size) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  most = std::min(most, count);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end(),
                    [&](std::size_t a, std::size_t b) { return size(a) > size(b); });
  order.resize(most);
  return order;
}

const RetakenStep& of_step(std::size_t step, const RetakenSteps& retaken) {
  static const RetakenStep nowhere;
  return step < retaken.size() ? retaken[step] : nowhere;
}

}  // namespace

RunJudge::RunJudge(const StepSampling& sampling, Dynamics& dynamics, SecondTake take)
    : sampling_(sampling),
      dynamics_(dynamics),
      lengths_(RelativeViolation::lengths_of(dynamics.system())),
      speeds_(VectorXd::Zero(lengths_.size())),
      every_inside_(sampling.steps() <= few_steps ? 1 : every_inside),
      divisions_(sampling.steps() <= few_steps ? few_divisions : usual_divisions),
      breaks_(sampling.breaks()),
      judge_(dynamics, std::move(take), breaks_) {
  out_.corrections = sampling.corrections();
  out_.parts = parts_to_judge(sampling);
  const std::vector<KeptStep> suspects = sampling.suspects(out_.parts);
  suspects_ = suspects.size();
  append_each(suspects, out_.parts);
  for (std::size_t k = 0; k < out_.parts.size(); ++k)
    for (const KeptStep* step : {&out_.parts[k].any, &out_.parts[k].steepest}) {
      if (!step->kept()) continue;
      kept_.push_back(step);
      out_.part_of.push_back(static_cast<int>(k));
    }
  see_from_moving_axes();
  look_at_forces();
  judge_.look_in(sampling.log());
  if (has_laws()) judge_.weigh_energies();
  judge_.choose_from(choices_of_rows(kept_, dynamics.dropped().rows()));
}

/// Turning counts by half of the box in which the centers of a connected part move, or its size.
void RunJudge::see_from_moving_axes() {
  MovingAxes axes = MovingAxes::of(dynamics_.system(), kept_);
  out_.connected_parts.resize(static_cast<std::size_t>(lengths_.size()));
  const ConnectedParts& connected = ConnectedParts::of(dynamics_.system());
  for (int body = dynamics_.system().body_count() - 1; body >= 0; --body)
    out_.connected_parts[connected.of_body(body)].first_body = body;
  const VectorXd diagonals = axes.diagonals(kept_);
  VectorXd arms = lengths_;
  for (Eigen::Index k = 0; k < diagonals.size(); ++k) {
    arms[k] = std::max(arms[k], diagonals[k] / 2);
    out_.connected_parts[k].speed_as_a_whole = axes.velocity.col(k).norm();
  }
  for (Eigen::Index k = 0; k < arms.size(); ++k) out_.connected_parts[k].length = arms[k];
  judge_.move_with(std::move(axes), std::move(arms));
}

namespace {

/// Whether any function among the parameters of a force is one of those.
template <class Which>
bool has_function(const Model& model, const Element& force, Which which) {
  for (std::size_t p = 0; p < force_kinds()[static_cast<std::size_t>(force.kind)].info.parameters.size(); ++p) {
    const int signal = model.force_parameters()[force.first_parameter + p].signal;
    if (signal >= 0 && which(*model.signals()[static_cast<std::size_t>(signal)])) return true;
  }
  return false;
}

bool is_law(const TimeFunction& it) { return !it.of_time() && !it.integral(); }
bool is_of_time(const TimeFunction& it) { return it.of_time(); }

}  // namespace

void RunJudge::look_at_forces() {
  const System& system = dynamics_.system();
  const Model& model = system.model();
  const ConnectedParts& connected = ConnectedParts::of(system);
  JudgedPart of_ground;
  const auto part_of = [&](int i, int j) -> JudgedPart& {
    return i == ground && j == ground ? of_ground
                                      : out_.connected_parts[static_cast<std::size_t>(connected.of_bodies(i, j))];
  };
  for (const int row : system.driven_rows()) out_.connected_parts[connected.of_row(row)].bursts_late = false;
  for (const Element& force : model.forces()) {
    JudgedPart& part = part_of(force.i, force.j);
    part.has_laws = part.has_laws || has_function(model, force, is_law);
    part.bursts_late = part.bursts_late && !has_function(model, force, is_of_time);
  }
  for (const JointForce& force : model.joint_forces()) {
    JudgedPart& part = part_of(force.i, force.j);
    part.has_laws = part.has_laws || !force.law->of_time();
    part.bursts_late = part.bursts_late && !force.law->of_time();
  }
  if (!model.user_forces().empty())
    for (JudgedPart& part : out_.connected_parts) part.has_laws = true;  // on whichever bodies
  for (const SwitchOwner& it : owners_of_switches(model)) {
    const Element& force = model.forces()[static_cast<std::size_t>(it.element)];
    part_of(force.i, force.j).bursts_late = true;
  }
}

bool RunJudge::has_laws() const {
  return std::any_of(out_.connected_parts.begin(), out_.connected_parts.end(),
                     [](const JudgedPart& part) { return part.has_laws; });
}

/// The motion may have been fast for a while between two kept steps only.
void RunJudge::look_at_speeds() {
  const auto relative = [](double in_run, double at_steps) {
    return at_steps > 0.0 && std::isfinite(in_run) ? std::sqrt(std::max(in_run / at_steps, 1.0)) : 1.0;
  };
  if (lengths_.size() == 1) {
    double kinetic = 0.0;
    for (const KeptStep* step : kept_)
      kinetic = std::max({kinetic, kinetic_energy(*step, step->y), kinetic_energy(*step, step->y_new)});
    out_.connected_parts[0].fastest = relative(sampling_.energies().kinetic, kinetic);
    return;
  }
  VectorXd speeds = VectorXd::Zero(lengths_.size()), there;
  for (const KeptStep* step : kept_)
    for (const VectorXd* y : {&step->y, &step->y_new}) {
      sampling_.find_squared_speeds(*y, there);
      speeds = speeds.cwiseMax(there);
    }
  for (Eigen::Index k = 0; k < speeds.size(); ++k)
    out_.connected_parts[k].fastest = relative(sampling_.fastest()[k], speeds[k]);
}

/// Seen from the ground, inerters included, which no time changes: tables may end where the step does.
double RunJudge::kinetic_energy(const KeptStep& step, const VectorXd& y) {
  const System& system = dynamics_.system();
  if (!system.inerters().empty()) {
    dynamics_.set_history(step.history);
    dynamics_.evaluate(step.t, y);
  }
  return system.kinetic_energy(dynamics_.evaluation(), y.segment(system.q_size(), system.v_size()));
}

/// Of a state, relative to the size and the speed of the part at all the steps.
double RunJudge::size(const StepError& error, std::size_t part) const {
  const StateDifference& end = error.of_part[part].end;
  const auto k = static_cast<Eigen::Index>(part);
  return std::max(std::max(end.position / lengths_[k], end.rotation),
                  speeds_[k] > 0.0 ? std::max(end.velocity, lengths_[k] * end.omega) / speeds_[k] : 0.0);
}

StepError RunJudge::judge_next(std::size_t k, int divisions, bool reactions, bool inside, const RetakenStep& retaken) {
  const auto parts = [](std::size_t steps, int times) { return static_cast<double>(steps << times); };
  const std::size_t count = kept_.size();
  const auto to_look_at_again = [&] {
    return worst_.empty() ? std::min(worst * std::min(worst_parts, out_.connected_parts.size()), count) : worst_.size();
  };
  if (progress_) progress_(done_ / (parts(count, divisions_) + parts(to_look_at_again(), divisions_of_worst)));
  done_ += parts(1, divisions);
  return judge_.judge(*kept_[k], reactions, inside, retaken);
}

void RunJudge::judge(const RetakenSteps& retaken) {
  judge_.divide_parts(divisions_);
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    out_.steps.push_back(
        judge_next(k, divisions_, k % every_reaction == 0, k % every_inside_ == 0, of_step(k, retaken)));
    if (sampling_.log().size() > 0) ends_.push_back({kept_[k]->t + kept_[k]->h, judge_.end(), judge_.exact_end()});
  }
  for (const StepError& it : out_.steps)
    for (std::size_t part = 0; part < it.of_part.size(); ++part)
      speeds_[static_cast<Eigen::Index>(part)] =
          std::max(speeds_[static_cast<Eigen::Index>(part)], it.of_part[part].speed);
  acquit_suspects();
  look_at_speeds();
  find_worst();
}

/// Suspects, the last of all, stay where they are far worse than the others: these speak for them else.
void RunJudge::acquit_suspects() {
  const std::size_t first = kept_.size() - suspects_;
  const auto is_far_worse = [&](std::size_t step) {
    for (std::size_t part = 0; part < out_.connected_parts.size(); ++part) {
      double worst = 0.0;
      for (std::size_t k = 0; k < first; ++k) worst = std::max(worst, size(out_.steps[k], part));
      if (!(size(out_.steps[step], part) <= far_worse * worst)) return true;
    }
    return out_.steps[step].failed;
  };
  std::size_t end = first;
  for (std::size_t k = first; k < kept_.size(); ++k) {
    if (!is_far_worse(k)) continue;
    std::swap(out_.steps[k], out_.steps[end]);
    if (!ends_.empty()) std::swap(ends_[k], ends_[end]);
    std::swap(out_.parts[out_.part_of[k]], out_.parts[out_.part_of[end]]);
    end += 1;
  }
  out_.parts.resize(out_.parts.size() - (kept_.size() - end));
  kept_.resize(end);
  out_.steps.resize(end);
  out_.part_of.resize(end);
}

std::vector<std::size_t> RunJudge::worst_of(std::size_t part) const {
  return largest_of(out_.steps.size(), worst, [&](std::size_t step) { return size(out_.steps[step], part); });
}

void RunJudge::find_worst() {
  const auto worst_error = [&](std::size_t part) {
    double largest = 0.0;
    for (const StepError& it : out_.steps) largest = std::max(largest, size(it, part));
    return largest;
  };
  std::vector<double> errors;
  for (std::size_t part = 0; part < out_.connected_parts.size(); ++part) errors.push_back(worst_error(part));
  for (const std::size_t part : largest_of(errors.size(), worst_parts, [&](std::size_t k) { return errors[k]; })) {
    worst_of_parts_.push_back({part, worst_of(part)});
    for (const std::size_t step : worst_of_parts_.back().steps)
      if (std::find(worst_.begin(), worst_.end(), step) == worst_.end()) worst_.push_back(step);
  }
}

std::vector<const KeptStep*> RunJudge::worst_steps() const {
  std::vector<const KeptStep*> out;
  for (const std::size_t k : worst_) out.push_back(kept_[k]);
  return out;
}

int RunJudge::worst_divisions() { return divisions_of_worst; }

RunErrors RunJudge::judge_worst(const RetakenSteps& retaken) {
  judge_.divide_parts(divisions_of_worst);
  std::vector<StepError> again;
  for (std::size_t k = 0; k < worst_.size(); ++k)
    again.push_back(judge_next(worst_[k], divisions_of_worst, false, false, of_step(k, retaken)));
  for (const WorstOfPart& of_part : worst_of_parts_) {
    double before = 0.0, after = 0.0;
    for (const std::size_t step : of_part.steps) {
      const StepError& first = out_.steps[step];
      const auto place = std::find(worst_.begin(), worst_.end(), step) - worst_.begin();
      if (first.failed || again[place].failed) continue;
      before += size(first, of_part.part);
      after += size(again[place], of_part.part);
    }
    if (before > 0.0 && after > before) out_.connected_parts[of_part.part].resolved = after / before;
  }
  out_.kinetic_share = judge_.kinetic_share();
  for (std::size_t k = 0; k < out_.connected_parts.size(); ++k) {
    JudgedPart& part = out_.connected_parts[k];
    part.kinetic = part.fastest * part.fastest * judge_.kinetic_energies()[static_cast<Eigen::Index>(k)];
  }
  look_for_rest();
  if (!sampling_.struck()) look_at_energies();
  look_for_nonlinearity();
  look_for_growth();
  return std::move(out_);
}

/// There the exact end of each step is known.
void RunJudge::look_for_rest() {
  std::vector<std::optional<Rest>> found = find_rest(dynamics_, kept_, {breaks_, golden_share}, lengths_);
  for (std::size_t part = 0; part < found.size(); ++part) {
    if (!found[part]) continue;
    for (std::size_t k = 0; k < out_.steps.size(); ++k) {
      PartError& error = out_.steps[k].of_part[part];
      error.end = found[part]->moved[k];
      error.inside = error.fading = {};
    }
    out_.connected_parts[part].rest = std::move(found[part]);
  }
}

/// Not where there are laws of the user's own, in whichever part: they may not know states that the run did not have.
void RunJudge::look_for_nonlinearity() {
  if (sampling_.struck() || sampling_.steps() < of_many_periods || has_laws()) return;
  const RankReport& rank = dynamics_.rank();
  std::vector<int> implied = rank.redundant_rows;
  implied.insert(implied.end(), rank.singular_rows.begin(), rank.singular_rows.end());
  const VectorXd found = find_nonlinearity(dynamics_, kept_, judge_.axes(), lengths_, implied);
  for (std::size_t part = 0; part < out_.connected_parts.size(); ++part)
    out_.connected_parts[part].nonlinearity = found[static_cast<Eigen::Index>(part)];
}

/// Of each of some parts of the run, up to a time, the worst: parts are the shorter the earlier, as what begins early
/// grows most; of few not the last parts, where nothing has time to grow.
std::vector<StepDifference> RunJudge::errors_to_follow(std::size_t count, double until) const {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < kept_.size(); ++k)
    if (!out_.steps[k].failed && ends_[k].t <= until && ends_[k].run.allFinite()) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return kept_[a]->t < kept_[b]->t; });
  const auto largest = [&](std::size_t k) {
    double out = 0.0;
    for (std::size_t part = 0; part < out_.connected_parts.size(); ++part)
      out = std::max(out, size(out_.steps[k], part));
    return out;
  };
  const std::size_t groups = count < few_errors ? count + 2 : count;
  const auto begin_of = [&](std::size_t group) {
    const double share = std::pow(static_cast<double>(group) / static_cast<double>(groups), 1.5);
    return order.begin() + static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(order.size())));
  };
  std::vector<StepDifference> out;
  for (std::size_t group = 0; group < count; ++group) {
    const auto first = begin_of(group), last = begin_of(group + 1);
    if (first == last) continue;
    out.push_back(
        ends_[*std::max_element(first, last, [&](std::size_t a, std::size_t b) { return largest(a) < largest(b); })]);
  }
  return out;
}

/// Not where the run changed the rows that it leaves out: those of one pose may be bad in another.
void RunJudge::look_for_growth() {
  const auto rests = [](const JudgedPart& part) { return part.rest.has_value(); };
  if (ends_.empty() || std::all_of(out_.connected_parts.begin(), out_.connected_parts.end(), rests)) return;
  if (choices_of_rows(kept_, dynamics_.dropped().rows()).size() > 1) return;
  VectorXd lengths = lengths_, speeds = speeds_;
  for (std::size_t part = 0; part < out_.connected_parts.size(); ++part) {
    const auto k = static_cast<Eigen::Index>(part);
    lengths[k] = out_.connected_parts[part].length;
    speeds[k] *= out_.connected_parts[part].fastest;
  }
  const auto follow = [this](std::size_t count, double until) { return errors_to_follow(count, until); };
  const std::int64_t usual = std::min(affordable, affordable_of_bodies / dynamics_.system().body_count());
  const std::int64_t of_laws = std::min(affordable_of_laws, most_of_step * sampling_.steps());
  const std::int64_t most = (has_laws() ? of_laws : usual) + sampling_.steps() / 2;
  out_.growth = find_error_growth(dynamics_, sampling_.log(), follow, judge_.axes(), lengths, speeds, most);
}

void RunJudge::look_at_energies() {
  std::vector<std::optional<EnergyMade>> found = find_energies_made(dynamics_, kept_, lengths_);
  for (std::size_t part = 0; part < found.size(); ++part)
    if (!out_.connected_parts[part].rest) out_.connected_parts[part].energy = std::move(found[part]);
}

RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take, JudgeProgress progress,
                    Dynamics* recorded) {
  RunJudge judge(sampling, dynamics, std::move(take));
  judge.report_to(std::move(progress));
  judge.compare_with(recorded);
  judge.judge();
  return judge.judge_worst();
}

}  // namespace linkwork
