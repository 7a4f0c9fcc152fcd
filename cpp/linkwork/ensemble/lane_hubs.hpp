#pragma once

#include "linkwork/ensemble/lane_fronts.hpp"

/// Hubs of all lanes: the equations of block/hub_kernels.hpp, and their order of operations.
namespace linkwork {
namespace {

/// Adds x to the number at a position.
LINKWORK_INLINE void add_to(double* list, std::ptrdiff_t position, Native x) {
  put(list, position, get(list, position) + x);
}

/// -M of a hub, the lower triangle.
void add_hub(const block::Hub& hub, const FrontPlace& at, const LaneData& data) {
  const double* articulated_inertia = data.articulated_inertias + hub.slot * articulated * std::ptrdiff_t{width};
  const double* mass = data.mass + 10l * width * hub.body;
  for (int c = 0; c < 6; ++c) {
    double* column = at.column(hub.position + c);
    for (int r = c; r < 6; ++r) {
      if (hub.slot >= 0) add_to(column, hub.position + r, -get(articulated_inertia, 8 * c + r));
      else if (c >= 3) add_to(column, hub.position + r, -get(mass, 1 + 3 * (c - 3) + r - 3));
      else if (r == c) add_to(column, hub.position + r, -get(mass, 0));
    }
  }
}

/// -M of hubs and their D, into the lower triangle.
void add_hubs(const block::MixedFront& mixed, const FrontPlace& at, const LaneData& data) {
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) add_hub(data.hubs[h], at, data);
  for (int k = mixed.first_coupling; k < mixed.first_coupling + mixed.couplings; ++k) {
    const block::Coupling& it = data.couplings[k];
    for (int r = 0; r < it.rows; ++r)
      for (int c = 0; c < 6; ++c) {
        const int joint = it.joint + r, hub = it.hub + c;
        add_to(at.column(hub < joint ? hub : joint), hub < joint ? joint : hub, get(data.D, it.D + 6 * r + c));
      }
  }
}

/// -a of hubs.
void add_hub_right_hand_sides(const block::MixedFront& mixed, const FrontPlace& at, const LaneData& data,
                              const double* a) {
  for (int h = mixed.first_hub; h < mixed.first_hub + mixed.hubs; ++h) {
    const block::Hub& hub = data.hubs[h];
    const double* articulated_inertia = data.articulated_inertias + hub.slot * articulated * std::ptrdiff_t{width};
    for (int k = 0; k < 6; ++k)
      add_to(at.right(), hub.position + k,
             -(hub.slot < 0 ? get(a, 6l * hub.body + k) : get(articulated_inertia, 8 * k + right_hand_side)));
  }
}

}  // namespace
}  // namespace linkwork
