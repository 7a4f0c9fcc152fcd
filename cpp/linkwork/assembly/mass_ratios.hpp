#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// How far apart inertias are, massless bodies left out; 1 where there are none.
struct MassRatios {
  double mass = 1.0, moment = 1.0;  ///< the largest over the least of bodies that joints or inerters connect
  double inertance = 1.0;           ///< the largest of an inerter over what a body at its ends has

  explicit MassRatios(const System& system);
};

}  // namespace linkwork
