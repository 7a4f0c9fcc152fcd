#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "linkwork/math/choice_by_instruction_set.hpp"
#include "linkwork/model/batch.hpp"
#include "linkwork/model/kind_info.hpp"
#include "linkwork/model/rows.hpp"

/// A joint is a struct (one file in joints/, one line in joints.def) with
///   static constexpr int rows;                  number of equations
///   static constexpr bool holds_point = true;   where the first three hold a point, D_i = [I, K_i] and D_j = [-I, K_j],
///                                               and the others are of rotation; else without it
///   static constexpr bool turns = true;         where all are of rotation, and depend on how the bodies turn alone
///   static KindInfo info();                     what there is to know of it, see KindInfo
///   template <class Real>
///   static void evaluate(const Attachment<Real>&, const Signal<Real>* parameters,
///                        const BodyState<Real>& i, const BodyState<Real>& j, Rows<Real, rows>);
/// composed of the primitives. Everything else (storage, bindings, documentation, tests) follows from the list.
namespace linkwork {

/// Where the equations of all joints go; see System for the layout of D.
struct ConstraintArrays {
  double* Phi;
  double* Phi_t;
  double* Phi_dot;
  double* gamma;
  double* D;
};

/// Evaluates all joints of a batch at q (7 per body) and v (6 per body): one indirect call per kind.
using EvaluateJoints = void (*)(const JointArrays&, const double* q, const double* v, const Signal<double>* signals,
                                const ConstraintArrays&);

/// The same for mechanisms in lanes: where equations go, each number is `width` of them.
using EvaluateJointLanes = void (*)(const JointLanes&, const ConstraintArrays&);

/// What a joint says of itself.
template <class Joint>
constexpr bool holds_point = requires { requires Joint::holds_point; };
template <class Joint>
constexpr bool slides = requires { requires Joint::slides; };
template <class Joint>
constexpr bool turns = requires { requires Joint::turns; };

struct JointKind {
  KindInfo info;
  bool holds_point, slides;
  EvaluateJoints evaluate[max_evaluations];                 ///< by level: the same bits at every one
  EvaluateJointLanes evaluate_lanes[max_instruction_sets];  ///< likewise
};

/// An evaluation holds the parameters of a joint in an array of this size.
constexpr std::size_t max_joint_parameters = 8;

/// A std::logic_error, when the list of kinds is first read: more parameters than max_joint_parameters, no rows or more than 6.
JointKind checked(JointKind kind);

/// Both ways to evaluate a kind, by level.
struct JointEvaluations {
  EvaluateJoints joints[max_evaluations];
  EvaluateJointLanes lanes[max_instruction_sets];
};

template <class Joint>
JointKind make_joint_kind(const JointEvaluations& by) {
  JointKind kind{Joint::info(), holds_point<Joint>, slides<Joint>, {}, {}};
  std::copy(std::begin(by.joints), std::end(by.joints), kind.evaluate);
  std::copy(std::begin(by.lanes), std::end(by.lanes), kind.evaluate_lanes);
  kind.info.rows = Joint::rows;
  return checked(std::move(kind));
}

/// All registered joints, in the order of joints.def.
const std::vector<JointKind>& joint_kinds();

/// The kind with this name, or an OptionError that names the nearest.
int joint_kind_index(const std::string& name);

// A joint's file is compiled once for its description and once per instruction set for its evaluation.
#define LINKWORK_EVALUATE(NAME)                                                                                    \
  void evaluate_##NAME(const JointArrays& joints, const double* q, const double* v, const Signal<double>* signals, \
                       const ConstraintArrays& out)
#define LINKWORK_EVALUATE_LANES(NAME) \
  void evaluate_##NAME##_lanes(const JointLanes& joints, const ConstraintArrays& out)
#if !defined(LINKWORK_ISA)
#define LINKWORK_DEFINE_JOINT(NAME, STRUCT)                                                                   \
  LINKWORK_FOR_EVALUATIONS(LINKWORK_EVALUATE(NAME);)                                                          \
  LINKWORK_FOR_INSTRUCTION_SETS(LINKWORK_EVALUATE_LANES(NAME);)                                               \
  JointKind NAME##_joint() {                                                                                  \
    return make_joint_kind<STRUCT>(                                                                           \
        {{LINKWORK_BY_EVALUATION(evaluate_##NAME)}, {LINKWORK_BY_INSTRUCTION_SET(evaluate_##NAME##_lanes)}}); \
  }
#else
#define LINKWORK_DEFINE_JOINT(NAME, STRUCT)                                  \
  namespace LINKWORK_ISA {                                                   \
  __attribute__((flatten)) LINKWORK_EVALUATE(NAME) {                         \
    simd::LINKWORK_ISA::evaluate_joints<STRUCT>(joints, q, v, signals, out); \
  }                                                                          \
  LINKWORK_OF_LANES(__attribute__((flatten)) LINKWORK_EVALUATE_LANES(NAME) { \
    simd::LINKWORK_ISA::evaluate_joint_lanes<STRUCT>(joints, out);           \
  })                                                                         \
  }
#endif

}  // namespace linkwork

#if defined(LINKWORK_ISA)
#include "linkwork/model/joint_evaluation.hpp"
#endif
