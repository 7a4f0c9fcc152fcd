#pragma once

#include "linkwork/linear/block/front_kernels.hpp"

/// A hub, a body with many joints, is eliminated among the joints, for it would couple all of them: then the matrix is
/// [S D; D^T -M] with S of the other bodies, quasi-definite, and pivots of hubs are negative.
namespace linkwork::block {
namespace {

LINKWORK_INLINE Vector column_of_mass(int body, int slot, int c, const Data& data) {
  if (slot >= 0) return load(data.articulated_inertias + slot * articulated_inertia_size + c * lanes);
  return mass_column(data.mass[body], c, 0.0);
}

/// -M of hubs and their D, into the lower triangle.
void add_hubs(const Front& front, const MixedFront& mixed, const Data& data) {
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const Hub& hub = data.hubs[h];
    for (int c = 0; c < 6; ++c) {
      const Vector column = column_of_mass(hub.body, hub.slot, c, data);
      double* to = column_of(front, data, hub.position + c) + hub.position;
      for (int r = c; r < 6; ++r) to[r] -= column[r];
    }
  }
  for (int k = mixed.first_coupling; k < mixed.first_coupling + mixed.couplings; ++k) {
    const Coupling& coupling = data.couplings[k];
    const double* D = data.D + coupling.D;
    const bool hub_first = coupling.hub < coupling.joint;
    for (int r = 0; r < coupling.rows; ++r)
      for (int c = 0; c < 6; ++c) {
        const int joint = coupling.joint + r, hub = coupling.hub + c;
        column_of(front, data, hub_first ? hub : joint)[hub_first ? joint : hub] += D[6 * r + c];
      }
  }
}

/// -a of hubs.
void add_hub_right_hand_sides(const Front& front, const MixedFront& mixed, const Data& data, const double* a) {
  double* right = right_hand_side_of(front, data);
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const Hub& hub = data.hubs[h];
    for (int k = 0; k < 6; ++k)
      right[hub.position + k] -=
          hub.slot < 0 ? a[6 * hub.body + k]
                       : data.articulated_inertias[hub.slot * articulated_inertia_size + k * lanes + right_hand_side];
  }
}

}  // namespace
}  // namespace linkwork::block
