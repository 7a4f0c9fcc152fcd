#include "bindings.hpp"
#include "linkwork/ensemble/ensemble.hpp"
#include "linkwork/ensemble/lane_timing.hpp"
#include "linkwork/ensemble/lane_trials.hpp"
#include "turns.hpp"

namespace linkwork::python {
namespace {

/// Each Dynamics busy, in the order of the list.
struct AllBusy {
  explicit AllBusy(const std::vector<Dynamics*>& dynamics) {
    for (const Dynamics* it : dynamics) each.push_back(std::make_unique<Busy>(*it));
  }
  std::vector<std::unique_ptr<Busy>> each;
};

py::list run_ensemble(const std::vector<Dynamics*>& dynamics, const ButcherTableau& tableau, double t_end, double step,
                      std::int64_t record_every, int threads, std::vector<LaneRun*> runs, std::vector<double> breaks,
                      bool counts_turns) {
  FixedSteps steps(t_end, step, record_every, std::move(breaks));
  if (counts_turns) steps.count_turns();
  const InstructionSet widest = best_instruction_set();
  const AllBusy busy(dynamics);
  std::vector<Ensemble::Member> members;
  {
    const py::gil_scoped_release release;
    Ensemble ensemble(dynamics, tableau, steps, widest, std::move(runs));
    ensemble.run(threads);
    members = ensemble.take();
  }
  py::list out;
  for (std::size_t k = 0; k < members.size(); ++k) {
    py::dict one;
    one["reason"] = members[k].reason;
    one["left_at"] = std::isnan(members[k].left_at) ? py::object(py::none()) : py::float_(members[k].left_at);
    if (!members[k].turned.empty()) one["turned"] = to_python(members[k].turned);
    if (members[k].reason.empty()) one["frames"] = frames_to_dict(std::move(members[k].frames), dynamics[k]->system());
    out.append(one);
  }
  return out;
}

std::vector<std::string> advance_together(const std::vector<AdaptiveSimulation*>& runs, int threads) {
  const InstructionSet widest = best_instruction_set();
  std::vector<Dynamics*> dynamics;
  for (AdaptiveSimulation* it : runs) dynamics.push_back(&it->mechanism());
  const AllBusy busy(dynamics);
  const py::gil_scoped_release release;
  return run_trials(runs, widest, threads);
}

py::tuple timed_lanes(const std::vector<Dynamics*>& dynamics, int repetitions, int threads) {
  const InstructionSet widest = best_instruction_set();
  const AllBusy busy(dynamics);
  LaneTiming found;
  {
    const py::gil_scoped_release release;
    found = time_lanes(dynamics, repetitions, threads, widest);
  }
  return py::make_tuple(found.seconds, found.v_dot);
}

}  // namespace

void bind_ensemble(py::module_& module) {
  module.def("lane_count", +[] { return lane_count(best_instruction_set()); }, "Mechanisms that fill a pack here.");
  module.def("time_lanes", &timed_lanes, py::arg("dynamics"), py::arg("repetitions"), py::arg("threads"),
             "(wall time [s] of one right-hand side with reactions of all of them, in full packs, one a thread; their "
             "v_dot (6n,)).");
  module.def("lane_refusal", &LaneStructure::refusal, py::arg("dynamics"),
             "Why lanes cannot run this, in words that end a sentence; empty where they can.");
  module.def(
      "advance_together", &advance_together, py::arg("runs"), py::arg("threads"),
      "Advances runs of equal options by one method to their ends, in the lanes of the processor. Of each why it "
      "did not come there, and has to be simulated by itself; empty: it did.");
  module.def(
      "run_ensemble", &run_ensemble, py::arg("dynamics"), py::arg("tableau"), py::arg("t_end"), py::arg("step"),
      py::arg("record_every"), py::arg("threads"), py::arg("runs") = std::vector<LaneRun*>(),
      py::arg("breaks") = std::vector<double>(), py::arg("counts_turns") = false,
      "Simulates all `dynamics`, of equal options, from their initial states by an explicit Runge-Kutta method, "
      "in the lanes of the processor. Of each {reason, left_at [s], frames}: frames as of Run.advance where the "
      "reason is empty, else why it has to be simulated by itself. `runs`: of each what its verdict is made of, or "
      "none of them. `breaks`: times [s] at which something is not smooth, beside those that they know. "
      "`counts_turns`: how far joints turned between frames, `turned`, where these do not tell it.");
}

}  // namespace linkwork::python
