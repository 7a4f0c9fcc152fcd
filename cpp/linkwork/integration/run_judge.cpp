#include "linkwork/integration/run_judge.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace linkwork {
namespace {

constexpr std::int64_t few_steps = 50;     // which are often long ones
constexpr std::size_t every_reaction = 6;  // steps of which reactions are compared, too
constexpr std::size_t every_inside = 3;    // the same for what is recorded inside, where there are not few
constexpr std::size_t worst = 3;           // steps that are looked at once more, in so many parts:
constexpr int usual_divisions = 1, few_divisions = 2, divisions_of_worst = 3;  // powers of two

std::vector<RunPart> parts_to_judge(const StepSampling& sampling) {
  std::vector<RunPart> out = sampling.parts();
  for (RunPart& part : out)
    for (KeptStep* step : {&part.any, &part.steepest})
      if (step->switched) *step = {};
  for (RunPart& part : sampling.broken()) out.push_back(std::move(part));
  for (RunPart& part : sampling.switched()) out.push_back(std::move(part));
  for (const KeptStep& step : sampling.outliers(out)) {  // each a part of its own
    out.push_back({1, step.t, step.h, step.change, 0.0, {}, {}});
    out.back().any = step;
  }
  return out;
}

std::vector<std::vector<int>> choices_of_rows(const std::vector<const KeptStep*>& steps, const std::vector<int>& last) {
  std::vector<std::vector<int>> out = {last};
  for (const KeptStep* step : steps)
    if (std::find(out.begin(), out.end(), step->left_out) == out.end()) out.push_back(step->left_out);
  return out;
}

const RetakenStep& of_step(std::size_t step, const RetakenSteps& retaken) {
  static const RetakenStep nowhere;
  return step < retaken.size() ? retaken[step] : nowhere;
}

}  // namespace

RunJudge::RunJudge(const StepSampling& sampling, Dynamics& dynamics, SecondTake take)
    : dynamics_(dynamics),
      length_(RelativeViolation::length_of(dynamics.system())),
      every_inside_(sampling.steps() <= few_steps ? 1 : every_inside),
      divisions_(sampling.steps() <= few_steps ? few_divisions : usual_divisions),
      breaks_(sampling.breaks()),
      judge_(dynamics, std::move(take), breaks_) {
  out_.corrections = sampling.corrections();
  out_.parts = parts_to_judge(sampling);
  for (std::size_t k = 0; k < out_.parts.size(); ++k)
    for (const KeptStep* step : {&out_.parts[k].any, &out_.parts[k].steepest}) {
      if (!step->kept()) continue;
      kept_.push_back(step);
      out_.part_of.push_back(static_cast<int>(k));
    }
  see_from_moving_axes();
  judge_.choose_from(choices_of_rows(kept_, dynamics.dropped().rows()));
}

/// Turning counts by half of the box in which the centers of a connected part move, or the size of the mechanism.
void RunJudge::see_from_moving_axes() {
  MovingAxes axes = MovingAxes::of(dynamics_.system(), kept_);
  out_.speed_as_a_whole = axes.fastest();
  VectorXd arms = VectorXd::Constant(dynamics_.system().body_count(), length_);
  const VectorXd diagonals = axes.diagonals(kept_);
  for (std::size_t body = 0; body < axes.part.size(); ++body) {
    const double diagonal = diagonals[axes.part[body]];
    out_.diagonal = std::max(out_.diagonal, diagonal);
    double& arm = arms[static_cast<Eigen::Index>(body)];
    arm = std::max(arm, diagonal / 2);
  }
  judge_.move_with(std::move(axes), std::move(arms));
}

/// Of a state, relative to the size and the speed of the mechanism at all the steps.
double RunJudge::size(const StepError& error) const {
  const StateDifference& end = error.end;
  return std::max(std::max(end.position / length_, end.rotation),
                  speed_ > 0.0 ? std::max(end.velocity, length_ * end.omega) / speed_ : 0.0);
}

StepError RunJudge::judge_next(std::size_t k, int divisions, bool reactions, bool inside, const RetakenStep& retaken) {
  const auto parts = [](std::size_t steps, int times) { return static_cast<double>(steps << times); };
  const std::size_t count = kept_.size();
  if (progress_) progress_(done_ / (parts(count, divisions_) + parts(std::min(worst, count), divisions_of_worst)));
  done_ += parts(1, divisions);
  return judge_.judge(*kept_[k], reactions, inside, retaken);
}

void RunJudge::judge(const RetakenSteps& retaken) {
  judge_.divide_parts(divisions_);
  for (std::size_t k = 0; k < kept_.size(); ++k)
    out_.steps.push_back(
        judge_next(k, divisions_, k % every_reaction == 0, k % every_inside_ == 0, of_step(k, retaken)));
  for (const StepError& it : out_.steps) speed_ = std::max(speed_, it.speed);
  std::vector<std::size_t> order(out_.steps.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t count = std::min(worst, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                    [&](std::size_t a, std::size_t b) { return size(out_.steps[a]) > size(out_.steps[b]); });
  order.resize(count);
  worst_ = std::move(order);
}

std::vector<const KeptStep*> RunJudge::worst_steps() const {
  std::vector<const KeptStep*> out;
  for (const std::size_t k : worst_) out.push_back(kept_[k]);
  return out;
}

int RunJudge::worst_divisions() { return divisions_of_worst; }

RunErrors RunJudge::judge_worst(const RetakenSteps& retaken) {
  judge_.divide_parts(divisions_of_worst);
  double before = 0.0, after = 0.0;
  for (std::size_t k = 0; k < worst_.size(); ++k) {
    const StepError& first = out_.steps[worst_[k]];
    const StepError again = judge_next(worst_[k], divisions_of_worst, false, false, of_step(k, retaken));
    if (first.failed || again.failed) continue;
    before += size(first);
    after += size(again);
  }
  if (before > 0.0 && after > before) out_.resolved = after / before;
  out_.kinetic_share = judge_.kinetic_share();
  look_for_rest();
  return std::move(out_);
}

/// There the exact end of each step is known.
void RunJudge::look_for_rest() {
  out_.rest = find_rest(dynamics_, kept_, {breaks_, golden_share}, length_);
  if (!out_.rest) return;
  for (std::size_t k = 0; k < out_.steps.size(); ++k) {
    out_.steps[k].end = out_.rest->moved[k];
    out_.steps[k].inside = out_.steps[k].fading = {};
  }
}

RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take, JudgeProgress progress) {
  RunJudge judge(sampling, dynamics, std::move(take));
  judge.report_to(std::move(progress));
  judge.judge();
  return judge.judge_worst();
}

}  // namespace linkwork
