#pragma once

#include "bindings.hpp"
#include "linkwork/integration/turn_counter.hpp"

namespace linkwork::python {

/// [joint, coordinate, before [s], t [s], angle [rad]] of each, as JSON gives it back.
inline py::list to_python(const std::vector<TurnCounter::Turned>& turned) {
  py::list out;
  for (const TurnCounter::Turned& it : turned)
    out.append(py::list(py::make_tuple(it.joint, it.coordinate, it.before, it.t, it.angle)));
  return out;
}

}  // namespace linkwork::python
