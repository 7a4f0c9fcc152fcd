#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace linkwork {

constexpr double no_default = std::numeric_limits<double>::quiet_NaN();

/// What a parameter may be: numbers from `least` on, or, with `above`, only those beyond it. A function of time may
/// touch that, but not pass it.
struct Bound {
  std::string parameter;
  double least = 0.0;
  bool above = false;
};

inline Bound positive(std::string parameter) { return {std::move(parameter), 0.0, true}; }
inline Bound not_negative(std::string parameter) { return {std::move(parameter), 0.0, false}; }
inline Bound at_least(double least, std::string parameter) { return {std::move(parameter), least, false}; }

/// Of two parameters the first is not larger than the second.
struct Ordered {
  std::string smaller, larger;
};

/// What a user says about where a joint or force element sits.
///   point       one point                       axis        a point and an axis
///   two_axes    a point and one axis per body   two_points  one point per body
///   frame       a point and full axes on both bodies
///   direction, two_directions, orientation   the same without a point
///   shafts      a point and an axis per body at any angle
///   centers     an axis, and a point per body, joined by a line perpendicular to it
///   disc        a point and an axis per body
///   plane       a point and a normal of a, a point of b
///   coordinates, curve   of special joints: free coordinates of other joints; points of a, a point of b
struct KindInfo {
  std::string name = "";
  int rows = 0;  ///< constraint equations (0 for forces)
  std::string placement = "";
  std::vector<std::string> parameters = {};      ///< numbers or functions of time
  std::vector<std::string> differentiated = {};  ///< those of the parameters whose time derivatives enter
  std::vector<std::string> constants = {};       ///< those of the parameters that cannot vary in time, nor be zero
  std::vector<std::string> whole_numbers = {};   ///< those of the constants that must be whole
  std::vector<Bound> bounds = {};                ///< of the parameters, where not every number makes sense
  std::vector<Ordered> ordered = {};             ///< pairs of parameters
  std::vector<std::string> functions = {};  ///< those of the parameters that are functions of a coordinate, not of time
  std::vector<double> defaults = {};        ///< of the parameters, where there are any: NaN: none
  std::vector<std::string> equations = {};  ///< one name per row
  int velocity_rows = 0;  ///< of the equations, the last so many are of velocities only (non-holonomic): Phi = 0
  std::vector<std::string> coordinates = {};  ///< relative positions that are free: see Coupler
  std::string documentation = "";
};

}  // namespace linkwork
