#pragma once

#include <string>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Gains of the term -2 alpha Phi_dot - beta^2 Phi [1/s].
struct Gains {
  double alpha, beta;
};

/// How drift off the constraints is held.
enum class StabilizationKind {
  none,
  /// D v_dot = gamma - 2 alpha Phi_dot - beta^2 Phi in every evaluation, Flores (2015) eq. (12.8).
  baumgarte,
  /// u = -2 alpha Phi_dot - beta^2 Phi computed at the start of a step and held: with gains proportional to 1/h the
  /// violation vanishes in two steps, and the order of the integrator is kept because u does not vary inside a step.
  sampled_baumgarte,
  /// After each step the state goes back to the constraints with the least change, see Projection.
  projection,
  position_projection,
  velocity_projection,
};

struct StabilizationInfo {
  const char* name;
  StabilizationKind kind;
  const char* documentation;
  std::vector<std::string> options = {};  ///< of some methods only that it has, see options.def
};

const std::vector<StabilizationInfo>& stabilizations();
/// OptionError: there is none with this name.
const StabilizationInfo& stabilization_info(const std::string& name);

constexpr bool projects_positions(StabilizationKind kind) {
  return kind == StabilizationKind::projection || kind == StabilizationKind::position_projection;
}
constexpr bool projects_velocities(StabilizationKind kind) {
  return kind == StabilizationKind::projection || kind == StabilizationKind::velocity_projection;
}

/// Of continuous Baumgarte stabilization where none are given.
constexpr Gains textbook_gains{5.0, 5.0};

/// Gains that make sampled stabilization dead-beat for a one-step method. Under a held u the violation obeys, with
/// w = h^2 u and s = sum b_i c_i (1/2 from order two on, 0 for explicit Euler, 1 for semi-implicit Euler),
///   Phi' = Phi + h Phi_dot + s w,   h Phi_dot' = h Phi_dot + w,   w = -2 alpha h (h Phi_dot) - (beta h)^2 Phi,
/// and this map is nilpotent exactly for beta h = 1, alpha h = 1 - s/2.
inline Gains deadbeat_gains(double s, double h) { return {(1.0 - 0.5 * s) / h, 1.0 / h}; }
/// Of the gains of a step h, where violations are corrected over at least `length`.
inline double share_of_correction(double h, double length) { return h < length ? h / length : 1.0; }

}  // namespace linkwork
