#pragma once

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/lane_loads.hpp"

/// The loop over the joints of one kind, `width` at a time. Compiled once per instruction set; without contraction to
/// fused operations, so that all of them give the same numbers to the last bit.
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

LINKWORK_INLINE const double* place_of(const AttachmentPart& part, long joint) { return part.from + part.step * joint; }

/// To the start of a line of memory, past the caches.
LINKWORK_INLINE void stream_native(double* to, Native v) {
#if defined(__AVX512F__)
  _mm512_stream_pd(to, (__m512d)v);
#elif defined(__AVX__)
  _mm256_stream_pd(to, (__m256d)v);
#else
  store_native(to, v);
#endif
}

/// Before others read what was streamed.
LINKWORK_INLINE void end_stream() {
#if defined(__AVX__)
  _mm_sfence();
#endif
}

/// Numbers of which most are whole lines, which need not be read before they are written.
inline void stream_lines(double* to, const double* from, int count) {
  constexpr int line = 8;
  int k = static_cast<int>(-(reinterpret_cast<unsigned long>(to) / sizeof(double)) % line);  // to the first line
  copy(to, from, k);
  for (; k + width <= count; k += width) stream_native(to + k, load_native(from + k));
  copy(to + k, from + k, count - k);
}

/// Whether the places of `width` joints, of `count` numbers each, follow each other.
LINKWORK_INLINE bool consecutive(const double* const* place, int count) {
  return place[width - 1] - place[0] == static_cast<long>(count) * (width - 1);
}

/// D of `width` joints to their places, `streamed` past the caches where these follow each other.
template <int count>
LINKWORK_INLINE void scatter_D(const Pack* D, bool streamed, double** place) {
  double* const lines = streamed && consecutive(place, count) ? place[0] : nullptr;
  double together[count * width];
  if (lines)
    for (int l = 0; l < width; ++l) place[l] = together + count * l;
  scatter<count>(D, place);
  if (lines) stream_lines(lines, together, count * width);
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

/// Phi_dot = D v + Phi_t.
template <class Joint>
LINKWORK_INLINE void multiply(const Pack* D_i, const Pack* D_j, const Pack* v_i, const Pack* v_j, const Pack* Phi_t,
                              Pack* Phi_dot) {
  constexpr int first = holds_point<Joint> ? 3 : 0;
  LINKWORK_UNROLL for (int r = 0; r < Joint::rows; ++r) {
    Pack sum = Phi_t[r];
    if (r < first) sum += v_i[r];
    LINKWORK_UNROLL for (int c = first; c < 6; ++c)
      sum += D_i[6 * r + c] * v_i[c];
    if (r < first) sum -= v_j[r];
    LINKWORK_UNROLL for (int c = first; c < 6; ++c)
      sum += D_j[6 * r + c] * v_j[c];
    Phi_dot[r] = sum;
  }
}

/// Asks for what a large model has in memory only: constants to be read, bodies, and the place of D.
template <int rows>
LINKWORK_INLINE void prefetch_joints(const JointArrays& joints, int first, const double* q, const double* v,
                                     const ConstraintArrays& out) {
  constexpr int line = 8;
  for (int part = 0; part < 4; ++part)
    for (int k = 0; k < attachment_parts[part] * width; k += line)
      __builtin_prefetch(place_of(joints.attachment[part], joints.first + first) + k);
  for (int l = 0; l < width && first + l < joints.count; ++l) {
    __builtin_prefetch(q + 7l * joints.body_j[first + l]);
    __builtin_prefetch(v + 6l * joints.body_j[first + l]);
    if (joints.streamed) continue;
    const double* D = out.D + joints.D[first + l];
    for (int k = 0; k < 12 * rows; k += line) __builtin_prefetch(D + k, 1);
  }
}

template <class Joint>
LINKWORK_INLINE void evaluate_joints(const JointArrays& joints, const double* q, const double* v,
                                     const Signal<double>* signals, const ConstraintArrays& out) {
  constexpr int rows = Joint::rows;
  constexpr int ahead = 16, many = 2000;
  Signal<Pack> parameters[max_joint_parameters];
  for (int first = 0; first < joints.count; first += width) {
    if (joints.count > many && first + ahead + width <= joints.count)
      prefetch_joints<rows>(joints, first + ahead, q, v, out);
    for (int p = 0; p < joints.parameter_count; ++p)
      parameters[p] =
          load_parameter(joints.parameters + first * joints.parameter_count + p, joints.parameter_count, signals);
    Pack v_i[6], v_j[6], Phi[rows], Phi_t[rows], Phi_dot[rows], gamma[rows], D[12 * rows];
    const BodyState<Pack> i = gather_state(joints.body_i + first, q, v, v_i);
    const BodyState<Pack> j = gather_state(joints.body_j + first, q, v, v_j);
    const double* attachment[4];
    for (int part = 0; part < 4; ++part) attachment[part] = place_of(joints.attachment[part], joints.first + first);
    Joint::template evaluate<Pack>(load_attachment(attachment), parameters, i, j,
                                   Rows<Pack, rows>{Phi, Phi_t, gamma, D, D + 6 * rows});
    multiply<Joint>(D, D + 6 * rows, v_i, v_j, Phi_t, Phi_dot);

    const int used = joints.count - first < width ? joints.count - first : width;
    double nowhere[12 * rows];  // for the lanes that are not used
    double* place[width];
    for (int l = 0; l < width; ++l) place[l] = l < used ? out.D + joints.D[first + l] : nowhere;
    scatter_D<12 * rows>(D, joints.streamed && used == width, place);
    const auto scatter_rows = [&](const Pack* in, double* to) {
      for (int l = 0; l < width; ++l) place[l] = l < used ? to + joints.row[first + l] : nowhere;
      scatter<rows>(in, place);
    };
    scatter_rows(Phi, out.Phi);
    scatter_rows(Phi_dot, out.Phi_dot);
    scatter_rows(gamma, out.gamma);
    if (joints.time_dependent) scatter_rows(Phi_t, out.Phi_t);
  }
  if (joints.streamed) end_stream();
}

/// One joint of all lanes after the other.
template <class Joint>
LINKWORK_INLINE void evaluate_joint_lanes(const JointLanes& joints, const ConstraintArrays& out) {
  constexpr int rows = Joint::rows;
  Signal<Pack> parameters[max_joint_parameters];
  for (int joint = 0; joint < joints.count; ++joint) {
    load_parameters(joints.parameters, joints.parameter_count, joint, parameters);
    Pack v_i[6], v_j[6];
    const BodyState<Pack> i = load_state(joints.states, joints.body_i[joint], v_i);
    const BodyState<Pack> j = load_state(joints.states, joints.body_j[joint], v_j);
    const long row = static_cast<long>(joints.row[joint]) * width;
    Pack *D = packs(out.D + joints.D[joint] * width), *Phi_t = packs(out.Phi_t + row);
    Joint::template evaluate<Pack>(
        load_attachment_of(joints.attachment, joint), parameters, i, j,
        Rows<Pack, rows>{packs(out.Phi + row), Phi_t, packs(out.gamma + row), D, D + 6 * rows});
    multiply<Joint>(D, D + 6 * rows, v_i, v_j, Phi_t, packs(out.Phi_dot + row));
  }
}

}  // namespace linkwork::simd::LINKWORK_ISA
