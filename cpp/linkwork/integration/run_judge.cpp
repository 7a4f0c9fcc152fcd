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
constexpr int usual_divisions = 1, few_divisions = 2, worst_divisions = 3;  // powers of two

class RunJudge {
 public:
  RunJudge(const StepSampling& sampling, Dynamics& dynamics, SecondTake take)
      : length_(RelativeViolation(dynamics.system()).length()),
        every_inside_(sampling.steps() <= few_steps ? 1 : every_inside),
        judge_(dynamics, std::move(take), sampling.breaks()) {
    out_.corrections = sampling.corrections();
    judge_.divide_parts(divisions(sampling));
    out_.parts = parts_to_judge(sampling);
  }

  RunErrors judge(const std::vector<VectorXd>& retaken) {
    each_kept_step(out_.parts, [&](const KeptStep& step, int part) {
      const std::size_t count = out_.steps.size();
      const VectorXd& end = count < retaken.size() ? retaken[count] : nowhere_;
      out_.steps.push_back(judge_.judge(step, count % every_reaction == 0, count % every_inside_ == 0, end));
      out_.part_of.push_back(part);
      kept_.push_back(&step);
    });
    look_again();
    out_.diagonal = judge_.diagonal();
    return std::move(out_);
  }

 private:
  /// Of a state, relative to the size and the speed of the mechanism at all the steps.
  double size(const StepError& error) const {
    const StateDifference& end = error.end;
    return std::max(std::max(end.position / length_, end.rotation),
                    speed_ > 0.0 ? std::max(end.velocity, length_ * end.omega) / speed_ : 0.0);
  }

  void look_again() {
    for (const StepError& it : out_.steps) speed_ = std::max({speed_, it.speed, length_ * it.spin});
    std::vector<std::size_t> order(out_.steps.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::size_t count = std::min(worst, order.size());
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end(),
                      [&](std::size_t a, std::size_t b) { return size(out_.steps[a]) > size(out_.steps[b]); });
    judge_.divide_parts(worst_divisions);
    double before = 0.0, after = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const StepError& first = out_.steps[order[k]];
      const StepError again = judge_.judge(*kept_[order[k]], false);
      if (first.failed || again.failed) continue;
      before += size(first);
      after += size(again);
    }
    if (before > 0.0 && after > before) out_.resolved = after / before;
  }

  double length_, speed_ = 0.0;
  std::size_t every_inside_;
  StepJudge judge_;
  RunErrors out_;
  std::vector<const KeptStep*> kept_;
  const VectorXd nowhere_;
};

}  // namespace

std::vector<RunPart> parts_to_judge(const StepSampling& sampling) {
  std::vector<RunPart> out = sampling.parts();
  for (RunPart& part : sampling.broken()) out.push_back(std::move(part));
  for (RunPart& part : sampling.contacts()) out.push_back(std::move(part));
  for (const KeptStep& step : sampling.outliers(out)) {  // each a part of its own
    out.push_back({1, step.t, step.h, step.change, {}, {}});
    out.back().any = step;
  }
  return out;
}

int divisions(const StepSampling& sampling) {
  return sampling.steps() <= few_steps ? few_divisions : usual_divisions;
}

RunErrors judge_run(const StepSampling& sampling, Dynamics& dynamics, SecondTake take,
                    const std::vector<VectorXd>& retaken) {
  return RunJudge(sampling, dynamics, std::move(take)).judge(retaken);
}

}  // namespace linkwork
