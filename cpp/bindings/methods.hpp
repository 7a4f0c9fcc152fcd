#pragma once

#include <memory>

#include "bindings.hpp"
#include "linkwork/integration/step_judge.hpp"

namespace linkwork::python {

/// The integrators as data.
void bind_methods(py::module_& module);

/// None: an integrator of the user's own, which steps by itself. OptionError: it is none of these.
std::unique_ptr<Integrator> make_integrator(const py::object& method);

/// `other`: it is not the method of the run, but one without an error beside it.
SecondTake second_take(const py::object& method, bool other, bool inside);

}  // namespace linkwork::python
