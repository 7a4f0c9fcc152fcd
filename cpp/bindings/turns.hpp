#pragma once

#include <cmath>

#include "bindings.hpp"
#include "linkwork/integration/turn_counter.hpp"

namespace linkwork::python {

/// [joint, coordinate, before [s], t [s], angle [rad] or None] of each, as JSON gives it back.
inline py::list to_python(const std::vector<TurnCounter::Turned>& turned) {
  py::list out;
  for (const TurnCounter::Turned& it : turned) {
    const py::object angle = std::isnan(it.angle) ? py::object(py::none()) : py::float_(it.angle);
    out.append(py::list(py::make_tuple(it.joint, it.coordinate, it.before, it.t, angle)));
  }
  return out;
}

}  // namespace linkwork::python
