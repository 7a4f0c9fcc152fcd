#include "linkwork/linear/linear_solver.hpp"

#include <algorithm>

#include "linkwork/math/error.hpp"

namespace linkwork {

#define LINKWORK_SOLVER(NAME) LinearSolverInfo NAME##_solver();
#include "linkwork/linear/solvers.def"
#undef LINKWORK_SOLVER

const std::vector<LinearSolverInfo>& linear_solvers() {
  static const std::vector<LinearSolverInfo> solvers = {
#define LINKWORK_SOLVER(NAME) NAME##_solver(),
#include "linkwork/linear/solvers.def"
#undef LINKWORK_SOLVER
  };
  return solvers;
}

const LinearSolverInfo& linear_solver_info(const std::string& name) {
  const auto& solvers = linear_solvers();
  const auto found = std::find_if(solvers.begin(), solvers.end(), [&](const auto& s) { return s.name == name; });
  if (found == solvers.end()) {
    std::string known;
    for (const LinearSolverInfo& solver : solvers) known += (known.empty() ? "" : ", ") + solver.name;
    throw OptionError("unknown_linear_solver", "linear solver '" + name + "' does not exist; there are: " + known);
  }
  if (!found->available())
    throw OptionError("linear_solver_not_built", "linear solver '" + name +
                                                     "' is not in this build (it is GPL: LINKWORK_WITH_GPL=OFF); "
                                                     "use klu or eigen_ldlt");
  return *found;
}

}  // namespace linkwork
