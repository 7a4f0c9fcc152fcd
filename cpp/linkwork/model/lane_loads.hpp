#pragma once

#include "linkwork/math/pack.hpp"
#include "linkwork/model/batch.hpp"

/// What stands in memory `width` numbers side by side, one of each mechanism in a lane. Compiled once per instruction set.
namespace linkwork::simd::LINKWORK_ISA {

template <int count>
LINKWORK_INLINE void load_lanes_of(const double* from, Pack* out) {
  LINKWORK_UNROLL for (int k = 0; k < count; ++k)
    out[k].v = load_native(from + k * width);
}
/// In place, of memory that is aligned to lines.
LINKWORK_INLINE Pack* packs(double* from) { return reinterpret_cast<Pack*>(from); }

LINKWORK_INLINE BodyState<Pack> load_state(const double* states, int body, Pack* velocity) {
  const double* from = states + 18l * width * body;
  BodyState<Pack> state;
  load_lanes_of<3>(from, state.r.data());
  load_lanes_of<9>(from + 3 * width, state.A.data());
  load_lanes_of<6>(from + 12 * width, velocity);
  state.r_dot = Vec3<Pack>(velocity[0], velocity[1], velocity[2]);
  state.omega = Vec3<Pack>(velocity[3], velocity[4], velocity[5]);
  return state;
}

/// From the places of its parts.
LINKWORK_INLINE Attachment<Pack> load_attachment(const double* const* parts) {
  Attachment<Pack> at;
  Pack* to[] = {at.s_i.data(), at.s_j.data(), at.C_i.data(), at.C_j.data()};
  LINKWORK_UNROLL for (int part = 0; part < 4; ++part)
    for (int k = 0; k < attachment_parts[part]; ++k) to[part][k].v = load_native(parts[part] + k * width);
  return at;
}

LINKWORK_INLINE Attachment<Pack> load_attachment_of(const double* attachments, int element) {
  const double* s_i = attachments + static_cast<long>(attachment_size) * width * element;
  const double* parts[4] = {s_i, s_i + 3 * width, s_i + 6 * width, s_i + 15 * width};
  return load_attachment(parts);
}

/// Of one element, of which each has `count`.
LINKWORK_INLINE void load_parameters(const double* parameters, int count, int element, Signal<Pack>* out) {
  const double* given = parameters + 3l * width * count * element;
  for (int p = 0; p < count; ++p, given += 3 * width)
    out[p] = {Pack(load_native(given)), Pack(load_native(given + width)), Pack(load_native(given + 2 * width))};
}

}  // namespace linkwork::simd::LINKWORK_ISA
