#include "linkwork/linear/saddle_solver.hpp"

#include <cstdio>

#include "linkwork/math/error.hpp"

namespace linkwork {

bool can_solve(const std::string& form, const LinearSolverInfo& solver) {
  if (solver.make_saddle) return form != "schur";
  return form != "kkt" || !solver.positive_definite;
}

std::unique_ptr<SaddleSolver> make_saddle_solver(const std::string& form, const LinearSolverInfo& solver) {
  if (!can_solve(form, solver) && solver.make_saddle)
    throw OptionError("linear_solver", "linear solver '" + solver.name +
                                           "' works on the blocks of the kkt matrix and forms no other; use system "
                                           "'kkt' or 'auto', or linear solver '" +
                                           first_available({"cholmod", "eigen_ldlt"}) + "'");
  if (!can_solve(form, solver))
    throw OptionError("linear_solver", "linear solver '" + solver.name +
                                           "' needs a positive definite matrix and the kkt matrix is indefinite; use "
                                           "system 'schur', or linear solver '" +
                                           first_available({"umfpack", "klu"}) + "'");
  if (solver.make_saddle) return solver.make_saddle();
  if (form == "kkt") return detail::make_kkt(solver.make(Storage::full));
  const bool symmetric = solver.positive_definite || solver.name == "dense";
  const Storage storage = symmetric ? Storage::upper : Storage::full;
  if (form == "schur") return detail::make_schur(solver.make(storage), storage);
  if (form == "normal") return detail::make_normal(solver.make(storage), storage);
  throw OptionError("unknown_system", "system '" + form + "' does not exist; there are: kkt, schur");
}

void detail::throw_singular(const System& system, const char* form, const Pivot& pivot, int row) {
  char ratio[32];
  std::snprintf(ratio, sizeof ratio, "%.1e", pivot.ratio);
  ErrorDetails details;
  std::string where = "the constraints of the mechanism";
  if (row >= 0) {
    details.joints = {system.model().joint_name(system.model().joint_of_row(row))};
    where = system.model().describe_row(row);
  }
  throw SingularSystemError("singular_system",
                            where + ": the " + form + " matrix is singular here (relative pivot " + ratio +
                                "): the constraint repeats what others fix, permanently or in this pose; use "
                                "formulation 'augmented_lagrangian'",
                            details);
}

}  // namespace linkwork
