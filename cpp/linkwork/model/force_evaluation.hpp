#pragma once

#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/lane_loads.hpp"

/// The loop over the force elements of one kind, `width` at a time. Compiled once per instruction set, without
/// contraction: all of them give the same numbers to the last bit, whatever is beside an element.
namespace linkwork::simd::LINKWORK_ISA {

static_assert(sizeof(BodyState<double>) == 18 * sizeof(double) && sizeof(Attachment<double>) == 24 * sizeof(double));

LINKWORK_INLINE BodyState<Pack> gather_body(const int* body, const BodyState<double>* bodies, const long* element) {
  const double* from[width];
  for (int l = 0; l < width; ++l) from[l] = reinterpret_cast<const double*>(bodies + body[element[l]]);
  Pack numbers[18];
  gather<18>(from, numbers);
  BodyState<Pack> out;
  for (int k = 0; k < 3; ++k) {
    out.r[k] = numbers[k];
    out.r_dot[k] = numbers[12 + k];
    out.omega[k] = numbers[15 + k];
  }
  for (int k = 0; k < 9; ++k) out.A.data()[k] = numbers[3 + k];
  return out;
}

LINKWORK_INLINE Attachment<Pack> gather_attachment(const double* attachments, const long* element) {
  const double* from[width];
  for (int l = 0; l < width; ++l) from[l] = attachments + attachment_size * element[l];
  Pack numbers[attachment_size];
  gather<attachment_size>(from, numbers);
  Attachment<Pack> out;
  for (int k = 0; k < 3; ++k) {
    out.s_i[k] = numbers[k];
    out.s_j[k] = numbers[3 + k];
  }
  for (int k = 0; k < 9; ++k) {
    out.C_i.data()[k] = numbers[6 + k];
    out.C_j.data()[k] = numbers[15 + k];
  }
  return out;
}

LINKWORK_INLINE Signal<Pack> gather_parameter(const ForceElements& elements, int p, const Signal<double>* signals,
                                              const long* element) {
  Signal<Pack> out;
  for (int l = 0; l < width; ++l) {
    const Parameter& parameter = elements.parameters[element[l] * elements.parameter_count + p];
    const bool constant = parameter.signal < 0;
    out.value.v[l] = constant ? parameter.constant : signals[parameter.signal].value;
    out.rate.v[l] = constant ? 0.0 : signals[parameter.signal].rate;
    out.acceleration.v[l] = constant ? 0.0 : signals[parameter.signal].acceleration;
  }
  return out;
}

/// In the order of Wrenches, potential and power behind.
LINKWORK_INLINE void scatter_wrenches(const Wrenches<Pack>& wrenches, double (*to)[wrench_size]) {
  Pack numbers[wrench_size];
  for (int k = 0; k < 3; ++k) {
    numbers[k] = wrenches.force_i[k];
    numbers[3 + k] = wrenches.torque_i[k];
    numbers[6 + k] = wrenches.force_j[k];
    numbers[9 + k] = wrenches.torque_j[k];
  }
  numbers[12] = wrenches.potential;
  numbers[13] = wrenches.power;
  double* places[width];
  for (int l = 0; l < width; ++l) places[l] = to[l];
  scatter<wrench_size>(numbers, places);
}

LINKWORK_INLINE void add_wrench(const double* wrench, int i, int j, const ForceArrays& out) {
  for (int k = 0; k < 6; ++k) out.g[6l * i + k] += wrench[k];
  for (int k = 0; k < 6; ++k) out.g[6l * j + k] += wrench[6 + k];
  *out.potential += wrench[12];
  *out.power += wrench[13];
}

template <class Force>
LINKWORK_INLINE void evaluate_force_packs(const ForceElements& elements, const BodyState<double>* bodies,
                                          const Signal<double>* signals, const ForceArrays& out) {
  Signal<Pack> parameters[max_force_parameters];
  const auto end = static_cast<long>(out.end < elements.count ? out.end : elements.count);
  for (long first = static_cast<long>(out.begin); first < end; first += width) {
    const int used = end - first < width ? static_cast<int>(end - first) : width;
    long element[width];
    for (int l = 0; l < width; ++l) element[l] = first + (l < used ? l : used - 1);
    for (int p = 0; p < elements.parameter_count; ++p) parameters[p] = gather_parameter(elements, p, signals, element);
    const BodyState<Pack> i = gather_body(elements.body_i, bodies, element);
    const BodyState<Pack> j = gather_body(elements.body_j, bodies, element);
    HistoryVariable<Pack> history;
    if constexpr (Force::history != HistoryKind::none)
      for (int l = 0; l < width; ++l) history.last.v[l] = out.last[elements.history[element[l]]];
    Wrenches<Pack> wrenches;
    Force::template evaluate<Pack>(gather_attachment(elements.attachments, element), ForceParameters<Pack>(parameters),
                                   i, j, history, wrenches);
    double found[width][wrench_size];
    scatter_wrenches(wrenches, found);
    for (int l = 0; l < used; ++l) {
      const long k = element[l];
      if constexpr (Force::history != HistoryKind::none) {
        out.next[elements.history[k]] = history.next.v[l];
        out.rate[elements.history[k]] = history.rate.v[l];
      }
      for (int s = 0; s < switches_of<Force>(); ++s) out.switches[elements.switches[k] + s] = wrenches.switches[s].v[l];
      if (!out.wrenches) add_wrench(found[l], elements.body_i[k], elements.body_j[k], out);
      else copy(out.wrenches + wrench_size * static_cast<std::size_t>(k), found[l], wrench_size);
    }
  }
}

LINKWORK_INLINE void add_to(double* g, const Vec3<Pack>& force, const Vec3<Pack>& torque) {
  for (int k = 0; k < 3; ++k) packs(g)[k] += force[k];
  for (int k = 0; k < 3; ++k) packs(g)[3 + k] += torque[k];
}

/// One element of all lanes after the other.
template <class Force>
LINKWORK_INLINE void evaluate_force_lanes(const ForceLanes& elements, const ForceArrays& out) {
  Signal<Pack> parameters[max_force_parameters];
  for (int element = 0; element < elements.count; ++element) {
    load_parameters(elements.parameters, elements.parameter_count, element, parameters);
    const int body_i = elements.body_i[element], body_j = elements.body_j[element];
    Pack velocity[6];
    const BodyState<Pack> i = load_state(elements.states, body_i, velocity);
    const BodyState<Pack> j = load_state(elements.states, body_j, velocity);
    HistoryVariable<Pack> history;
    const long variable =
        Force::history == HistoryKind::none ? 0 : static_cast<long>(elements.history[element]) * width;
    if constexpr (Force::history != HistoryKind::none) history.last.v = load_native(out.last + variable);
    Wrenches<Pack> wrenches;
    Force::template evaluate<Pack>(load_attachment_of(elements.attachment, element), ForceParameters<Pack>(parameters),
                                   i, j, history, wrenches);
    if constexpr (Force::history != HistoryKind::none) {
      store_native(out.next + variable, history.next.v);
      store_native(out.rate + variable, history.rate.v);
    }
    for (int s = 0; s < switches_of<Force>(); ++s)
      store_native(out.switches + static_cast<long>(elements.switches[element] + s) * width, wrenches.switches[s].v);
    add_to(out.g + 6l * width * body_i, wrenches.force_i, wrenches.torque_i);
    add_to(out.g + 6l * width * body_j, wrenches.force_j, wrenches.torque_j);
    *packs(out.potential) += wrenches.potential;
    *packs(out.power) += wrenches.power;
  }
}

}  // namespace linkwork::simd::LINKWORK_ISA
