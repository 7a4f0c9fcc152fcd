#pragma once

#include <cmath>

#include "linkwork/math/elementary.hpp"
#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/primitives.hpp"

/// Coordinates between two bodies along which force elements act, with the equation whose row of D is their direction:
/// a force f along one of them has the generalized force f D^T, and the power f x_dot, in every pose. Where the row is
/// not `valued`, Phi of an angle means nothing.
namespace linkwork {

/// The distance of two points [m].
struct Length {
  static constexpr CoordinateKind kind = CoordinateKind::length;
  static constexpr const char* placement = "two_points";
  static constexpr HistoryKind history = HistoryKind::none;

  template <bool valued, class Real>
  LINKWORK_PRIMITIVE static void row(const Attachment<Real>& at, const BodyState<Real>& i, const BodyState<Real>& j,
                                     Rows<Real, 1> out) {
    separation<Real>(i, j, at.s_i, at.s_j, {Real(0), Real(0), Real(0)}, out);
  }
};

/// The angle of x_j against x_i about z_i [rad], in (-pi, pi], continued over full turns by its history.
struct Angle {
  static constexpr CoordinateKind kind = CoordinateKind::angle;
  static constexpr const char* placement = "axis";
  static constexpr HistoryKind history = HistoryKind::angle;

  template <bool valued, class Real>
  LINKWORK_PRIMITIVE static void row(const Attachment<Real>& at, const BodyState<Real>& i, const BodyState<Real>& j,
                                     Rows<Real, 1> out) {
    if constexpr (valued) angle<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), out);
    else turning<Real>(i, j, at.x_i(), at.y_i(), at.x_j(), out);
  }
};

/// The shift of the point of j along z_i [m].
struct Displacement {
  static constexpr CoordinateKind kind = CoordinateKind::displacement;
  static constexpr const char* placement = "axis";
  static constexpr HistoryKind history = HistoryKind::none;

  template <bool valued, class Real>
  LINKWORK_PRIMITIVE static void row(const Attachment<Real>& at, const BodyState<Real>& i, const BodyState<Real>& j,
                                     Rows<Real, 1> out) {
    in_plane<Real>(i, j, at.z_i(), at.s_i, at.s_j, out);
  }
};

/// A force along the coordinate of `row`.
template <class Real>
LINKWORK_PRIMITIVE void act(const Equation<Real>& row, Real force, Wrenches<Real>& out) {
  using Row = Eigen::Map<const Vec3<Real>>;
  out.force_i += force * Row(row.D_i);
  out.torque_i += force * Row(row.D_i + 3);
  out.force_j += force * Row(row.D_j);
  out.torque_j += force * Row(row.D_j + 3);
}

/// A force element whose law depends on a coordinate, with its rate, alone: a struct with, beside `history`,
///   static constexpr bool valued;  whether it asks for the coordinate itself
///   template <class Real>
///   static Along<Real> law(const ForceParameters<Real>&, const Real& x, const Real& rate, HistoryVariable<Real>&);
/// Elements of several such kinds along one coordinate share its row where they are evaluated many at a time, see
/// ElementCoordinates: the same bits. A law that takes functions of the state is one of doubles, not a template.
template <class Law, class Coordinate_>
struct LawAlong {
  using Coordinate = Coordinate_;

  template <class Real>
  LINKWORK_PRIMITIVE static void evaluate(const Attachment<Real>& at, const ForceParameters<Real>& parameters,
                                          const BodyState<Real>& i, const BodyState<Real>& j,
                                          HistoryVariable<Real>& history, Wrenches<Real>& out) {
    Equation<Real> row;
    Coordinate::template row<Law::valued>(at, i, j, row.rows());
    const Along<Real> said = said_by<Law>(parameters, row.Phi, row.rate(i, j), history);
    act(row, said.force, out);
    out.potential = said.potential;
    out.power = said.power;
    for (int s = 0; s < switches_of<Law>(); ++s) out.switches[s] = said.switches[s];
  }
};

/// Coulomb friction, regularized below a speed, and viscous friction: parameters coulomb, viscous, transition.
template <class Coordinate>
struct Friction : LawAlong<Friction<Coordinate>, Coordinate> {
  static constexpr HistoryKind history = HistoryKind::none;
  static constexpr bool valued = false;

  template <class Real>
  LINKWORK_PRIMITIVE static Along<Real> law(const ForceParameters<Real>& parameters, const Real&, const Real& rate,
                                            HistoryVariable<Real>&) {
    using elementary::hyperbolic_tangent;
    using std::abs;
    const Real coulomb = parameters[0].value;
    const auto grips = abs(coulomb) > Real(0);
    Real grip(0);  // of an element without, whatever those beside it have
    if (any(grips)) grip = select(grips, hyperbolic_tangent(rate / parameters[2].value), grip);
    const Real force = -coulomb * grip - parameters[1].value * rate;
    return {.force = force, .power = force * rate};
  }
};

/// End stops: parameters lower, upper, stiffness, damping. They never pull back.
template <class Coordinate>
struct Stop : LawAlong<Stop<Coordinate>, Coordinate> {
  static constexpr HistoryKind history = Coordinate::history;
  static constexpr bool valued = true;
  static constexpr int switches = 2;
  static constexpr SwitchLimit limits[switches] = {{1, -1.0}, {0, 1.0}};

  template <class Real>
  LINKWORK_PRIMITIVE static Along<Real> law(const ForceParameters<Real>& parameters, const Real& x, const Real& rate,
                                            HistoryVariable<Real>&) {
    using std::abs;
    Along<Real> out;
    out.switches[0] = x - parameters[1].value;
    out.switches[1] = parameters[0].value - x;
    const auto above = out.switches[0] > Real(0);
    const decltype(above) beyond = above | (out.switches[1] > Real(0));
    const Signal<Real> lower = parameters[0], upper = parameters[1];
    const Real depth = x - select(above, upper.value, lower.value);  // negative below
    const Real spring = parameters[2].value * depth, damper = parameters[3].value * abs(depth) * rate;
    const decltype(above) pushes = beyond & ((spring + damper) * depth > Real(0));
    out.force = select(pushes, -(spring + damper), Real(0));
    out.potential = select(beyond, Real(0.5) * spring * depth, Real(0));
    out.power = select(beyond,
                       (out.force + spring) * rate - spring * select(above, upper.rate, lower.rate) +
                           Real(0.5) * parameters[2].rate * depth * depth,
                       Real(0));
    return out;
  }
};

/// Spring, damper and actuator: parameters stiffness, damping, where the spring is free, force of the actuator.
template <class Coordinate>
struct LinearSpring : LawAlong<LinearSpring<Coordinate>, Coordinate> {
  static constexpr HistoryKind history = Coordinate::history;
  static constexpr bool valued = true;

  template <class Real>
  LINKWORK_PRIMITIVE static Along<Real> law(const ForceParameters<Real>& parameters, const Real& x, const Real& rate,
                                            HistoryVariable<Real>& of_angle) {
    const Real stiffness = parameters[0].value, damping = parameters[1].value;
    of_angle.rate = select(stiffness == Real(0), Real(0), of_angle.rate);
    const Real deflection = x - parameters[2].value;
    const Real dissipative = parameters[3].value - damping * rate;
    return {.force = dissipative - stiffness * deflection,
            .potential = Real(0.5) * stiffness * deflection * deflection,
            .power = dissipative * rate + Real(0.5) * parameters[0].rate * deflection * deflection -
                     stiffness * deflection * parameters[2].rate};
  }
};

/// Spring and damper by their characteristics: parameters 0 and 1, functions of extension and rate; 2 is where the
/// spring is free. A spring whose characteristic has no known integral, or that is free where it has no known rate,
/// does work with all of its power. Evaluated one by one, as all that takes functions of the state.
template <class Coordinate>
struct CharacteristicSpring : LawAlong<CharacteristicSpring<Coordinate>, Coordinate> {
  static constexpr HistoryKind history = Coordinate::history;
  static constexpr bool valued = true;

  static Along<double> law(const ForceParameters<double>& parameters, double x, double rate,
                           HistoryVariable<double>& of_angle) {
    if (parameters.is_zero(0)) of_angle.rate = 0.0;
    const Signal<double> free = parameters[2];
    const double spring = parameters.at(0, x - free.value), damper = parameters.at(1, rate);
    const std::optional<double> stored = parameters.integral(0, x - free.value);
    if (!stored || std::isnan(free.rate)) return {.force = -(spring + damper), .power = -(spring + damper) * rate};
    return {.force = -(spring + damper), .potential = *stored, .power = -damper * rate - spring * free.rate};
  }
};

/// Inertia of a coordinate: see Inerters, which have all of it. As a force it is nothing.
template <class Coordinate_>
struct InertiaOf {
  using Coordinate = Coordinate_;
  static constexpr HistoryKind history = HistoryKind::none;

  static void row(const Attachment<double>& at, const BodyState<double>& i, const BodyState<double>& j,
                  Equation<double>& out) {
    Coordinate::template row<false>(at, i, j, out.rows());
  }
  template <class Real>
  static void evaluate(const Attachment<Real>&, const ForceParameters<Real>&, const BodyState<Real>&,
                       const BodyState<Real>&, HistoryVariable<Real>&, Wrenches<Real>&) {}
};

}  // namespace linkwork
