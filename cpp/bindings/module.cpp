#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled core of linkwork: models, evaluation, formulations and the drivers of the integrators.";
  linkwork::python::bind_errors(module);
  linkwork::python::bind_time_functions(module);
  linkwork::python::bind_kinds(module);
  linkwork::python::bind_model(module);
  linkwork::python::bind_assembler(module);
  linkwork::python::bind_formulation(module);
  linkwork::python::bind_integration(module);
  linkwork::python::bind_driven_motion(module);
}
