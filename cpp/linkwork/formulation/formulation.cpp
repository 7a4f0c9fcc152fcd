#include "linkwork/formulation/formulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwork/math/names.hpp"

namespace linkwork {

#define LINKWORK_FORMULATION(NAME) FormulationInfo NAME##_formulation();
#include "linkwork/formulation/formulations.def"
#undef LINKWORK_FORMULATION

const std::vector<FormulationInfo>& formulations() {
  static const std::vector<FormulationInfo> all = {
#define LINKWORK_FORMULATION(NAME) NAME##_formulation(),
#include "linkwork/formulation/formulations.def"
#undef LINKWORK_FORMULATION
  };
  return all;
}

const FormulationInfo& formulation_info(const std::string& name) {
  return find_named(formulations(), name, "formulation", "unknown_formulation");
}

namespace {

/// Calls visit(first row, number of rows) for the translations and for the rotations of every joint.
template <class Visit>
void for_each_row_group(const Model& model, Visit visit) {
  for (std::size_t joint = 0; joint < model.joints().size(); ++joint) {
    const auto& equations = joint_info(model.joints()[joint].kind).equations;
    const auto first = equations.begin();
    for (auto begin = first; begin != equations.end();) {
      const auto other = [&](const EquationInfo& it) { return it.rotates() != begin->rotates(); };
      const auto end = std::find_if(begin, equations.end(), other);
      visit(model.joint_rows()[joint] + static_cast<int>(begin - first), static_cast<int>(end - begin));
      begin = end;
    }
  }
}

}  // namespace

VectorXd mean_delassus_diagonal(const System& system, const Evaluation& at) {
  VectorXd delassus = system.delassus_diagonal(at);
  for_each_row_group(system.model(), [&](int first, int count) {
    auto group = delassus.segment(first, count);
    group.setConstant(group.mean());
  });
  double least = std::numeric_limits<double>::infinity();
  for (const double value : delassus)
    if (value > 0.0) least = std::min(least, value);
  return (delassus.array() > 0.0).select(delassus, std::isfinite(least) ? least : 1.0);
}

VectorXd row_penalties(const ConstraintRows& rows, const std::optional<double>& penalty, double scale) {
  if (penalty) return VectorXd::Constant(rows.delassus.size(), *penalty);
  return scale * rows.delassus.cwiseInverse();
}

}  // namespace linkwork
