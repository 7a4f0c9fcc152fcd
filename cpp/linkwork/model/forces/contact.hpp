#pragma once

#include <algorithm>
#include <cmath>

#include "linkwork/model/force_kind.hpp"

/// Continuous contact: F = K d^n (1 + c d_dot / d_dot_0) at the depth d, d_dot_0 the speed at which contact began. With
/// the coefficient of restitution e, c is 3 (1 - e) / 2 of Hunt and Crossley (1975), 3 (1 - e^2) / 4 of Lankarani and
/// Nikravesh (1990), 8 (1 - e) / (5 e) of Flores et al. (2011). Coulomb friction, regularized below a speed.
namespace linkwork {

/// Numbers that a contact has in common with others, from the `first` parameter on.
inline std::vector<std::string> contact_parameters(std::vector<std::string> own) {
  for (const char* name : {"stiffness", "exponent", "hysteresis", "friction", "transition"}) own.push_back(name);
  return own;
}

/// What they may be. Below an exponent of 1 the stiffness K n d^(n-1) is infinite where contact begins: no step is
/// small enough there, and there is no material that does so.
inline std::vector<Bound> contact_bounds(std::vector<Bound> own) {
  for (Bound bound : {positive("stiffness"), at_least(1.0, "exponent"), not_negative("hysteresis"),
                      not_negative("friction"), positive("transition")})
    own.push_back(std::move(bound));
  return own;
}

/// At the point C in space, with the unit normal n from i to j and the depth d; `memory` is the speed at which contact
/// began, 0 while there is none. The speed counts as `transition` where it was smaller.
template <class Real>
void contact(const ForceParameters<Real>& parameters, int first, const BodyState<Real>& i, const BodyState<Real>& j,
             const Vec3<Real>& C, const Vec3<Real>& n, Real depth, Real* memory, Wrenches<Real>& out) {
  if (!(depth > Real(0))) {
    memory[0] = Real(0);
    return;
  }
  const Real stiffness = parameters[first].value, exponent = parameters[first + 1].value;
  const Real hysteresis = parameters[first + 2].value, friction = parameters[first + 3].value;
  const Real transition = parameters[first + 4].value;
  const Vec3<Real> arm_i = C - i.r, arm_j = C - j.r, omega_i = i.A * i.omega, omega_j = j.A * j.omega;
  const Vec3<Real> u = j.r_dot + omega_j.cross(arm_j) - i.r_dot - omega_i.cross(arm_i);
  const Real rate = -n.dot(u);
  if (memory[0] == Real(0)) memory[0] = std::max(rate, transition);
  const Real elastic = stiffness * std::pow(depth, exponent);
  const Real normal = elastic * std::max(Real(0), Real(1) + hysteresis * rate / memory[0]);
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
