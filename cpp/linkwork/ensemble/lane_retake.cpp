#include "linkwork/ensemble/lane_retake.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/integration/runge_kutta.hpp"

namespace linkwork {
namespace {

std::vector<Dynamics*> mechanisms_of_runs(const std::vector<LaneRun*>& runs) {
  std::vector<Dynamics*> out;
  for (LaneRun* run : runs) out.push_back(&run->dynamics);
  return out;
}

}  // namespace

LaneRetake::LaneRetake(const LaneStructure& structure, const InstructionSet& instructions,
                       const std::vector<LaneRun*>& runs, const ButcherTableau& tableau)
    : structure_(structure),
      stepper_(structure, instructions, mechanisms_of_runs(runs), tableau),
      projection_(stepper_, mechanisms_of_runs(runs)),
      spans_(stepper_.width()),
      shares_(stepper_.width(), 1.0),
      ends_(stepper_.width(), 0.0) {
  std::fill(spans_.h.begin(), spans_.h.end(), 1.0);  // of lanes that have no step
  for (LaneRun* run : runs) lanes_.push_back({run, {run->sampling.breaks(), golden_share}, nullptr, {}, false});
}

std::vector<RetakenSteps> LaneRetake::retake(const std::vector<std::vector<Step>>& steps, int divisions,
                                             const std::function<void()>& look) {
  std::vector<RetakenSteps> out;
  std::size_t most = 0;
  for (const auto& of_run : steps) {
    out.emplace_back(of_run.size());
    most = std::max(most, of_run.size());
  }
  for (Lane& lane : lanes_) lane.parts.divide(divisions);
  const std::size_t parts = std::size_t{1} << divisions;
  for (std::size_t step = 0; step < most; ++step) {
    for (int l = 0; l < stepper_.count(); ++l) {
      lanes_[l].active = step < steps[l].size();
      if (lanes_[l].active) begin(l, steps[l][step], parts);
    }
    take(parts);
    for (int l = 0; l < stepper_.count(); ++l) {
      if (!lanes_[l].active) continue;
      RetakenStep& found = out[l][step];
      found.end.resize(structure_.y_size());
      stepper_.state(l, found.end);
      found.rows_change = steps[l][step].rows_change;
      found.smallest_pivot = lanes_[l].smallest_pivot;
    }
    look();
  }
  return out;
}

void LaneRetake::begin(int l, const Step& step, std::size_t parts) {
  Lane& lane = lanes_[l];
  lane.step = step.kept;
  lane.smallest_pivot = 1.0;
  lane.looked = step.rows_change;
  lane.spans = lane.parts.of(step.kept->t, step.kept->h);
  lane.active = lane.spans.size() == parts && step.kept->left_out == structure_.dropped &&
                lane.run->dynamics.system().history_size() == 0;
  if (lane.active) stepper_.set_state(l, step.kept->y);
}

void LaneRetake::take(std::size_t parts) {
  for (std::size_t part = 0; part < parts; ++part) {
    for (int l = 0; l < stepper_.count(); ++l) {
      if (!lanes_[l].active) continue;
      spans_.set(l, lanes_[l].spans[part]);
      ends_[l] = lanes_[l].spans[part].at(1.0);
    }
    stepper_.evaluate(spans_, *this);
    if (part == 0) hold();
    stepper_.step(spans_, *this);
    for (Lane& lane : lanes_) lane.looked = false;
    stepper_.normalize();
    projection_.stabilize(ends_, *this);
  }
}

/// The correction that a step holds is that of the whole, in all of its parts.
void LaneRetake::hold() {
  for (int l = 0; l < stepper_.count(); ++l)
    if (lanes_[l].active) shares_[l] = spans_.h[l] / std::max(lanes_[l].step->h, lanes_[l].step->correction_length);
  stepper_.hold(spans_, shares_.data());
}

void LaneRetake::note(int l, double t, double pivot, bool first) {
  SingularWatch& watch = lanes_[l].run->dynamics.formulation().watch();
  lanes_[l].smallest_pivot = std::min(lanes_[l].smallest_pivot, pivot);
  const bool ahead = first && lanes_[l].looked;  // the watch does not hear of such a factorization
  if (!ahead) watch.note(t, pivot);
  const bool usual = pivot > singular_pivot && (ahead || watch.usual(pivot));
  if (!usual || !structure_.keeps_order(lanes_[l].run->dynamics, pivot)) lanes_[l].active = false;
}

namespace {

using StepsOfRuns = std::vector<std::vector<const KeptStep*>>;

/// Takes each step by lanes that leave out the rows which its run left out.
class RetakeByRows {
 public:
  RetakeByRows(const std::vector<const LaneStructure*>& structures, const InstructionSet& instructions,
               const std::vector<LaneRun*>& runs, const ButcherTableau& tableau)
      : structures_(structures), instructions_(instructions), runs_(runs), tableau_(tableau) {}

  std::vector<RetakenSteps> retake(const StepsOfRuns& steps, int divisions, const std::function<void()>& look) const {
    std::vector<RetakenSteps> out;
    for (const auto& of_run : steps) out.emplace_back(of_run.size());
    for (const LaneStructure* structure : structures_) retake(*structure, steps, divisions, look, out);
    return out;
  }

 private:
  void retake(const LaneStructure& structure, const StepsOfRuns& all, int divisions, const std::function<void()>& look,
              std::vector<RetakenSteps>& out) const {
    std::vector<std::vector<LaneRetake::Step>> steps(all.size());
    std::vector<std::vector<std::size_t>> places(all.size());
    for (std::size_t run = 0; run < all.size(); ++run)
      for (std::size_t k = 0; k < all[run].size(); ++k) {
        if (all[run][k]->left_out != structure.dropped) continue;
        const std::vector<int>& before = k > 0 ? all[run][k - 1]->left_out : runs_[run]->dynamics.dropped().rows();
        steps[run].push_back({all[run][k], before != structure.dropped});
        places[run].push_back(k);
      }
    if (std::all_of(steps.begin(), steps.end(), [](const auto& of_run) { return of_run.empty(); })) return;
    LaneRetake lanes(structure, instructions_, runs_, tableau_);
    std::vector<RetakenSteps> found = lanes.retake(steps, divisions, look);
    for (std::size_t run = 0; run < all.size(); ++run)
      for (std::size_t k = 0; k < places[run].size(); ++k) out[run][places[run][k]] = std::move(found[run][k]);
  }

  const std::vector<const LaneStructure*>& structures_;
  const InstructionSet& instructions_;
  const std::vector<LaneRun*>& runs_;
  const ButcherTableau& tableau_;
};

/// What a run found on its way, which taking steps again changes.
class Findings {
 public:
  explicit Findings(Dynamics& dynamics)
      : dynamics_(dynamics), history_(dynamics.history()), watch_(dynamics.formulation().watch()) {}
  Findings(const Findings&) = delete;
  Findings& operator=(const Findings&) = delete;
  ~Findings() {
    dynamics_.set_history(history_);
    dynamics_.formulation().watch() = watch_;
  }

 private:
  Dynamics& dynamics_;
  VectorXd history_;
  SingularWatch watch_;
};

}  // namespace

// Runs whose steps are divided otherwise than those of the first, and those whose judging fails, are judged by
// themselves by whoever asks for it.
void judge_runs(const std::vector<const LaneStructure*>& structures, const InstructionSet& instructions,
                const std::vector<LaneRun*>& runs, const ButcherTableau& tableau, const std::function<void()>& look) {
  std::vector<std::unique_ptr<Findings>> findings;
  for (const LaneRun* run : runs) findings.push_back(std::make_unique<Findings>(run->dynamics));
  std::vector<RunJudge> judges;
  judges.reserve(runs.size());
  for (LaneRun* run : runs) judges.emplace_back(run->sampling, run->dynamics, in_parts(make_runge_kutta(tableau)));
  const RetakeByRows lanes(structures, instructions, runs, tableau);
  StepsOfRuns steps(runs.size());
  const int divisions = judges.front().divisions();
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (judges[k].divisions() == divisions) steps[k] = judges[k].steps();
  const std::vector<RetakenSteps> first = lanes.retake(steps, divisions, look);
  const auto told_by_whoever_asks = [](const std::string&) {};
  std::vector<char> judged(runs.size(), 0);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    steps[k].clear();
    do_apart(
        [&] {
          judges[k].judge(first[k]);
          steps[k] = judges[k].worst_steps();
          judged[k] = 1;
        },
        told_by_whoever_asks);
  }
  const std::vector<RetakenSteps> again = lanes.retake(steps, RunJudge::worst_divisions(), look);
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (judged[k]) do_apart([&] { runs[k]->errors = judges[k].judge_worst(again[k]); }, told_by_whoever_asks);
}

}  // namespace linkwork
