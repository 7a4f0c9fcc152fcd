#pragma once

#include "linkwork/model/element_loads.hpp"
#include "linkwork/model/joint_kind.hpp"

/// The loop over the joints of one kind, `width` at a time. Compiled once per instruction set; without contraction to
/// fused operations, so that all of them give the same numbers to the last bit.
namespace linkwork::simd::LINKWORK_ISA {

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

/// Phi_dot = D v + Phi_t.
template <class Joint, bool i_moves = true, bool j_moves = true>
LINKWORK_INLINE void multiply(const Pack* D_i, const Pack* D_j, const Pack* v_i, const Pack* v_j, const Pack* Phi_t,
                              Pack* Phi_dot) {
  constexpr int first = holds_point<Joint> || turns<Joint> ? 3 : 0;
  LINKWORK_UNROLL for (int r = 0; r < Joint::rows; ++r) {
    const bool along_axis = holds_point<Joint> && r < 3;
    Pack sum = Phi_t[r];
    if (i_moves && along_axis) sum += v_i[r];
    LINKWORK_UNROLL for (int c = first; i_moves && c < 6; ++c)
      sum += D_i[6 * r + c] * v_i[c];
    if (j_moves && along_axis) sum -= v_j[r];
    LINKWORK_UNROLL for (int c = first; j_moves && c < 6; ++c)
      sum += D_j[6 * r + c] * v_j[c];
    Phi_dot[r] = sum;
  }
}

template <class Joint>
LINKWORK_INLINE BodyState<Pack> gather_states(const int* body, const double* q, const double* v, Pack* velocity) {
  if constexpr (turns<Joint>) return gather_turn(body, q, v, velocity);
  else return gather_state(body, q, v, velocity);
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
    load_parameters_of(joints, first, signals, parameters);
    Pack v_i[6], v_j[6], Phi[rows], Phi_t[rows], Phi_dot[rows], gamma[rows], D[12 * rows];
    const BodyState<Pack> i = gather_states<Joint>(joints.body_i + first, q, v, v_i);
    const BodyState<Pack> j = gather_states<Joint>(joints.body_j + first, q, v, v_j);
    Joint::template evaluate<Pack>(attachment_of(joints, first), parameters, i, j,
                                   Rows<Pack, rows>{Phi, Phi_t, gamma, D, D + 6 * rows});
    multiply<Joint>(D, D + 6 * rows, v_i, v_j, Phi_t, Phi_dot);

    const int used = joints.count - first < width ? joints.count - first : width;
    double nowhere[12 * rows];  // for the lanes that are not used
    double* place[width];
    for (int l = 0; l < width; ++l) place[l] = l < used ? out.D + joints.D[first + l] : nowhere;
    scatter_D<12 * rows>(D, joints.streamed && used == width, place);
    const auto scatter_rows = [&](const Pack* in, double* to) {
      if (rows == 1 && joints.row[first + used - 1] - joints.row[first] == used - 1)
        return store_leading(to + joints.row[first], in[0].v, used);
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

LINKWORK_INLINE const BodyState<Pack>& state_of_joint(const JointLanes& joints, int body) {
  return state_of(joints.states, body < 0 ? ~body : body);
}

/// What varies of the rows of a body of joints that hold a point and of rotations: all but the columns of translation.
template <class Joint>
LINKWORK_INLINE void put_varying_D(const Pack* D, Pack* to) {
  LINKWORK_UNROLL for (int r = 0; r < Joint::rows; ++r) LINKWORK_UNROLL
    for (int c = 3; c < 6; ++c) to[6 * r + c] = D[6 * r + c];
}

/// Without D of a body that does not move, which nobody reads, and without what is constant in D and Phi_t.
template <class Joint, bool i_moves, bool j_moves>
LINKWORK_INLINE void evaluate_joint_of_lanes(const JointLanes& joints, int joint, const Signal<Pack>* parameters,
                                             const ConstraintArrays& out) {
  constexpr int rows = Joint::rows;
  const BodyState<Pack>& i = state_of_joint(joints, joints.body_i[joint]);
  const BodyState<Pack>& j = state_of_joint(joints, joints.body_j[joint]);
  const long row = static_cast<long>(joints.row[joint]) * width;
  constexpr bool in_place = !holds_point<Joint> && !turns<Joint>;
  Pack beside[12 * rows], zeros[rows];
  Pack* const D = packs(out.D + joints.D[joint] * width);
  Pack* const D_i = in_place ? D : beside;
  Pack* const D_j = D_i + 6 * rows;
  Pack* const Phi_t = holds_point<Joint> ? zeros : packs(out.Phi_t + row);
  Joint::template evaluate<Pack>(attachment_in(joints.attachment, joint), parameters, i, j,
                                 Rows<Pack, rows>{packs(out.Phi + row), Phi_t, packs(out.gamma + row), D_i, D_j});
  multiply<Joint, i_moves, j_moves>(D_i, D_j, i.r_dot.data(), j.r_dot.data(), Phi_t, packs(out.Phi_dot + row));
  if constexpr (in_place) return;
  if constexpr (i_moves) put_varying_D<Joint>(D_i, D);
  if constexpr (j_moves) put_varying_D<Joint>(D_j, D + 6 * rows);
}

/// One joint of all lanes after the other. Those that hold a point have no Phi_t: the sum that is Phi_dot begins at
/// zero, and has the same bits where zeros are left out.
template <class Joint>
LINKWORK_INLINE void evaluate_joint_lanes(const JointLanes& joints, const ConstraintArrays& out) {
  constexpr bool all = !holds_point<Joint>;
  Signal<Pack> parameters[max_joint_parameters];
  for (int joint = 0; joint < joints.count; ++joint) {
    load_parameters(joints.parameters, joints.parameter_count, joint, parameters);
    if (!all && joints.body_i[joint] < 0) evaluate_joint_of_lanes<Joint, all, true>(joints, joint, parameters, out);
    else if (!all && joints.body_j[joint] < 0)
      evaluate_joint_of_lanes<Joint, true, all>(joints, joint, parameters, out);
    else evaluate_joint_of_lanes<Joint, true, true>(joints, joint, parameters, out);
  }
}

}  // namespace linkwork::simd::LINKWORK_ISA
