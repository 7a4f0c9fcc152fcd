#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "linkwork/math/instruction_set.hpp"
#include "linkwork/model/batch.hpp"
#include "linkwork/model/kind_info.hpp"
#include "linkwork/model/rows.hpp"

/// A joint is a struct (one file in joints/, one line in joints.def) with
///   static constexpr int rows;                  number of equations
///   static KindInfo info();                     name, placement, parameters, names of the equations, documentation
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

struct JointKind {
  KindInfo info;
  EvaluateJoints evaluate[max_instruction_sets];  ///< by level of the instruction set
};

/// An evaluation holds the parameters of a joint in an array of this size.
constexpr std::size_t max_joint_parameters = 8;

/// A std::logic_error, when the list of kinds is first read: more parameters than max_joint_parameters.
JointKind checked(JointKind kind);

template <class Joint>
JointKind make_joint_kind(EvaluateJoints v2, EvaluateJoints v3, EvaluateJoints v4) {
  JointKind kind{Joint::info(), {v2, v3, v4}};
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
#if defined(LINKWORK_ISA)
#define LINKWORK_DEFINE_JOINT(NAME, STRUCT)                                  \
  namespace LINKWORK_ISA {                                                   \
  __attribute__((flatten)) LINKWORK_EVALUATE(NAME) {                         \
    simd::LINKWORK_ISA::evaluate_joints<STRUCT>(joints, q, v, signals, out); \
  }                                                                          \
  }
#elif LINKWORK_X86
#define LINKWORK_DEFINE_JOINT(NAME, STRUCT)                                                           \
  namespace v2 {                                                                                      \
  LINKWORK_EVALUATE(NAME);                                                                            \
  }                                                                                                   \
  namespace v3 {                                                                                      \
  LINKWORK_EVALUATE(NAME);                                                                            \
  }                                                                                                   \
  namespace v4 {                                                                                      \
  LINKWORK_EVALUATE(NAME);                                                                            \
  }                                                                                                   \
  JointKind NAME##_joint() {                                                                          \
    return make_joint_kind<STRUCT>(&v2::evaluate_##NAME, &v3::evaluate_##NAME, &v4::evaluate_##NAME); \
  }
#else
#define LINKWORK_DEFINE_JOINT(NAME, STRUCT) \
  namespace v2 {                            \
  LINKWORK_EVALUATE(NAME);                  \
  }                                         \
  JointKind NAME##_joint() { return make_joint_kind<STRUCT>(&v2::evaluate_##NAME, nullptr, nullptr); }
#endif

}  // namespace linkwork

#if defined(LINKWORK_ISA)
#include "linkwork/model/joint_evaluation.hpp"
#endif
