#include "exclusive.hpp"
#include "judged.hpp"
#include "linkwork/integration/adaptive_simulation.hpp"
#include "linkwork/integration/simulation.hpp"
#include "methods.hpp"
#include "turns.hpp"

namespace linkwork::python {

py::array_t<double> to_numpy(std::vector<double>&& values, std::vector<py::ssize_t> shape) {
  auto* owner = new std::vector<double>(std::move(values));
  const py::capsule release(owner, [](void* pointer) { delete static_cast<std::vector<double>*>(pointer); });
  return py::array_t<double>(std::move(shape), owner->data(), release);
}

py::dict frames_to_dict(Frames&& frames, const System& system) {
  const auto count = static_cast<py::ssize_t>(frames.t.size());
  const auto nq = static_cast<py::ssize_t>(system.q_size()), nv = static_cast<py::ssize_t>(system.v_size());
  py::dict out;
  out["t"] = to_numpy(std::move(frames.t), {count});
  out["q"] = to_numpy(std::move(frames.q), {count, nq});
  out["v"] = to_numpy(std::move(frames.v), {count, nv});
  out["vdot"] = to_numpy(std::move(frames.v_dot), {count, nv});
  out["lambda"] = to_numpy(std::move(frames.lambda), {count, static_cast<py::ssize_t>(system.row_count())});
  out["kinetic"] = to_numpy(std::move(frames.kinetic), {count});
  out["potential"] = to_numpy(std::move(frames.potential), {count});
  out["work"] = to_numpy(std::move(frames.work), {count});
  out["violation"] = to_numpy(std::move(frames.violation), {count, 3});
  out["history"] = to_numpy(std::move(frames.history), {count, static_cast<py::ssize_t>(system.history_size())});
  if (frames.reaction_force.empty()) return out;
  const std::vector<py::ssize_t> of_joints = {count, static_cast<py::ssize_t>(system.joint_count()), 3};
  out["reaction_force"] = to_numpy(std::move(frames.reaction_force), of_joints);
  out["reaction_torque"] = to_numpy(std::move(frames.reaction_torque), of_joints);
  return out;
}

namespace {

/// Where the run is now.
double relative_violation(const Run& run) {
  return RelativeViolation(run.dynamics().system()).largest(run.t(), run.y(), run.dynamics().history());
}

py::dict judged(const Dynamics& run, double end_violation, Dynamics& dynamics, bool steps,
                const std::function<AccumulatedError()>& find) {
  std::optional<Busy> busy;
  if (&dynamics != &run) busy.emplace(dynamics);
  AccumulatedError found;
  {
    const py::gil_scoped_release release;
    found = find();
    found.violation = std::max(found.violation, end_violation);
  }
  return to_dict(found, dynamics.system(), steps);
}

py::dict judge(const Run& run, Dynamics& dynamics, const py::object& method, bool other,
               const std::optional<JudgeProgress>& progress, const py::object& recorded) {
  std::optional<Busy> busy;
  Dynamics* own = recorded.is_none() ? nullptr : recorded.cast<Dynamics*>();
  if (own && own != &run.dynamics()) busy.emplace(*own);
  SecondTake take = second_take(method, other, run.records_inside());
  return judged(run.dynamics(), relative_violation(run), dynamics, true, [&] {
    return accumulate(judge_run(run.sampling(), dynamics, std::move(take), progress.value_or(nullptr), own));
  });
}

double relative_violation_of_lane(const LaneRun& run) {
  return RelativeViolation(run.dynamics.system()).largest(run.t, run.y, run.dynamics.history());
}

py::dict judge_lane(const LaneRun& run, Dynamics& dynamics, const py::object& method, bool other, bool steps) {
  const double violation = relative_violation_of_lane(run);
  if (run.errors && &dynamics == &run.dynamics && !other)
    return judged(run.dynamics, violation, dynamics, steps, [&] { return accumulate(*run.errors); });
  SecondTake take = second_take(method, other, false);
  return judged(run.dynamics, violation, dynamics, steps,
                [&] { return accumulate(judge_run(run.sampling, dynamics, std::move(take))); });
}

void advance(Run& run, std::int64_t max_frames, double max_seconds) {
  const py::gil_scoped_release release;
  run.run_on(max_frames, max_seconds);
}

py::list excesses(const Run& run) {
  constexpr const char* levels[] = {"position", "velocity", "acceleration"};
  const Model& model = run.dynamics().system().model();
  py::list out;
  for (const Excess& it : run.violation_monitor().excesses()) {
    py::dict one;
    one["level"] = levels[it.level];
    one["t"] = it.t;
    one["largest"] = it.largest;
    one["joint"] = model.joint_name(model.joint_of_row(it.row));
    out.append(one);
  }
  return out;
}

py::dict to_dict(const Run& run, const Contradiction& found) {
  const Model& model = run.dynamics().system().model();
  py::dict out;
  out["t"] = found.t;
  out["largest"] = found.largest;
  py::list joints;
  for (const int joint : found.joints) joints.append(model.joint_name(joint));
  out["joints"] = joints;
  return out;
}

py::dict run_statistics(const Run& run) {
  py::dict out = py::cast(&run.dynamics(), py::return_value_policy::reference).attr("statistics")();
  out["steps"] = run.steps_done();
  out["violations"] = run.violation_monitor().count();
  out["projections"] = run.projections();
  out["excesses"] = excesses(run);
  if (const Contradiction& found = run.contradiction(); !std::isnan(found.t))
    out["contradiction"] = to_dict(run, found);
  return out;
}

py::list turned(const Run& run) { return run.turns() ? to_python(run.turns()->found()) : py::list(); }

void bind_events(py::module_& module) {
  using Change = std::function<std::pair<VectorXd, bool>(double, const VectorXd&)>;
  py::class_<Event>(module, "Event", "What happens when a function of (t, y) passes through zero; y = (q, v).")
      .def(py::init([](std::string name, std::function<double(double, const VectorXd&)> function, int direction,
                       bool terminal, std::optional<Change> change, std::optional<double> tolerance) {
             Event event{std::move(name), std::move(function), direction, terminal, {}, tolerance};
             if (change)
               event.change = [change = std::move(*change)](double t, const VectorXd& y) {
                 auto [after, ends] = change(t, y);
                 return Changed{std::move(after), ends};
               };
             return event;
           }),
           py::arg("name"), py::arg("function"), py::arg("direction"), py::arg("terminal"), py::arg("change"),
           py::arg("tolerance"))
      .def_readonly("name", &Event::name)
      .def_property_readonly(
          "signature",
          [](const Event& it) { return py::make_tuple(it.direction, it.terminal, bool(it.change), it.tolerance); },
          "What beside its functions decides on the steps: direction, terminal, whether it has a change, tolerance.");
}

/// (t, state), or None.
py::object to_python(const Checkpoint& it) {
  if (std::isnan(it.t)) return py::none();
  return py::make_tuple(it.t, py::bytes(it.state));
}

void bind_checkpoints(py::class_<Run>& run) {
  run.def("resume",
          exclusive(+[](Run& it, const py::bytes& state, double work) { it.resume(std::string(state), work); }),
          py::arg("state"), py::arg("work"),
          "Before the first step: goes on from a checkpoint at or before the start, of a run of the same mechanism by "
          "the same method, as that one would have gone on; `work` [J] at the start.")
      .def_property_readonly("checkpoint", exclusive(+[](const Run& it) { return to_python(it.checkpoint()); }),
                             "(t, state), not after the last frame that was taken; None: there is none.")
      .def_property_readonly("last_checkpoint",
                             exclusive(+[](const Run& it) { return to_python(it.last_checkpoint()); }),
                             "The same, not after last_state.")
      .def_property_readonly("work",
                             exclusive(+[](const Run& it) { return it.last_state()[it.last_state().size() - 1]; }),
                             "Of last_state [J].");
}

py::tuple to_python(const EnergyRange& it) {
  return py::make_tuple(it.kinetic, it.least_potential, it.largest_potential, it.work);
}

py::dict balance_to_dict(LaneRun& run) {
  EnergyFrames frames = std::exchange(run.balance, {});
  const auto count = static_cast<py::ssize_t>(frames.t.size());
  py::dict out;
  out["t"] = to_numpy(std::move(frames.t), {count});
  out["kinetic"] = to_numpy(std::move(frames.kinetic), {count});
  out["potential"] = to_numpy(std::move(frames.potential), {count});
  out["work"] = to_numpy(std::move(frames.work), {count});
  return out;
}

py::list to_python(const std::vector<PassedTouch>& touches, const System& system) {
  py::list out;
  const std::vector<SwitchOwner> owners = owners_of_switches(system.model());
  for (const PassedTouch& it : touches) {
    const SwitchOwner& owner = owners[static_cast<std::size_t>(it.which)];
    const bool contact = system.switches()[static_cast<std::size_t>(it.which)] >= 0;
    py::dict one;
    one[contact ? "contact" : "stop"] = system.model().force_names().name(owner.element);
    one["t"] = it.t;
    one["until"] = it.until;
    one["speed"] = it.speed;
    one["change"] = it.change;
    one["steps"] = it.steps;
    out.append(one);
  }
  return out;
}

/// What the verdict of a member of an ensemble is made of.
void bind_lane_runs(py::module_& module) {
  py::class_<LaneRun>(module, "LaneRun", "What the verdict of a member of an ensemble is made of, as that of a Run.")
      .def(py::init([](Dynamics& dynamics, double t_end, double step, std::int64_t balance_every, bool follow_errors) {
             const Busy busy(dynamics);
             const FixedSteps steps(t_end, step, std::max<std::int64_t>(balance_every, 1));
             return std::make_unique<LaneRun>(dynamics, steps, balance_every > 0, follow_errors);
           }),
           py::arg("dynamics"), py::arg("t_end"), py::arg("step"), py::arg("balance_every") = 0,
           py::arg("follow_errors") = true, py::keep_alive<1, 2>(),
           "balance_every: steps between the energies that are kept; 0: none. follow_errors: whether the verdict knows "
           "how they grow.")
      .def(
          "expect_breaks",
          [](LaneRun& run, std::vector<double> times) { run.sampling.expect_breaks(std::move(times)); },
          py::arg("times"))
      .def_property_readonly("t", [](const LaneRun& run) { return run.t; })
      .def_property_readonly("steps_done", [](const LaneRun& run) { return run.steps; })
      .def_property_readonly("has_steps", [](const LaneRun& run) { return run.steps > 0; })
      .def_property_readonly("passed_touches",
                             [](const LaneRun& run) { return to_python(run.touches.passed(), run.dynamics.system()); })
      .def_property_readonly("energies", [](const LaneRun& run) { return to_python(run.sampling.energies()); })
      .def("take_balance", &balance_to_dict, "Energies by name as in frames, which are handed over.")
      .def("relative_violation", exclusive(&relative_violation_of_lane))
      .def("judge", exclusive(&judge_lane), py::arg("dynamics"), py::arg("method"), py::arg("other") = false,
           py::arg("steps") = true, "As of Run; without `steps` only how many were `taken` again.");
}

/// What a run says of itself on its way.
void bind_measures(py::class_<Run>& run) {
  run.def("relative_violation", exclusive(&relative_violation),
          "Largest violation of a position constraint now, relative to the size of the mechanism.")
      .def_property_readonly(
          "energies", exclusive(+[](const Run& run) { return to_python(run.sampling().energies()); }),
          "Largest kinetic energy, least and largest potential, largest amount of work over the steps so far [J].")
      .def_property_readonly("turned", exclusive(&turned),
                             "[joint, coordinate, before, t, angle] of how far joints turned from one frame to another "
                             "[s], where these do not tell it; None: steps were too long to tell.");
}

/// Where it is.
void bind_progress(py::class_<Run>& run) {
  run.def_property_readonly("finished", &Run::finished)
      .def_property_readonly("t", &Run::t)
      .def_property_readonly("last_state", exclusive(+[](const Run& run) {
                               return VectorXd(run.last_state().head(run.last_state().size() - 1));
                             }),
                             "y = (q, v) at t, from which the run went on.")
      .def_property_readonly("history", exclusive(+[](const Run& run) { return VectorXd(run.dynamics().history()); }),
                             "Of last_state; see Dynamics.history.")
      .def_property_readonly("steps_done", &Run::steps_done)
      .def_property_readonly("has_steps", &Run::has_steps, "Its own, or the one that it goes on inside of.")
      .def_property_readonly("steps_total", &Run::steps_total, "0 where nobody knows.");
}

void bind_runs(py::module_& module) {
  module.def("time_sampling", exclusive(&time_sampling), py::arg("dynamics"), py::arg("steps"),
             "Time that a run of so many steps spends on following them for its verdict [s].");
  py::class_<Run> run(module, "Run", "A simulation on its way, advanced in pieces.");
  run.def("advance", exclusive(&advance), py::arg("max_frames"), py::arg("max_seconds"),
          "Runs on until so many frames are there, or so much time has passed.")
      .def("take_frames", exclusive(+[](Run& run, bool at_the_end) {
             return frames_to_dict(run.take_frames(at_the_end), run.dynamics().system());
           }),
           py::arg("at_the_end") = false,
           "The frames recorded since the last call: t, q, v, vdot, lambda, kinetic, potential, work, violation, "
           "history. At the end also one that waits for a step which will not come. In a call of its own, as an "
           "interrupt may take away what `advance` would return.")
      .def("record_reactions", exclusive(+[](Run& run) { run.record_reactions(); }),
           "Frames have reaction_force and reaction_torque (k, joints, 3), too: as Dynamics.reactions finds them, for "
           "less. Before the first frame.")
      .def(
          "expect_breaks", &Run::expect_breaks, py::arg("times"),
          "Times [s], ascending, at which something is not smooth and no step ends: of the steps that contain one some "
          "are taken again, too.")
      .def("judge", exclusive(&judge), py::arg("dynamics"), py::arg("method"), py::arg("other") = false,
           py::arg("progress") = py::none(), py::arg("recorded") = py::none(),
           "Takes the kept steps of the run again by `dynamics`, which is used up, and says what they were off by, "
           "relative to the motion: steps (t, h, state, reactions or None), and what AccumulatedError has of the run. "
           "`method`: that of the run, or one that is much more accurate, and `other`. `progress` is called with the "
           "share that is done, as each step is begun. `recorded`, used up, too: by the equations of the run, where "
           "`dynamics` has exact ones.")
      .def("statistics", &run_statistics);  // by way of those of its dynamics
  bind_progress(run);
  bind_measures(run);
  bind_checkpoints(run);
}

py::dict statistics_of_fixed_steps(const Simulation& run) {
  py::dict out = run_statistics(run);
  if (py::list passed = to_python(run.passed_touches(), run.dynamics().system()); !passed.empty())
    out["passed_touches"] = passed;
  return out;
}

void bind_fixed_steps(py::module_& module) {
  py::class_<Simulation, Run>(module, "Simulation", "A run with a fixed step.")
      .def(py::init([](Dynamics& dynamics, const py::object& integrator, double t_end, double step,
                       std::int64_t record_every, double t_start, const VectorXd& start, std::vector<double> breaks) {
             const Busy busy(dynamics);
             return std::make_unique<Simulation>(dynamics, make_integrator(integrator),
                                                 Schedule{.t_end = t_end,
                                                          .step = step,
                                                          .record_every = record_every,
                                                          .t_start = t_start,
                                                          .start = start,
                                                          .breaks = std::move(breaks)});
           }),
           py::arg("dynamics"), py::arg("integrator"), py::arg("t_end"), py::arg("step"), py::arg("record_every") = 1,
           py::arg("t_start") = 0.0, py::arg("start") = VectorXd(), py::arg("breaks") = std::vector<double>(),
           py::keep_alive<1, 2>())
      .def("statistics", &statistics_of_fixed_steps)
      .def_property_readonly("origin", &Simulation::origin, "From which steps are counted [s].")
      .def("begin_step", exclusive(+[](Simulation& simulation) {
             const double h = simulation.begin_step();
             return py::make_tuple(simulation.t(), VectorXd(simulation.y().head(simulation.y().size() - 1)), h);
           }),
           "(t, y, h) of the step that begins; h = 0 at the end.")
      .def("accept", exclusive(+[](Simulation& simulation, const ConstVector& y) { simulation.accept(y); }),
           py::arg("y"));
}

using HappenedEvents = std::vector<std::pair<std::size_t, VectorXd>>;
using ListedEvents = std::vector<std::pair<std::size_t, double>>;

template <class Event, class List>
std::vector<Event> events_of(const List& given) {
  std::vector<Event> out;
  for (const auto& [event, value] : given) out.push_back({event, value});
  return out;
}

std::optional<std::vector<Listed>> listed_of(const std::optional<ListedEvents>& given) {
  return given ? std::optional(events_of<Listed>(*given)) : std::nullopt;
}

std::optional<ListedEvents> listed_events(const AdaptiveSimulation& run) {
  if (!run.knows_listed()) return std::nullopt;
  ListedEvents out;
  for (const Listed& it : run.listed()) out.emplace_back(it.event, it.t);
  return out;
}

// Long: one statement a method, and what a run is made from by name.
void bind_adaptive_steps(py::module_& module) {
  py::class_<AdaptiveSimulation, Run>(module, "AdaptiveSimulation", "A run with steps as large as tolerances allow.")
      .def(py::init([](Dynamics& dynamics, const EmbeddedPair& pair, double t_end, double rtol, double atol,
                       double largest_step, std::int64_t record_every, std::vector<double> times,
                       std::vector<Event> events, double t_start, const VectorXd& start, std::vector<double> breaks,
                       const HappenedEvents& happened, const std::optional<ListedEvents>& listed) {
             const Busy busy(dynamics);
             return std::make_unique<AdaptiveSimulation>(dynamics, pair,
                                                         AdaptiveSchedule{.t_end = t_end,
                                                                          .tolerances = {rtol, atol},
                                                                          .largest_step = largest_step,
                                                                          .record_every = record_every,
                                                                          .times = std::move(times),
                                                                          .t_start = t_start,
                                                                          .start = start,
                                                                          .breaks = std::move(breaks),
                                                                          .happened = events_of<Happened>(happened),
                                                                          .listed = listed_of(listed)},
                                                         std::move(events));
           }),
           py::arg("dynamics"), py::arg("pair"), py::arg("t_end"), py::arg("rtol"), py::arg("atol"),
           py::arg("largest_step"), py::arg("record_every"), py::arg("times"), py::arg("events") = std::vector<Event>(),
           py::arg("t_start") = 0.0, py::arg("start") = VectorXd(), py::arg("breaks") = std::vector<double>(),
           py::arg("happened") = HappenedEvents(), py::arg("listed") = py::none(), py::keep_alive<1, 2>())
      .def("take_occurrences", exclusive(+[](AdaptiveSimulation& run) {
             py::list out;
             for (const Occurrence& it : run.take_occurrences())
               out.append(py::make_tuple(it.event, it.t, it.before, it.after));
             return out;
           }),
           "(index of the event, t, y before, y after) of the events since the last call; y = (q, v).")
      .def_property_readonly("listed_events", &listed_events, "(index, t) of all; None: not all are known.")
      .def("energies_around_events", exclusive(+[](const AdaptiveSimulation& run) {
             py::list out;
             for (const auto& [before, after] : run.energies_around_events())
               for (const Energies& it : {before, after}) out.append(py::make_tuple(it.work, it.kinetic, it.potential));
             return out;
           }),
           "(work, kinetic energy, potential energy) before each event that came, and after it; NaN: not known.")
      .def("take_strikes", exclusive(+[](AdaptiveSimulation& run) {
             py::list out;
             for (const Strike& it : run.take_strikes())
               out.append(
                   py::make_tuple(it.t, it.potential, it.before.y, it.before.kinetic, it.after.y, it.after.kinetic));
             return out;
           }),
           "(t, potential energy, y before, kinetic energy before, y after, kinetic energy after) of bodies struck by "
           "drivers since the last call; y = (q, v, work).")
      .def("statistics", [](const AdaptiveSimulation& run) {
        py::dict out = run_statistics(run);
        const StepStatistics& steps = run.step_statistics();
        out["rejected_steps"] = steps.rejected;
        out["singular_steps"] = steps.singular;
        out["breaks"] = steps.breaks;
        out["impacts"] = steps.impacts;
        out["smallest_step"] = run.steps_done() > 0 ? py::object(py::float_(steps.smallest)) : py::none();
        out["largest_step"] = run.steps_done() > 0 ? py::object(py::float_(steps.largest)) : py::none();
        return out;
      });
}

void bind_break_points(py::module_& module) {
  py::class_<BreakPoints>(module, "BreakPoints",
                          "Times (b,) [s] at which something is not smooth; those that roundoff parts are one.")
      .def(py::init<std::vector<double>>(), py::arg("times"))
      .def("meet_steps", &BreakPoints::meet_steps, py::arg("origin"), py::arg("step"), py::arg("ends"),
           "Of steps [s] that are counted from `origin` in a run that begins and ends at `ends`: where one ends at a "
           "break up to roundoff, the break is there, too.")
      .def_property_readonly("times", &BreakPoints::times, "Ascending [s].")
      .def(
          "before", [](const BreakPoints& breaks, double t) { return breaks.before(t); }, py::arg("t"),
          "Where functions are evaluated for what ends at t [s].")
      .def(
          "after", [](const BreakPoints& breaks, double t) { return breaks.after(t); }, py::arg("t"),
          "Where functions are evaluated for what begins at t [s].")
      .def(
          "clock",
          [](const BreakPoints& breaks, const VectorXd& t, double t_end) {
            return VectorXd(t.unaryExpr([&](double it) { return breaks.clock(it, t_end); }));
          },
          py::arg("t"), py::arg("t_end"),
          "Where functions are evaluated (k,) [s] for frames at t (k,): after a break, but before it where the run "
          "ends at it.");
}

}  // namespace

void bind_integration(py::module_& module) {
  bind_break_points(module);
  bind_methods(module);
  bind_events(module);
  bind_runs(module);
  bind_fixed_steps(module);
  bind_lane_runs(module);
  bind_adaptive_steps(module);
}

}  // namespace linkwork::python
