#include "linkwork/linear/linear_solver.hpp"

#include <algorithm>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

std::string joined_available() {
  std::string names;
  for (const LinearSolverInfo& solver : linear_solvers())
    if (solver.available()) names += (names.empty() ? "" : ", ") + solver.name;
  return names;
}

}  // namespace

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
    throw OptionError("linear_solver_not_built", "linear solver '" + name + "' is not in this build: " +
                                                     found->missing + "; choose from: " + joined_available());
  return *found;
}

std::string first_available(std::initializer_list<const char*> names) {
  const auto& all = linear_solvers();
  const auto available = [&](const char* name) {
    return std::any_of(all.begin(), all.end(), [&](const auto& s) { return s.name == name && s.available(); });
  };
  return *std::find_if(names.begin(), names.end() - 1, available);
}

}  // namespace linkwork
