#pragma once

#include "linkwork/math/pack.hpp"
#include "linkwork/model/batch.hpp"

/// What stands in memory `width` numbers side by side, one of each mechanism in a lane. Compiled once per instruction set.
namespace linkwork::simd::LINKWORK_ISA {

/// In place, of memory that is aligned to lines.
LINKWORK_INLINE Pack* packs(double* from) { return reinterpret_cast<Pack*>(from); }

// In place: copies, for which there are not registers enough, would be stored once more.
static_assert(sizeof(BodyState<Pack>) == 18 * sizeof(Pack));
static_assert(sizeof(Attachment<Pack>) == attachment_size * sizeof(Pack));
LINKWORK_INLINE const BodyState<Pack>& state_of(const double* states, int body) {
  return *reinterpret_cast<const BodyState<Pack>*>(states + 18l * width * body);
}
LINKWORK_INLINE const Attachment<Pack>& attachment_in(const double* attachments, int element) {
  return *reinterpret_cast<const Attachment<Pack>*>(attachments + static_cast<long>(attachment_size) * width * element);
}

/// From the places of its parts.
LINKWORK_INLINE Attachment<Pack> load_attachment(const double* const* parts) {
  Attachment<Pack> at;
  Pack* to[] = {at.s_i.data(), at.s_j.data(), at.C_i.data(), at.C_j.data()};
  LINKWORK_UNROLL for (int part = 0; part < 4; ++part)
    for (int k = 0; k < attachment_parts[part]; ++k) to[part][k].v = load_native(parts[part] + k * width);
  return at;
}

/// Of one element, of which each has `count`.
LINKWORK_INLINE void load_parameters(const double* parameters, int count, int element, Signal<Pack>* out) {
  const double* given = parameters + 3l * width * count * element;
  for (int p = 0; p < count; ++p, given += 3 * width)
    out[p] = {Pack(load_native(given)), Pack(load_native(given + width)), Pack(load_native(given + 2 * width))};
}

}  // namespace linkwork::simd::LINKWORK_ISA
