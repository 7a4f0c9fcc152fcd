#include "linkwork/linear/saddle_solver.hpp"

#include <cstdio>

#include "linkwork/math/names.hpp"

namespace linkwork {

const std::vector<MatrixForm>& matrix_forms() {
  static const std::vector<MatrixForm> all = {
      {.name = "kkt", .definite = false, .velocities = true, .multipliers = true, .make = &detail::make_kkt},
      {.name = "schur", .definite = true, .velocities = false, .multipliers = true, .make = &detail::make_schur},
      {.name = "normal", .definite = true, .velocities = true, .multipliers = false, .make = &detail::make_normal}};
  return all;
}

const MatrixForm& matrix_form(const std::string& name) {
  return find_named(matrix_forms(), name, "matrix_form", "unknown_matrix_form");
}

bool can_solve(const std::string& name, const LinearSolverInfo& solver) {
  const MatrixForm& form = matrix_form(name);
  return solver.make_saddle ? form.velocities : form.definite || !solver.positive_definite;
}

std::unique_ptr<SaddleSolver> make_saddle_solver(const std::string& name, const LinearSolverInfo& solver) {
  const MatrixForm& form = matrix_form(name);
  if (!can_solve(name, solver) && solver.make_saddle)
    throw OptionError("linear_solver", "linear solver '" + solver.name +
                                           "' works on the blocks of the kkt matrix and forms no other; use "
                                           "matrix_form 'kkt' or 'auto', or linear solver '" +
                                           first_available({"cholmod", "eigen_ldlt"}) + "'");
  if (!can_solve(name, solver))
    throw OptionError("linear_solver", "linear solver '" + solver.name + "' needs a positive definite matrix and the " +
                                           name + " matrix is indefinite; use matrix_form 'schur', or linear solver '" +
                                           first_available({"umfpack", "klu", "block"}) + "'");
  if (solver.make_saddle) return solver.make_saddle();
  const bool cholesky = form.definite && (solver.positive_definite || solver.dense);
  const Storage storage = cholesky ? Storage::upper : Storage::full;
  return form.make(solver.make(storage), storage);
}

std::unique_ptr<SaddleSolver> make_saddle_solver(const std::string& name, const LinearSolverInfo& solver,
                                                 const System& system) {
  std::unique_ptr<SaddleSolver> plain = make_saddle_solver(name, solver);
  return system.inerters().empty() ? std::move(plain) : detail::with_inerters(std::move(plain));
}

void detail::throw_singular(const System& system, const char* form, const Pivot& pivot, int row, const VectorXd& e) {
  char ratio[32];
  std::snprintf(ratio, sizeof ratio, "%.1e", pivot.ratio);
  const bool yields = e.size() > 0 && (row >= 0 ? e[row] : e.minCoeff()) > 0.0;  // inerters always do
  ErrorDetails details;
  std::string where = "the constraints of the mechanism";
  if (row >= 0) {
    details.joints = {system.model().joint_name(system.model().joint_of_row(row))};
    where = system.model().describe_row(row);
  }
  throw SingularSystemError("singular_system",
                            where + ": the " + form + " matrix is singular here (relative pivot " + ratio +
                                "): the constraint repeats what others fix, permanently or in this pose; use " +
                                (yields ? "a smaller penalty_scale" : "formulation 'augmented_lagrangian'"),
                            details);
}

}  // namespace linkwork
