#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include "linkwork/math/inline.hpp"
#include "linkwork/math/instruction_set.hpp"
#include "linkwork/model/batch.hpp"
#include "linkwork/model/coordinate_rows.hpp"
#include "linkwork/model/history.hpp"
#include "linkwork/model/kind_info.hpp"
#include "linkwork/model/time_function.hpp"

/// A force element is a struct (one file in forces/, one line in forces.def) with
///   static constexpr HistoryKind history;      what its law needs of the past, see history.hpp
///   static KindInfo info();
///   template <class Real>
///   static void evaluate(const Attachment<Real>&, const ForceParameters<Real>&, const BodyState<Real>& i,
///                        const BodyState<Real>& j, HistoryVariable<Real>& history, Wrenches<Real>& out);
/// or, where it depends on one coordinate alone, a law along that, see LawAlong in forces/coordinates.hpp.
/// Power balance, checked for every registered force: g . v = -d(potential)/dt + power. A law that says `select(condition,
/// a, b)` instead of branching on the state, and that takes no functions of it, is evaluated for as many elements at a
/// time as a register has lanes: it ends with LINKWORK_DEFINE_FORCE_PACKS instead of LINKWORK_DEFINE_FORCE.
namespace linkwork {

/// What an element applies to bodies i and j: generalized forces (force inertial, torque body-fixed).
template <class Real>
struct Wrenches {
  Vec3<Real> force_i = Vec3<Real>::Zero(), torque_i = Vec3<Real>::Zero();
  Vec3<Real> force_j = Vec3<Real>::Zero(), torque_j = Vec3<Real>::Zero();
  Real potential = Real(0);  ///< stored energy [J]
  Real power = Real(0);      ///< power of the part without a potential [W]
  /// Where the law is not smooth they pass through zero: of `static constexpr int switches` in the element, if any.
  Real switches[2] = {Real(0), Real(0)};
};

/// Whether a force element is a law along a coordinate, see LawAlong.
template <class Force>
constexpr bool lies_along_coordinate = requires { Force::valued; };

/// Of a switch that is `sign` times a parameter and what the poses make of it: where that passes a limit.
struct SwitchLimit {
  int parameter;
  double sign;
};

/// How many switches a force element has.
template <class Force>
constexpr int switches_of() {
  if constexpr (requires { Force::switches; }) return Force::switches;
  else return 0;
}

/// What a law says of a coordinate x: the force Q along it that does the work Q dx, and see Wrenches.
template <class Real>
struct Along {
  Real force = Real(0);
  Real potential = Real(0);
  Real power = Real(0);
  Real switches[2] = {Real(0), Real(0)};
};

/// The parameters of one element, or of those in the lanes of registers, at the present time.
template <class Real>
class ForceParameters {
 public:
  explicit ForceParameters(const Signal<Real>* loaded) : loaded_(loaded) {}
  const Signal<Real>& operator[](int p) const { return loaded_[p]; }

 private:
  const Signal<Real>* loaded_;
};

template <>
class ForceParameters<double> {
 public:
  ForceParameters(const Parameter* given, const Signal<double>* signals, const TimeFunctionPtr* functions)
      : given_(given), signals_(signals), functions_(functions) {}

  bool is_zero(int p) const { return given_[p].signal < 0 && given_[p].constant == 0.0; }
  Signal<double> operator[](int p) const { return current(given_[p], signals_); }
  /// A parameter that is a function of a coordinate; a number stands for the slope of a line through zero.
  double at(int p, double x) const {
    const Parameter& parameter = given_[p];
    return parameter.signal < 0 ? parameter.constant * x : functions_[parameter.signal]->evaluate(x).value;
  }
  /// Its integral from 0 to x, where that is known.
  std::optional<double> integral(int p, double x) const {
    const Parameter& parameter = given_[p];
    if (parameter.signal < 0) return 0.5 * parameter.constant * x * x;
    const TimeFunctionPtr integral = functions_[parameter.signal]->integral();
    return integral ? std::optional(integral->evaluate(x).value) : std::nullopt;
  }

 private:
  const Parameter* given_;
  const Signal<double>* signals_;
  const TimeFunctionPtr* functions_;
};

/// Where the forces go: g (6 per body, in lanes the ground included as the last), the sums of potential and power; the
/// history variables, see HistoryVariable, and the switches, see Wrenches.
struct ForceArrays {
  double* g;
  const double* last;
  double *next, *rate, *switches;
  double* potential;
  double* power;
  /// Not added up but left here, where it is not null: of each element the four vectors of Wrenches in their order,
  /// potential and power.
  double* wrenches = nullptr;
};
constexpr std::size_t wrench_size = 14;  ///< numbers of an element in ForceArrays::wrenches

template <class Real>
struct Equation;  // primitives.hpp

/// A coordinate x between two bodies, as an equation whose D is its direction: x_dot = D v, x_ddot = D v_dot - gamma.
using CoordinateRow = void (*)(const Attachment<double>&, const BodyState<double>& i, const BodyState<double>& j,
                               Equation<double>&);

/// The state that forces are evaluated at. Bodies of elements that are evaluated one by one are looked up in `bodies`.
struct ForceState {
  const double *q, *v;  ///< 7 and 6 per body
  const BodyState<double>* bodies;
  const Signal<double>* signals;
  const TimeFunctionPtr* functions;
};

/// Elements [first, last) of one kind, one by one, or several at a time from a multiple of their width on; see Wrenches
/// and ForceArrays.
using EvaluateForces = void (*)(const ForceBatch&, int first, int last, const ForceState&, const ForceArrays&);
using EvaluateForcePacks = void (*)(const ForceElements&, const double* q, const double* v,
                                    const Signal<double>* signals, const ForceArrays&);
/// Elements of mechanisms in lanes. Of the arrays there are `width` numbers, one of each, where it says one; wrenches
/// are not written.
using EvaluateForceLanes = void (*)(const ForceLanes&, const ForceArrays&);
/// A coordinate between two bodies that is evaluated once for all elements along it: where its numbers are.
struct CoordinateValues {
  const double *Phi, *rate, *D;
};
/// Elements whose coordinates are evaluated: those of ForceBatch::row.
using EvaluateLawPacks = void (*)(const LawElements&, const CoordinateValues&, const Signal<double>* signals,
                                  const ForceArrays&);
/// The same of mechanisms in lanes.
using EvaluateLawLanes = void (*)(const LawLanes&, const CoordinateValues&, const ForceArrays&);
/// By level.
struct ForceEvaluations {
  EvaluateForcePacks packs[max_evaluations];
  EvaluateForceLanes lanes[max_instruction_sets];
  EvaluateLawPacks laws[max_evaluations];
  EvaluateLawLanes law_lanes[max_instruction_sets];
};

struct ForceKind {
  KindInfo info;
  HistoryKind history = HistoryKind::none;
  int switches = 0;
  EvaluateForces one_by_one = nullptr;
  EvaluateForcePacks packs[max_evaluations] = {};       ///< or these, by level: the same bits at every one
  EvaluateForceLanes lanes[max_instruction_sets] = {};  ///< by whoever has packs
  EvaluateLawPacks laws[max_evaluations] = {};          ///< of whoever lies along a coordinate
  EvaluateLawLanes law_lanes[max_instruction_sets] = {};
  std::optional<CoordinateKind> coordinate = {};  ///< that of a law, or of an inerter
  bool valued = false;                            ///< see LawAlong
  const SwitchLimit* limits = nullptr;            ///< of each switch, where these are
  /// Of an inerter: its coordinate, along which its first parameter, a constant, is inertia; see Inerters.
  CoordinateRow inertia = nullptr;

  void evaluate(int level, const ForceBatch& batch, int first, int last, const ForceState& at,
                const ForceArrays& out) const {
    if (packs[level]) packs[level](batch.elements(first, last), at.q, at.v, at.signals, out);
    else one_by_one(batch, first, last, at, out);
  }
};

/// Leaves what an element does for others to add up.
inline void leave(const Wrenches<double>& it, double* to) {
  for (const auto* vector : {&it.force_i, &it.torque_i, &it.force_j, &it.torque_j}) {
    Eigen::Map<Vec3<double>>{to} = *vector;
    to += 3;
  }
  to[0] = it.potential;
  to[1] = it.power;
}

/// What a law says where its coordinate is Phi, an angle in (-pi, pi], which goes on over full turns where it has a
/// history.
template <class Law, class Real>
LINKWORK_PRIMITIVE Along<Real> said_by(const ForceParameters<Real>& parameters, const Real& Phi, const Real& rate,
                                       HistoryVariable<Real>& history) {
  if constexpr (Law::history == HistoryKind::none) return Law::law(parameters, Phi, rate, history);
  history.next = continued(Phi, history.last);
  history.rate = rate;
  return Law::law(parameters, history.next, rate, history);
}

inline void add_to_body(double* g, int body, const Vec3<double>& force, const Vec3<double>& torque) {
  if (body < 0) return;
  Eigen::Map<Vec3<double>>(g + 6 * std::ptrdiff_t{body}) += force;
  Eigen::Map<Vec3<double>>(g + 6 * std::ptrdiff_t{body} + 3) += torque;
}

template <class Force>
void evaluate_forces(const ForceBatch& batch, int first, int last, const ForceState& at, const ForceArrays& out) {
  const std::size_t count = batch.parameters_each();
  const BodyState<double> ground = BodyState<double>::ground();
  const auto state_of = [&](int body) -> const BodyState<double>& { return body < 0 ? ground : at.bodies[body]; };
  for (int k = first; k < last; ++k) {
    const ForceParameters<double> parameters(batch.parameters.data() + k * count, at.signals, at.functions);
    const int i = batch.body_i[k], j = batch.body_j[k];
    Wrenches<double> wrenches;
    HistoryVariable<double> history;
    if constexpr (Force::history != HistoryKind::none) history.last = out.last[batch.history[k]];
    Force::template evaluate<double>(batch.attachment[k], parameters, state_of(i), state_of(j), history, wrenches);
    if constexpr (Force::history != HistoryKind::none) {
      out.next[batch.history[k]] = history.next;
      out.rate[batch.history[k]] = history.rate;
    }
    for (int s = 0; s < switches_of<Force>(); ++s) out.switches[batch.switches[k] + s] = wrenches.switches[s];
    if (out.wrenches) {
      leave(wrenches, out.wrenches + wrench_size * static_cast<std::size_t>(k - first));
      continue;
    }
    add_to_body(out.g, i, wrenches.force_i, wrenches.torque_i);
    add_to_body(out.g, j, wrenches.force_j, wrenches.torque_j);
    *out.potential += wrenches.potential;
    *out.power += wrenches.power;
  }
}

template <class Force>
ForceKind make_force_kind() {
  ForceKind kind{Force::info(), Force::history, switches_of<Force>(), &evaluate_forces<Force>};
  if constexpr (requires { Force::row; }) {
    kind.inertia = &Force::row;
    kind.coordinate = Force::Coordinate::kind;
  }
  return kind;
}

/// An evaluation of several elements at a time holds their parameters in an array of this size.
constexpr std::size_t max_force_parameters = 12;

/// A std::logic_error, when the list of kinds is first read: more parameters than max_force_parameters.
template <class Force>
ForceKind make_force_kind(const ForceEvaluations& by) {
  ForceKind kind{Force::info(), Force::history, switches_of<Force>()};
  if (kind.info.parameters.size() > max_force_parameters)
    throw std::logic_error("force '" + kind.info.name + "' has too many parameters to be evaluated several at a time");
  std::copy(std::begin(by.packs), std::end(by.packs), kind.packs);
  std::copy(std::begin(by.lanes), std::end(by.lanes), kind.lanes);
  if constexpr (lies_along_coordinate<Force>) {
    std::copy(std::begin(by.laws), std::end(by.laws), kind.laws);
    std::copy(std::begin(by.law_lanes), std::end(by.law_lanes), kind.law_lanes);
    kind.coordinate = Force::Coordinate::kind;
    kind.valued = Force::valued;
  }
  if constexpr (requires { Force::limits; }) kind.limits = Force::limits;
  return kind;
}

/// All registered forces, in the order of forces.def.
const std::vector<ForceKind>& force_kinds();

/// The kind with this name, or an OptionError that names the nearest.
int force_kind_index(const std::string& name);

// A force's file is compiled once for its description and for one element, and once per instruction set for many.
#define LINKWORK_EVALUATE_PACKS(NAME)                                                           \
  void evaluate_##NAME##_packs(const ForceElements& elements, const double* q, const double* v, \
                               const Signal<double>* signals, const ForceArrays& out)
#define LINKWORK_EVALUATE_LAWS(NAME)                                                       \
  void evaluate_##NAME##_laws(const LawElements& elements, const CoordinateValues& values, \
                              const Signal<double>* signals, const ForceArrays& out)
#define LINKWORK_EVALUATE_LAW_LANES(NAME) \
  void evaluate_##NAME##_law_lanes(const LawLanes& elements, const CoordinateValues& values, const ForceArrays& out)
#define LINKWORK_EVALUATE_FORCE_LANES(NAME) \
  void evaluate_##NAME##_lanes(const ForceLanes& elements, const ForceArrays& out)
#if !defined(LINKWORK_ISA)
#define LINKWORK_DEFINE_FORCE(NAME, STRUCT) \
  ForceKind NAME##_force() { return make_force_kind<STRUCT>(); }
#define LINKWORK_DEFINE_FORCE_PACKS(NAME, STRUCT)                                                 \
  LINKWORK_FOR_EVALUATIONS(LINKWORK_EVALUATE_PACKS(NAME);)                                        \
  LINKWORK_FOR_EVALUATIONS(LINKWORK_EVALUATE_LAWS(NAME);)                                         \
  LINKWORK_FOR_INSTRUCTION_SETS(LINKWORK_EVALUATE_FORCE_LANES(NAME);)                             \
  LINKWORK_FOR_INSTRUCTION_SETS(LINKWORK_EVALUATE_LAW_LANES(NAME);)                               \
  ForceKind NAME##_force() {                                                                      \
    return make_force_kind<STRUCT>({{LINKWORK_BY_EVALUATION(evaluate_##NAME##_packs)},            \
                                    {LINKWORK_BY_INSTRUCTION_SET(evaluate_##NAME##_lanes)},       \
                                    {LINKWORK_BY_EVALUATION(evaluate_##NAME##_laws)},             \
                                    {LINKWORK_BY_INSTRUCTION_SET(evaluate_##NAME##_law_lanes)}}); \
  }
#else
#define LINKWORK_DEFINE_FORCE(NAME, STRUCT)
#define LINKWORK_DEFINE_FORCE_PACKS(NAME, STRUCT)                                   \
  namespace LINKWORK_ISA {                                                          \
  __attribute__((flatten)) LINKWORK_EVALUATE_PACKS(NAME) {                          \
    simd::LINKWORK_ISA::evaluate_force_packs<STRUCT>(elements, q, v, signals, out); \
  }                                                                                 \
  __attribute__((flatten)) LINKWORK_EVALUATE_LAWS(NAME) {                           \
    simd::LINKWORK_ISA::evaluate_law_packs<STRUCT>(elements, values, signals, out); \
  }                                                                                 \
  LINKWORK_OF_LANES(__attribute__((flatten)) LINKWORK_EVALUATE_FORCE_LANES(NAME) {  \
    simd::LINKWORK_ISA::evaluate_force_lanes<STRUCT>(elements, out);                \
  })                                                                                \
  LINKWORK_OF_LANES(__attribute__((flatten)) LINKWORK_EVALUATE_LAW_LANES(NAME) {    \
    simd::LINKWORK_ISA::evaluate_law_lanes<STRUCT>(elements, values, out);          \
  })                                                                                \
  }
#endif

}  // namespace linkwork

#if defined(LINKWORK_ISA)
#include "linkwork/model/force_evaluation.hpp"
#endif
