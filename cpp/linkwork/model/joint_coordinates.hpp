#pragma once

#include "linkwork/model/kind_info.hpp"
#include "linkwork/model/primitives.hpp"

/// Relative positions that joints leave free, by the names that their kinds give them.
namespace linkwork {

struct FreeCoordinate {
  const char* name;
  bool angle;  ///< [rad], in (-pi, pi]; else a shift [m]
  /// Phi is the coordinate, D its direction: a force Q along it has the generalized force Q D^T.
  void (*evaluate)(const Attachment<double>&, const BodyState<double>& i, const BodyState<double>& j,
                   Equation<double>&);
};

/// Of joints of a kind; nothing where they have none of this name.
const FreeCoordinate* find_coordinate(const KindInfo& kind, const std::string& name);

/// The angle that differs from this one by full turns and is nearest to the last.
double continued(double angle, double last);

}  // namespace linkwork
