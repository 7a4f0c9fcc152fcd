#include "linkwork/formulation/stabilization.hpp"

#include "linkwork/math/names.hpp"

namespace linkwork {

const std::vector<StabilizationInfo>& stabilizations() {
  static const std::vector<StabilizationInfo> all = {
      {"none", StabilizationKind::none, "D v_dot = gamma as it stands, (12.2)"},
      {"baumgarte",
       StabilizationKind::baumgarte,
       "gamma - 2 alpha Phi_dot - beta^2 Phi in every evaluation, (12.8)",
       {"baumgarte_alpha", "baumgarte_beta"}},
      {"sampled_baumgarte",
       StabilizationKind::sampled_baumgarte,
       "the same term computed once a step and held: keeps the order of the integrator",
       {"baumgarte_alpha", "baumgarte_beta"}},
      {"projection", StabilizationKind::projection,
       "positions and velocities go back to the constraints after each step"},
      {"position_projection", StabilizationKind::position_projection, "projection of positions alone"},
      {"velocity_projection", StabilizationKind::velocity_projection, "projection of velocities alone"},
  };
  return all;
}

const StabilizationInfo& stabilization_info(const std::string& name) {
  return find_named(stabilizations(), name, "stabilization", "unknown_stabilization");
}

}  // namespace linkwork
