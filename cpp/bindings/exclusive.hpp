#pragma once

#include <utility>

#include "bindings.hpp"
#include "linkwork/ensemble/lane.hpp"
#include "linkwork/integration/run.hpp"

namespace linkwork::python {

// A System works for one caller at a time; see Busy.
inline const Dynamics& dynamics_of(const Dynamics& dynamics) { return dynamics; }
inline const Dynamics& dynamics_of(const Run& run) { return run.dynamics(); }
inline const Dynamics& dynamics_of(const LaneRun& run) { return run.dynamics; }

/// The function, in which the dynamics of its first argument are busy.
template <class Result, class Self, class... Arguments>
auto exclusive(Result (*function)(Self&, Arguments...)) {
  return [function](Self& self, Arguments... arguments) -> Result {
    const Busy busy(dynamics_of(self));
    return function(self, std::forward<Arguments>(arguments)...);
  };
}

}  // namespace linkwork::python
