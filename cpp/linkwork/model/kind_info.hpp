#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace linkwork {

/// Which numbers a parameter may be: from `least` on, or, with `above`, only those beyond it. A function of time may
/// touch that, but not pass it.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity();
  bool above = false;

  bool any() const { return least > -std::numeric_limits<double>::infinity(); }
  bool hold(double value) const { return value >= least && !(above && value == least); }
};
constexpr Bounds positive{0.0, true}, not_negative{0.0, false};
constexpr Bounds at_least(double least) { return {least, false}; }

/// What a parameter of a kind takes.
enum class Takes {
  function,        ///< a number or a function of time
  differentiable,  ///< the same; the time derivatives of the function enter
  number,          ///< a number; without bounds any but zero
  whole_number,    ///< without bounds any but zero
  characteristic,  ///< a function of a coordinate or velocity, or a number for a linear one
};

/// A parameter of a kind of joint or force.
struct ParameterInfo {
  struct Values {
    std::optional<double> usual = {};  ///< where it is not given; none: it must be
    bool initial_distance = false;     ///< where it is not given: that of the two points at the initial pose
    double example = 0.0;              ///< of the usual size
    Bounds bounds = {};                ///< of numbers
    std::string not_above = "";        ///< a parameter that this one is not above
  };

  std::string name;
  std::string unit;     ///< such as "N s/m"; a power may be another parameter, "N/m^exponent"; "" for a mere number
  std::string meaning;  ///< a few words
  Takes takes = Takes::function;
  Values value = {};

  bool constant() const { return takes == Takes::number || takes == Takes::whole_number; }
};

/// Axes of a joint's frames.
enum class Axis { x, y, z };

/// One constraint equation of a kind of joint.
struct EquationInfo {
  enum class Quantity {
    translation,
    rotation,
    distance,  ///< of the two points
    velocity,  ///< non-holonomic: Phi = 0
    relation,  ///< between translations, rotations, coordinates
  };
  struct Pair {
    Axis of_a, of_b;
  };

  std::string name;
  Quantity quantity = Quantity::relation;
  /// Of a translation or rotation that is held at zero: the axis along or about which.
  std::vector<Axis> axis = {};
  /// Of such a rotation: axes of a and b that are perpendicular; of two pairs the products are equal.
  std::vector<Pair> perpendicular = {};

  bool rotates() const { return quantity == Quantity::rotation; }
};

inline std::string letter(Axis axis) { return std::string(1, "xyz"[static_cast<int>(axis)]); }

/// A component of the distance between the points, in inertial axes or along an axis of the joint.
inline EquationInfo translation(Axis axis) {
  return {"translation " + letter(axis), EquationInfo::Quantity::translation, {axis}};
}
inline EquationInfo translation_along(Axis axis) {
  return {"translation along joint " + letter(axis), EquationInfo::Quantity::translation, {axis}};
}
inline EquationInfo translation_named(std::string name) {
  return {std::move(name), EquationInfo::Quantity::translation};
}
/// The axis `of_a` of a stays perpendicular to the axis `of_b` of b.
inline EquationInfo rotation_about(Axis axis, Axis of_a, Axis of_b) {
  return {"rotation about joint " + letter(axis), EquationInfo::Quantity::rotation, {axis}, {{of_a, of_b}}};
}
inline EquationInfo rotation_named(std::string name, std::vector<EquationInfo::Pair> perpendicular = {}) {
  return {std::move(name), EquationInfo::Quantity::rotation, {}, std::move(perpendicular)};
}
inline EquationInfo distance_of_points() { return {"distance", EquationInfo::Quantity::distance}; }
inline EquationInfo velocity_along(Axis axis) {
  return {"velocity along joint " + letter(axis), EquationInfo::Quantity::velocity};
}

struct FreeCoordinate;  // joint_coordinates.hpp
struct Parameter;       // batch.hpp

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
  std::vector<ParameterInfo> parameters = {};
  std::vector<EquationInfo> equations = {};             ///< one a row; those of velocities are the last
  std::vector<const FreeCoordinate*> coordinates = {};  ///< relative positions that are free: see Coupler
  bool symmetric = true;                                ///< the same joint where a and b change places
  bool driver = false;  ///< it prescribes a motion, its parameter; the multiplier is the force or torque for that
  std::string documentation = "";
  /// Why these parameters, each as it may be, do not go together; "" where they do.
  std::string (*contradiction)(const Parameter*) = nullptr;

  int velocity_rows() const {
    return static_cast<int>(std::count_if(equations.begin(), equations.end(), [](const EquationInfo& it) {
      return it.quantity == EquationInfo::Quantity::velocity;
    }));
  }
};

}  // namespace linkwork
