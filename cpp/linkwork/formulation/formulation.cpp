#include "linkwork/formulation/formulation.hpp"

#include <algorithm>

#include "linkwork/math/error.hpp"

namespace linkwork {

const std::vector<FormulationInfo>& formulations() {
  static const std::vector<FormulationInfo> all = {
#define LINKWORK_FORMULATION(NAME) NAME##_formulation(),
#include "linkwork/formulation/formulations.def"
#undef LINKWORK_FORMULATION
  };
  return all;
}

const FormulationInfo& formulation_info(const std::string& name) {
  const auto& all = formulations();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& info) { return info.name == name; });
  if (found != all.end()) return *found;
  std::string known;
  for (const FormulationInfo& info : all) known += (known.empty() ? "" : ", ") + info.name;
  throw OptionError("unknown_formulation", "formulation '" + name + "' does not exist; there are: " + known);
}

VectorXd row_penalties(const System& system, const Evaluation& typical, const std::optional<double>& penalty,
                       double scale) {
  if (penalty) return VectorXd::Constant(system.row_count(), *penalty);
  const VectorXd mobility = system.row_mobility(typical);
  const double least = mobility.size() > 0 && mobility.maxCoeff() > 0.0
                           ? mobility.array().cwiseEqual(0.0).select(mobility.maxCoeff(), mobility.array()).minCoeff()
                           : 1.0;
  return scale * (mobility.array() > 0.0).select(mobility.array(), least).cwiseInverse();
}

}  // namespace linkwork
