#pragma once

#include <vector>

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
  double* gamma;
  double* D;
};

struct JointKind {
  KindInfo info;
  /// Evaluates all joints of a batch: one indirect call per kind.
  void (*evaluate)(const Batch&, const BodyState<double>* bodies, const Signal<double>* signals, ConstraintArrays);
};

template <class Joint>
void evaluate_joints(const Batch& batch, const BodyState<double>* bodies, const Signal<double>* signals,
                     ConstraintArrays out) {
  constexpr int rows = Joint::rows;
  const std::size_t count = batch.parameters.size() / (batch.size() ? batch.size() : 1);
  constexpr std::size_t max_parameters = 8;
  Signal<double> parameters[max_parameters];
  for (std::size_t k = 0; k < batch.size(); ++k) {
    for (std::size_t p = 0; p < count; ++p) parameters[p] = current(batch.parameters[k * count + p], signals);
    const int row = batch.row[k];
    double* D_i = out.D + batch.D[k];
    const Rows<double, rows> place{out.Phi + row, out.Phi_t + row, out.gamma + row, D_i, D_i + 6 * rows};
    Joint::template evaluate<double>(batch.attachment[k], parameters, bodies[batch.body_i[k]], bodies[batch.body_j[k]],
                                     place);
  }
}

template <class Joint>
JointKind make_joint_kind() {
  JointKind kind{Joint::info(), &evaluate_joints<Joint>};
  kind.info.rows = Joint::rows;
  return kind;
}

/// All registered joints, in the order of joints.def.
const std::vector<JointKind>& joint_kinds();

/// The kind with this name, or an OptionError that names the nearest.
int joint_kind_index(const std::string& name);

#define LINKWORK_DEFINE_JOINT(NAME, STRUCT) \
  JointKind NAME##_joint() { return make_joint_kind<STRUCT>(); }

#define LINKWORK_JOINT(NAME) JointKind NAME##_joint();
#include "linkwork/model/joints.def"
#undef LINKWORK_JOINT

}  // namespace linkwork
