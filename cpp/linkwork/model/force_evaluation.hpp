#pragma once

#include "linkwork/model/element_loads.hpp"
#include "linkwork/model/force_kind.hpp"

/// The loop over the force elements of one kind, `width` at a time. Compiled once per instruction set, without
/// contraction: all of them give the same numbers to the last bit, whatever is beside an element.
namespace linkwork::simd::LINKWORK_ISA {

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
  for (int k = 0; k < 6 && i >= 0; ++k) out.g[6l * i + k] += wrench[k];
  for (int k = 0; k < 6 && j >= 0; ++k) out.g[6l * j + k] += wrench[6 + k];
  *out.potential += wrench[12];
  *out.power += wrench[13];
}

/// History variables of the elements from `first` on, of which `used` are there.
template <class Force>
LINKWORK_INLINE HistoryVariable<Pack> load_history(const ForceElements& elements, int first, int used,
                                                   const ForceArrays& out) {
  HistoryVariable<Pack> history;
  if constexpr (Force::history != HistoryKind::none)
    for (int l = 0; l < width; ++l) history.last.v[l] = out.last[elements.history[first + (l < used ? l : used - 1)]];
  return history;
}

/// What becomes of element k, in lane l, and where its law is not smooth.
template <class Force>
LINKWORK_INLINE void store_history(const ForceElements& elements, int k, int l, const HistoryVariable<Pack>& history,
                                   const Pack* switches, const ForceArrays& out) {
  if constexpr (Force::history != HistoryKind::none) {
    out.next[elements.history[k]] = history.next.v[l];
    out.rate[elements.history[k]] = history.rate.v[l];
  }
  for (int s = 0; s < switches_of<Force>(); ++s) out.switches[elements.switches[k] + s] = switches[s].v[l];
}

/// The first number of a row that need not be zero.
template <class Law>
constexpr int first_number = Law::Coordinate::kind == CoordinateKind::angle ? 3 : 0;

/// A force along the coordinate of a row: what `act` applies.
template <int first>
LINKWORK_INLINE void act_along(const ForceElements& elements, int k, const double* D, double force,
                               const ForceArrays& out) {
  if (out.wrenches) {
    double* to = out.wrenches + wrench_size * static_cast<std::size_t>(k);
    for (int c = 0; c < 12; ++c) to[c] = 0.0 + force * D[c];
    return;
  }
  const int i = elements.body_i[k], j = elements.body_j[k];
  for (int c = first; c < 6 && i >= 0; ++c) out.g[6l * i + c] += 0.0 + force * D[c];
  for (int c = first; c < 6 && j >= 0; ++c) out.g[6l * j + c] += 0.0 + force * D[6 + c];
}

LINKWORK_INLINE void add_or_leave(int k, double potential, double power, const ForceArrays& out) {
  if (out.wrenches) {
    double* to = out.wrenches + wrench_size * static_cast<std::size_t>(k);
    to[12] = potential;
    to[13] = power;
    return;
  }
  *out.potential += potential;
  *out.power += power;
}

/// Of elements along coordinates that are evaluated; what each applies is the same, to the last bit, as by itself.
template <class Law>
LINKWORK_INLINE void evaluate_laws(const LawElements& elements, const CoordinateValues& values,
                                   const Signal<double>* signals, const ForceArrays& out) {
  Signal<Pack> parameters[max_force_parameters];
  for (int first = 0; first < elements.count; first += width) {
    const int used = elements.count - first < width ? elements.count - first : width;
    load_parameters_of(elements, first, signals, parameters);
    Pack Phi, rate;
    for (int l = 0; l < width; ++l) {
      const int row = elements.row[first + (l < used ? l : used - 1)];
      Phi.v[l] = values.Phi[row];
      rate.v[l] = values.rate[row];
    }
    HistoryVariable<Pack> history = load_history<Law>(elements, first, used, out);
    const Along<Pack> said = said_by<Law>(ForceParameters<Pack>(parameters), Phi, rate, history);
    for (int l = 0; l < used; ++l) {
      const int k = first + l;
      store_history<Law>(elements, k, l, history, said.switches, out);
      act_along<first_number<Law>>(elements, k, values.D + elements.D[k], said.force.v[l], out);
      add_or_leave(k, said.potential.v[l], said.power.v[l], out);
    }
  }
}

template <class Force>
LINKWORK_INLINE void evaluate_law_packs(const LawElements& elements, const CoordinateValues& values,
                                        const Signal<double>* signals, const ForceArrays& out) {
  if constexpr (lies_along_coordinate<Force>) evaluate_laws<Force>(elements, values, signals, out);
}

template <class Force>
LINKWORK_INLINE void evaluate_force_packs(const ForceElements& elements, const double* q, const double* v,
                                          const Signal<double>* signals, const ForceArrays& out) {
  Signal<Pack> parameters[max_force_parameters];
  for (int first = 0; first < elements.count; first += width) {
    const int used = elements.count - first < width ? elements.count - first : width;
    load_parameters_of(elements, first, signals, parameters);
    Pack velocity[6];
    const BodyState<Pack> i = gather_state(elements.body_i + first, q, v, velocity);
    const BodyState<Pack> j = gather_state(elements.body_j + first, q, v, velocity);
    HistoryVariable<Pack> history = load_history<Force>(elements, first, used, out);
    Wrenches<Pack> wrenches;
    Force::template evaluate<Pack>(attachment_of(elements, first), ForceParameters<Pack>(parameters), i, j, history,
                                   wrenches);
    double found[width][wrench_size];
    scatter_wrenches(wrenches, found);
    for (int l = 0; l < used; ++l) {
      const int k = first + l;
      store_history<Force>(elements, k, l, history, wrenches.switches, out);
      if (!out.wrenches) add_wrench(found[l], elements.body_i[k], elements.body_j[k], out);
      else copy(out.wrenches + wrench_size * static_cast<std::size_t>(k), found[l], wrench_size);
    }
  }
}

LINKWORK_INLINE void add_to(double* g, const Vec3<Pack>& force, const Vec3<Pack>& torque) {
  for (int k = 0; k < 3; ++k) packs(g)[k] += force[k];
  for (int k = 0; k < 3; ++k) packs(g)[3 + k] += torque[k];
}

/// History variable of one element of all lanes.
template <class Force>
LINKWORK_INLINE HistoryVariable<Pack> load_lane_history(const ForceLanes& elements, int element,
                                                        const ForceArrays& out) {
  HistoryVariable<Pack> history;
  if constexpr (Force::history != HistoryKind::none)
    history.last.v = load_native(out.last + static_cast<long>(elements.history[element]) * width);
  return history;
}

/// What becomes of it, and where its law is not smooth.
template <class Force>
LINKWORK_INLINE void store_lane_history(const ForceLanes& elements, int element, const HistoryVariable<Pack>& history,
                                        const Pack* switches, const ForceArrays& out) {
  if constexpr (Force::history != HistoryKind::none) {
    const long variable = static_cast<long>(elements.history[element]) * width;
    store_native(out.next + variable, history.next.v);
    store_native(out.rate + variable, history.rate.v);
  }
  for (int s = 0; s < switches_of<Force>(); ++s)
    store_native(out.switches + static_cast<long>(elements.switches[element] + s) * width, switches[s].v);
}

/// One element of all lanes after the other.
template <class Force>
LINKWORK_INLINE void evaluate_force_lanes(const ForceLanes& elements, const ForceArrays& out) {
  Signal<Pack> parameters[max_force_parameters];
  for (int element = 0; element < elements.count; ++element) {
    load_parameters(elements.parameters, elements.parameter_count, element, parameters);
    const int body_i = elements.body_i[element], body_j = elements.body_j[element];
    const BodyState<Pack>& i = state_of(elements.states, body_i);
    const BodyState<Pack>& j = state_of(elements.states, body_j);
    HistoryVariable<Pack> history = load_lane_history<Force>(elements, element, out);
    Wrenches<Pack> wrenches;
    Force::template evaluate<Pack>(attachment_in(elements.attachment, element), ForceParameters<Pack>(parameters), i, j,
                                   history, wrenches);
    store_lane_history<Force>(elements, element, history, wrenches.switches, out);
    add_to(out.g + 6l * width * body_i, wrenches.force_i, wrenches.torque_i);
    add_to(out.g + 6l * width * body_j, wrenches.force_j, wrenches.torque_j);
    *packs(out.potential) += wrenches.potential;
    *packs(out.power) += wrenches.power;
  }
}

/// A force along the coordinate of a row: what `act` applies to one body.
template <int first>
LINKWORK_INLINE void act_in_lanes(const Pack& force, const double* d, double* g) {
  for (int c = first; c < 6; ++c) packs(g)[c] += Pack(0.0) + force * Pack(load_native(d + c * width));
}

/// Of elements along coordinates that are evaluated.
template <class Law>
LINKWORK_INLINE void evaluate_law_lanes(const LawLanes& elements, const CoordinateValues& values,
                                        const ForceArrays& out) {
  if constexpr (lies_along_coordinate<Law>) {
    Signal<Pack> parameters[max_force_parameters];
    for (int element = 0; element < elements.count; ++element) {
      load_parameters(elements.parameters, elements.parameter_count, element, parameters);
      const long row = static_cast<long>(elements.row[element]) * width;
      HistoryVariable<Pack> history = load_lane_history<Law>(elements, element, out);
      const Along<Pack> said = said_by<Law>(ForceParameters<Pack>(parameters), Pack(load_native(values.Phi + row)),
                                            Pack(load_native(values.rate + row)), history);
      store_lane_history<Law>(elements, element, history, said.switches, out);
      const double* D = values.D + elements.D[element] * width;
      act_in_lanes<first_number<Law>>(said.force, D, out.g + 6l * width * elements.body_i[element]);
      act_in_lanes<first_number<Law>>(said.force, D + 6l * width, out.g + 6l * width * elements.body_j[element]);
      *packs(out.potential) += said.potential;
      *packs(out.power) += said.power;
    }
  }
}

}  // namespace linkwork::simd::LINKWORK_ISA
