#pragma once

#include <string_view>

#include "linkwork/model/kind_info.hpp"
#include "linkwork/model/primitives.hpp"

/// Relative positions that joints leave free, by the names that their kinds give them.
namespace linkwork {

struct FreeCoordinate {
  std::string_view name;
  std::string_view unit;  ///< "rad", in (-pi, pi], or "m"
  /// Phi is the coordinate, D its direction: a force Q along it has the generalized force Q D^T.
  void (*evaluate)(const Attachment<double>&, const BodyState<double>& i, const BodyState<double>& j,
                   Equation<double>&);

  bool angle() const { return unit == "rad"; }
};

/// Of b against a about the common axis z; along it; of a Cardan joint about the axes of a and of b.
extern const FreeCoordinate turn_about_axis, shift_along_axis, turn_about_axis_a, turn_about_axis_b;

/// Of joints of a kind; nothing where they have none of this name.
const FreeCoordinate* find_coordinate(const KindInfo& kind, const std::string& name);

}  // namespace linkwork
