#include "linkwork/linear/linear_solver.hpp"

#include <algorithm>

#include "linkwork/math/names.hpp"

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
  const LinearSolverInfo& found = find_named(linear_solvers(), name, "linear solver", "unknown_linear_solver");
  if (found.available()) return found;
  std::vector<LinearSolverInfo> others = linear_solvers();
  std::erase_if(others, [](const LinearSolverInfo& info) { return !info.available(); });
  throw OptionError("linear_solver_not_built", "linear solver '" + name + "' is not in this build: " + found.missing +
                                                   "; choose from: " + joined(names_of(others)));
}

std::string first_available(std::initializer_list<const char*> names) {
  const auto& all = linear_solvers();
  const auto available = [&](const char* name) {
    return std::any_of(all.begin(), all.end(), [&](const auto& s) { return s.name == name && s.available(); });
  };
  return *std::find_if(names.begin(), names.end() - 1, available);
}

}  // namespace linkwork
