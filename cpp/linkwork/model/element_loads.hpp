#pragma once

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/lane_loads.hpp"

/// What `width` joints or force elements of one kind are evaluated from. Compiled once per instruction set.
namespace linkwork::simd::LINKWORK_ISA {

constexpr double ground_q[7] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
constexpr double ground_v[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

LINKWORK_INLINE BodyState<Pack> gather_state(const int* body, const double* q, const double* v, Pack* velocity) {
  const double *positions[width], *velocities[width];
  for (int l = 0; l < width; ++l) {
    positions[l] = body[l] < 0 ? ground_q : q + 7 * static_cast<long>(body[l]);
    velocities[l] = body[l] < 0 ? ground_v : v + 6 * static_cast<long>(body[l]);
  }
  Pack position[7];
  gather<7>(positions, position);
  gather<6>(velocities, velocity);
  return {Vec3<Pack>(position[0], position[1], position[2]),
          rotation_matrix<Pack>(Vec4<Pack>(position[3], position[4], position[5], position[6])),
          Vec3<Pack>(velocity[0], velocity[1], velocity[2]), Vec3<Pack>(velocity[3], velocity[4], velocity[5])};
}

/// The orientation and the angular velocity alone.
LINKWORK_INLINE BodyState<Pack> gather_turn(const int* body, const double* q, const double* v, Pack* velocity) {
  const double *orientations[width], *velocities[width];
  for (int l = 0; l < width; ++l) {
    orientations[l] = (body[l] < 0 ? ground_q : q + 7 * static_cast<long>(body[l])) + 3;
    velocities[l] = (body[l] < 0 ? ground_v : v + 6 * static_cast<long>(body[l])) + 2;
  }
  Pack orientation[4], last[4];  // of the velocity, as many as a register takes at once
#if LINKWORK_WIDTH == 8
  Native square[width];
  for (int l = 0; l < width; ++l) square[l] = with_lanes<4, 4>(load_some<4>(orientations[l]), velocities[l]);
  transpose(square);
  for (int k = 0; k < 4; ++k) {
    orientation[k].v = square[k];
    last[k].v = square[4 + k];
  }
#else
  gather<4>(orientations, orientation);
  gather<4>(velocities, last);
#endif
  for (int k = 0; k < 3; ++k) velocity[3 + k] = last[1 + k];
  return {Vec3<Pack>::Zero(),
          rotation_matrix<Pack>(Vec4<Pack>(orientation[0], orientation[1], orientation[2], orientation[3])),
          Vec3<Pack>::Zero(), Vec3<Pack>(last[1], last[2], last[3])};
}

LINKWORK_INLINE const double* place_of(const AttachmentPart& part, long joint) { return part.from + part.step * joint; }

/// Of the elements from `first` of these on.
LINKWORK_INLINE Attachment<Pack> attachment_of(const ElementArrays& elements, int first) {
  const double* parts[4];
  for (int part = 0; part < 4; ++part) parts[part] = place_of(elements.attachment[part], elements.first + first);
  return load_attachment(parts);
}

LINKWORK_INLINE Signal<Pack> load_parameter(const Parameter* parameters, int stride, const Signal<double>* signals) {
  Signal<Pack> out;
  for (int l = 0; l < width; ++l) {
    const Parameter& parameter = parameters[l * stride];
    const bool constant = parameter.signal < 0;
    out.value.v[l] = constant ? parameter.constant : signals[parameter.signal].value;
    out.rate.v[l] = constant ? 0.0 : signals[parameter.signal].rate;
    out.acceleration.v[l] = constant ? 0.0 : signals[parameter.signal].acceleration;
  }
  return out;
}

LINKWORK_INLINE Signal<Pack> load_constant(const Parameter* parameters, int stride) {
  Signal<Pack> out{Pack(0.0), Pack(0.0), Pack(0.0)};
  for (int l = 0; l < width; ++l) out.value.v[l] = parameters[l * stride].constant;
  return out;
}

/// All parameters of the elements from `first` on.
LINKWORK_INLINE void load_parameters_of(const ElementArrays& elements, int first, const Signal<double>* signals,
                                        Signal<Pack>* out) {
  const int count = elements.parameter_count;
  const Parameter* given = elements.parameters + static_cast<long>(first) * count;
  if (elements.time_dependent)
    for (int p = 0; p < count; ++p) out[p] = load_parameter(given + p, count, signals);
  else
    for (int p = 0; p < count; ++p) out[p] = load_constant(given + p, count);
}

}  // namespace linkwork::simd::LINKWORK_ISA
