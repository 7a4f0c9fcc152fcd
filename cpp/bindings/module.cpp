#include "bindings.hpp"
#include "linkwork/math/interruption.hpp"

namespace {

/// Signals (Ctrl-C), whose handlers Python calls between two lines of its own only.
void look_for_signals() {
  const pybind11::gil_scoped_acquire acquire;
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

/// KeyboardInterrupt and the like, which are no Exception.
bool is_signal(const std::exception& thrown) {
  const auto* error = dynamic_cast<const pybind11::error_already_set*>(&thrown);
  if (error == nullptr) return false;
  const pybind11::gil_scoped_acquire acquire;
  return !error->matches(PyExc_Exception);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled core of linkwork: models, evaluation, formulations and the drivers of the integrators.";
  linkwork::set_interruption(&look_for_signals, &is_signal);
  linkwork::python::bind_errors(module);
  linkwork::python::bind_time_functions(module);
  linkwork::python::bind_kinds(module);
  linkwork::python::bind_model(module);
  linkwork::python::bind_assembler(module);
  linkwork::python::bind_options(module);
  linkwork::python::bind_formulation(module);
  linkwork::python::bind_integration(module);
  linkwork::python::bind_driven_motion(module);
  linkwork::python::bind_ensemble(module);
}
