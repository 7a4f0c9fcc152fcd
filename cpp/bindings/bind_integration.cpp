#include "bindings.hpp"
#include "linkwork/integration/simulation.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork::python {

py::array_t<double> to_numpy(std::vector<double>&& values, std::vector<py::ssize_t> shape) {
  auto* owner = new std::vector<double>(std::move(values));
  const py::capsule release(owner, [](void* pointer) { delete static_cast<std::vector<double>*>(pointer); });
  return py::array_t<double>(std::move(shape), owner->data(), release);
}

namespace {

/// Data that a driver runs, without a Python call in its loop.
struct SemiImplicitEulerTag {};

std::unique_ptr<Integrator> make_integrator(const py::object& method) {
  if (method.is_none()) return nullptr;
  if (py::isinstance<ButcherTableau>(method)) return make_runge_kutta(method.cast<ButcherTableau>());
  if (py::isinstance<MultistepCoefficients>(method)) return make_multistep(method.cast<MultistepCoefficients>());
  if (py::isinstance<SemiImplicitEulerTag>(method)) return make_semi_implicit_euler();
  throw OptionError("integrator", "integrator must be a Tableau, a Multistep, a SemiImplicitEuler or None");
}

py::dict to_dict(Frames&& frames, const System& system) {
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
  return out;
}

/// Looks for a signal (Ctrl-C) from inside a long evaluation.
void look_for_signals() {
  const py::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
}

py::dict advance(Simulation& simulation, std::int64_t max_frames, double max_seconds) {
  Frames frames;
  {
    const py::gil_scoped_release release;
    frames = simulation.advance(max_frames, max_seconds);
  }
  return to_dict(std::move(frames), simulation.dynamics().system());
}

}  // namespace

void bind_integration(py::module_& module) {
  py::class_<ButcherTableau>(module, "Tableau", "An explicit Runge-Kutta method.")
      .def(py::init([](std::string name, int order, const MatrixXd& A, const VectorXd& b, const VectorXd& c) {
             return ButcherTableau{std::move(name), order, A, b, c};
           }),
           py::arg("name"), py::arg("order"), py::arg("A"), py::arg("b"), py::arg("c"));
  py::class_<MultistepCoefficients>(module, "Multistep", "An Adams method; coefficients of the newest value first.")
      .def(py::init([](std::string name, int order, const VectorXd& predictor, const VectorXd& corrector,
                       const ButcherTableau& starter) {
             return MultistepCoefficients{std::move(name), order, predictor, corrector, starter};
           }),
           py::arg("name"), py::arg("order"), py::arg("predictor"), py::arg("corrector"), py::arg("starter"));
  py::class_<SemiImplicitEulerTag>(module, "SemiImplicitEuler", "v' = v + h v_dot, q' = q + h N(q) v'.")
      .def(py::init<>());

  py::class_<Simulation>(module, "Simulation", "A run with a fixed step, advanced in pieces.")
      .def(py::init([](Dynamics& dynamics, const py::object& integrator, double t_end, double step,
                       std::int64_t record_every) {
             dynamics.set_interrupt(&look_for_signals);
             return std::make_unique<Simulation>(dynamics, make_integrator(integrator),
                                                 Schedule{t_end, step, record_every});
           }),
           py::arg("dynamics"), py::arg("integrator"), py::arg("t_end"), py::arg("step"), py::arg("record_every") = 1,
           py::keep_alive<1, 2>())
      .def("advance", &advance, py::arg("max_frames"), py::arg("max_seconds"),
           "Runs on and returns the frames recorded: t, q, v, vdot, lambda, kinetic, potential, work, violation.")
      .def(
          "begin_step",
          [](Simulation& simulation) {
            const double h = simulation.begin_step();
            return py::make_tuple(simulation.t(), VectorXd(simulation.y().head(simulation.y().size() - 1)), h);
          },
          "(t, y, h) of the step that begins; h = 0 at the end.")
      .def("accept", &Simulation::accept, py::arg("y"))
      .def("take_frames",
           [](Simulation& simulation) { return to_dict(simulation.take_frames(), simulation.dynamics().system()); })
      .def_property_readonly("finished", &Simulation::finished)
      .def_property_readonly("t", &Simulation::t)
      .def_property_readonly("steps_done", &Simulation::steps_done)
      .def_property_readonly("steps_total", &Simulation::steps_total)
      .def("statistics", [](const Simulation& simulation) {
        py::dict out = py::cast(&simulation.dynamics(), py::return_value_policy::reference).attr("statistics")();
        out["steps"] = simulation.steps_done();
        return out;
      });
}

}  // namespace linkwork::python
