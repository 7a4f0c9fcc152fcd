#include <optional>

#include "bindings.hpp"
#include "linkwork/formulation/formulation.hpp"
#include "linkwork/formulation/options.hpp"
#include "linkwork/math/instruction_set.hpp"

namespace linkwork::python {
namespace {

struct PathScope {
  explicit PathScope(bool one) : wanted(one) {}
  bool wanted;
  std::optional<OnePath> path;
};

void bind_information(py::module_& module) {
  py::class_<LinearSolverInfo>(module, "SolverInfo", "A registered linear solver.")
      .def_readonly("name", &LinearSolverInfo::name)
      .def_readonly("documentation", &LinearSolverInfo::documentation)
      .def_property_readonly("available", [](const LinearSolverInfo& info) { return info.available(); })
      .def_property_readonly("matrix_forms", [](const LinearSolverInfo& info) {
        std::vector<std::string> out;
        for (const MatrixForm& form : matrix_forms())
          if (can_solve(form.name, info)) out.emplace_back(form.name);
        return out;
      });
  module.def("linear_solvers", [] { return linear_solvers(); });
  py::class_<PathScope>(module, "OnePath",
                        "While it is entered, this thread computes by the instructions that every processor has.")
      .def(py::init<bool>(), py::arg("wanted"))
      .def("__enter__", [](PathScope& scope) { scope.path.emplace(scope.wanted); })
      .def("__exit__", [](PathScope& scope, const py::args&) { scope.path.reset(); });
  module.def(
      "instruction_set", [] { return best_instruction_set().name; },
      "The instruction set that the hot loops use on this processor, such as x86-64-v3.");
  py::class_<FormulationInfo>(module, "FormulationInfo", "A registered formulation.")
      .def_readonly("name", &FormulationInfo::name)
      .def_readonly("documentation", &FormulationInfo::documentation)
      .def_readonly("matrix_forms", &FormulationInfo::forms)
      .def_readonly("options", &FormulationInfo::options)
      .def_readonly("needs_full_rank", &FormulationInfo::needs_full_rank)
      .def_readonly("compliant", &FormulationInfo::compliant);
  module.def("formulations", [] { return formulations(); });
  py::class_<StabilizationInfo>(module, "StabilizationInfo", "A registered stabilization.")
      .def_property_readonly("name", [](const StabilizationInfo& info) { return info.name; })
      .def_property_readonly("documentation", [](const StabilizationInfo& info) { return info.documentation; });
  module.def("stabilizations", [] { return stabilizations(); });
}

}  // namespace

void bind_options(py::module_& module) {
  bind_information(module);
  py::class_<OptionInfo>(module, "OptionInfo", "What an option of a run can be.")
      .def_readonly("name", &OptionInfo::name)
      .def_readonly("type", &OptionInfo::type, "\"name\", \"number\", \"whole\" or \"limits\".")
      .def_readonly("choices", &OptionInfo::choices, "Of a name.")
      .def_readonly("positive", &OptionInfo::positive, "A number: not zero.")
      .def_readonly("usual", &OptionInfo::usual, "A number of some methods only: where it is not given, or None.")
      .def_readonly("unit", &OptionInfo::unit)
      .def_readonly("documentation", &OptionInfo::documentation)
      .def_readonly("methods", &OptionInfo::methods,
                    "Formulations or stabilizations that have it; empty: it is of all.");
  module.def("options", &option_infos, "The table of options, formulation/options.def.");
  py::class_<Options>(module, "Options", "The choices of a run.")
      .def(py::init<>())
      .def("resolved", &resolve, "As a run has them; OptionError: what cannot be honored.")
#define LINKWORK_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) .def_readwrite(#NAME, &Options::NAME)
#define LINKWORK_METHOD_OPTION(TYPE, NAME, DEFAULT, VALUES, UNIT, HELP) .def_readwrite(#NAME, &Options::NAME)
#include "linkwork/formulation/options.def"
#undef LINKWORK_OPTION
#undef LINKWORK_METHOD_OPTION
      ;
}

}  // namespace linkwork::python
