#pragma once

#include <cmath>
#include <numbers>

/// Some laws depend on more than the present state: a torsion spring on full turns, a contact on the speed at which it
/// began, a belt on the turns of its pulleys. What they need of the past are history variables: numbers beside q and v
/// that belong to the integrated state. An evaluation reads their values at the last accepted state and writes what
/// they become if its own state is accepted; nothing else survives it, so it is a function of (t, q, v, history).
///
/// An angle is continued from the last accepted one: of all angle + 2 pi n it is the nearest to that, so a step may
/// turn it by less than half a turn.
namespace linkwork {

enum class HistoryKind {
  none,
  angle,  ///< over full turns [rad]
  onset,  ///< speed at which a contact began [m/s], 0 where there is none; NaN: it begins in this very state
  place,  ///< on a curve [m]
};

/// A history variable of one element in one evaluation.
template <class Real>
struct HistoryVariable {
  Real last = Real(0);  ///< at the last accepted state
  Real next = Real(0);  ///< what it becomes where this state is accepted
  Real rate = Real(0);  ///< of an angle [rad/s]; 0 where full turns do not matter
};

/// An angle in (-pi, pi], continued from the last. Of two that are as near, as half a turn either way at the start, the
/// larger one, to rounding.
template <class Real>
Real continued(Real angle, Real last) {
  using std::rint;
  constexpr double ahead = 1e-9;
  const Real turn(2.0 * std::numbers::pi);
  return angle + turn * rint((last - angle) / turn + Real(ahead));
}

}  // namespace linkwork
