#include "bindings.hpp"
#include "linkwork/integration/driven_motion.hpp"
#include "turns.hpp"

namespace linkwork::python {
namespace {

py::tuple follow(DrivenMotion& motion, const std::vector<double>& times, double seconds) {
  DrivenFrames found;
  {
    const py::gil_scoped_release release;
    found = motion.follow(times, seconds);
  }
  const py::ssize_t count = found.count;
  py::dict out;
  const auto add = [&](const char* name, std::vector<double>& values, bool rows) {
    std::vector<py::ssize_t> shape = {count};
    if (rows) shape.push_back(count ? static_cast<py::ssize_t>(values.size()) / count : 0);
    out[name] = to_numpy(std::move(values), std::move(shape));
  };
  add("t", found.t, false);
  add("q", found.q, true);
  add("v", found.v, true);
  add("vdot", found.v_dot, true);
  add("lambda", found.lambda, true);
  add("potential", found.potential, false);
  add("power", found.power, false);
  add("violation", found.violation, true);
  add("history", found.history, true);
  return py::make_tuple(count, out, found.paused,
                        py::dict(py::arg("steps") = found.steps, py::arg("evaluations") = found.evaluations,
                                 py::arg("factorizations") = found.factorizations));
}

py::tuple state(const DrivenMotion& motion) {
  const DrivenState& it = motion.state();
  return py::make_tuple(it.t, it.q, it.v, it.v_dot, it.history);
}

}  // namespace

void bind_driven_motion(py::module_& module) {
  py::class_<DrivenLimits>(module, "DrivenLimits", "When a step of a driven motion is trusted; parts of the mechanism.")
      .def(py::init<>())
      .def_readonly("longest_step", &DrivenLimits::longest_step)
      .def_readonly("largest_correction", &DrivenLimits::largest_correction)
      .def_readonly("converged", &DrivenLimits::converged)
      .def_readonly("rounding", &DrivenLimits::rounding)
      .def_readonly("iterations", &DrivenLimits::iterations)
      .def_readonly("closed", &DrivenLimits::closed)
      .def_readonly("touch_part", &DrivenLimits::touch_part);
  py::class_<DrivenMotion>(module, "DrivenMotion", "The motion that drivers prescribe, away from singular poses.")
      .def(py::init<Dynamics&, double, VectorXd, double, double, std::vector<double>>(), py::arg("dynamics"),
           py::arg("length"), py::arg("row_lengths"), py::arg("rounding"), py::arg("unit"), py::arg("recorded"),
           py::keep_alive<1, 2>())
      .def("start", &DrivenMotion::start, py::arg("q"), py::arg("history"),
           "From the pose at t = 0 to which q leads; False: none is found, or it is singular, or nearly so.")
      .def_property_readonly("state", &state, "(t, q, v, v_dot, history) where it has come.")
      .def("pass_by", &DrivenMotion::pass, py::arg("t"), py::arg("q"), py::arg("v"),
           "Somebody else has taken a step to this state.")
      .def("record", &DrivenMotion::record_turns, py::arg("t"), py::arg("q"), py::arg("v"),
           "And has made a frame of it.")
      .def_property_readonly(
          "turned", [](const DrivenMotion& it) { return to_python(it.turns().found()); },
          "[joint, coordinate, before, t, angle] of how far joints turned from one of the times `recorded` to another "
          "[s], where frames there do not tell it; None: steps were too long to tell.")
      .def("begin", &DrivenMotion::begin, py::arg("t"), py::arg("q"), py::arg("v"), py::arg("v_dot"),
           py::arg("history"), "From a state on the constraints; False: it is singular, or nearly so.")
      .def("follow", &follow, py::arg("times"), py::arg("seconds"),
           "(count, frames, paused, costs): as many frames as there are before something unusual, and until `seconds` "
           "are over; `paused` if they were on the way to the next one.");
}

}  // namespace linkwork::python
