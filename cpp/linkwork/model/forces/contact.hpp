#pragma once

#include <algorithm>
#include <cmath>

#include "linkwork/math/elementary.hpp"
#include "linkwork/model/force_kind.hpp"

/// Continuous contact: F = K d^n (1 + c d_dot / d_dot_0) at the depth d, d_dot_0 the speed at which contact began. With
/// the coefficient of restitution e, c is 3 (1 - e) / 2 of Hunt and Crossley (1975), 3 (1 - e^2) / 4 of Lankarani and
/// Nikravesh (1990), 8 (1 - e) / (5 e) of Flores et al. (2011). Coulomb friction, regularized below a speed.
namespace linkwork {

/// Those that a contact has in common with others, behind its own. Below an exponent of 1 the stiffness K n d^(n-1) is
/// infinite where contact begins: no step is small enough there, and there is no material that does so.
inline std::vector<ParameterInfo> contact_parameters(std::vector<ParameterInfo> own) {
  const std::vector<ParameterInfo> common = {
      {"stiffness", "N/m^exponent", "K", Takes::number, {.example = 100.0, .bounds = positive}},
      {"exponent", "", "n", Takes::number, {.usual = 1.5, .example = 2.0, .bounds = at_least(1.0)}},
      {"hysteresis",
       "",
       "factor c of the rate",
       Takes::function,
       {.usual = 0.0, .example = 0.5, .bounds = not_negative}},
      {"friction",
       "",
       "coefficient of friction",
       Takes::function,
       {.usual = 0.0, .example = 0.3, .bounds = not_negative}},
      {"transition",
       "m/s",
       "speed of regularization, and the least by which hysteresis damps: at rest by F c / transition",
       Takes::number,
       {.usual = 1e-3, .example = 0.1, .bounds = positive}}};
  own.insert(own.end(), common.begin(), common.end());
  return own;
}

/// A body in contact: the way from its center of mass to a point of the line of the normal, such as the center of a
/// sphere, and how far from there along the normal the place of contact is [m]. No force along the normal acts by the
/// latter.
template <class Real>
struct Touching {
  const BodyState<Real>& body;
  Vec3<Real> to_line;
  Real along;
};

/// With the unit normal n from i to j and the depth d; `history` is the speed at which contact began, which counts as
/// `transition` where it was smaller; where the last accepted state was not in contact it is the speed now.
template <class Real>
void contact(const ForceParameters<Real>& parameters, int first, const Touching<Real>& on_i, const Touching<Real>& on_j,
             const Vec3<Real>& n, Real depth, HistoryVariable<Real>& history, Wrenches<Real>& out) {
  const bool begins = std::isnan(history.last);
  out.switches[0] = depth;
  if (!(depth > Real(0)) && !begins) return;
  const Real stiffness = parameters[first].value, exponent = parameters[first + 1].value;
  const Real hysteresis = parameters[first + 2].value, friction = parameters[first + 3].value;
  const Real transition = parameters[first + 4].value;
  const auto velocity = [&](const Touching<Real>& on) {
    const BodyState<Real>& body = on.body;
    return Vec3<Real>(body.r_dot + (body.A * body.omega).cross(on.to_line + on.along * n));
  };
  const Vec3<Real> u = velocity(on_j) - velocity(on_i);
  const Real rate = -n.dot(u);
  history.next = begins || history.last == Real(0) ? std::max(rate, transition) : history.last;
  if (!(depth > Real(0))) return;
  const Real elastic = stiffness * elementary::power(depth, exponent);
  const Real normal = elastic * std::max(Real(0), Real(1) + hysteresis * rate / history.next);
  const Vec3<Real> slip = u + rate * n;
  const Vec3<Real> tangential = -friction * normal / std::sqrt(slip.squaredNorm() + transition * transition) * slip;
  const Vec3<Real> F = normal * n + tangential;
  const auto torque = [&](const Touching<Real>& on) {
    return Vec3<Real>(on.body.A.transpose() * (on.to_line.cross(F) + on.along * n.cross(tangential)));
  };
  out.force_j = F;
  out.torque_j = torque(on_j);
  out.force_i = -F;
  out.torque_i = -torque(on_i);
  out.potential = elastic * depth / (exponent + Real(1));
  out.power = (elastic - normal) * rate + tangential.dot(slip);
}

}  // namespace linkwork
