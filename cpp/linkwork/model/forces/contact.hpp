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

/// At the point C in space, with the unit normal n from i to j and the depth d; `history` is the speed at which
/// contact began, which counts as `transition` where it was smaller; where the last accepted state was not in contact
/// it is the speed now.
template <class Real>
void contact(const ForceParameters<Real>& parameters, int first, const BodyState<Real>& i, const BodyState<Real>& j,
             const Vec3<Real>& C, const Vec3<Real>& n, Real depth, HistoryVariable<Real>& history,
             Wrenches<Real>& out) {
  const bool begins = std::isnan(history.last);
  out.switches[0] = depth;
  if (!(depth > Real(0)) && !begins) return;
  const Real stiffness = parameters[first].value, exponent = parameters[first + 1].value;
  const Real hysteresis = parameters[first + 2].value, friction = parameters[first + 3].value;
  const Real transition = parameters[first + 4].value;
  const Vec3<Real> arm_i = C - i.r, arm_j = C - j.r, omega_i = i.A * i.omega, omega_j = j.A * j.omega;
  const Vec3<Real> u = j.r_dot + omega_j.cross(arm_j) - i.r_dot - omega_i.cross(arm_i);
  const Real rate = -n.dot(u);
  history.next = begins || history.last == Real(0) ? std::max(rate, transition) : history.last;
  if (!(depth > Real(0))) return;
  const Real elastic = stiffness * elementary::power(depth, exponent);
  const Real normal = elastic * std::max(Real(0), Real(1) + hysteresis * rate / history.next);
  const Vec3<Real> slip = u + rate * n;
  const Vec3<Real> tangential = -friction * normal / std::sqrt(slip.squaredNorm() + transition * transition) * slip;
  const Vec3<Real> F = normal * n + tangential;
  out.force_j = F;
  out.torque_j = j.A.transpose() * arm_j.cross(F);
  out.force_i = -F;
  out.torque_i = -(i.A.transpose() * arm_i.cross(F));
  out.potential = elastic * depth / (exponent + Real(1));
  out.power = (elastic - normal) * rate + tangential.dot(slip);
}

}  // namespace linkwork
