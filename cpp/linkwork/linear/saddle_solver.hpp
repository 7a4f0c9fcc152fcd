#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "linkwork/assembly/mass_ratios.hpp"
#include "linkwork/assembly/system.hpp"
#include "linkwork/linear/linear_solver.hpp"

namespace linkwork {

/// Solves the equations of constrained motion in the form that all formulations share,
///   [M  D^T] {   x   }   {a}
///   [D  -E ] {-lambda} = {b},      E = diag(e) >= 0,
/// by assembling one of three sparse matrices:
///   kkt     the matrix itself, E = 0                       (12.3)
///   schur   S = D M^-1 D^T + E                             (12.5), (12.6)
///   normal  N = M + D^T E^-1 D, E > 0; M may be singular   (12.14)
class SaddleSolver {
 public:
  virtual ~SaddleSolver() = default;

  /// Before `analyze`: rows whose D and b are zero in every evaluation, and their e positive. A solver may leave them
  /// out; their lambda is zero.
  void drop(std::vector<int> rows) { dropped_ = std::move(rows); }
  /// Before `analyze`: rows from this one on are those of inerters, whose e is positive in every matrix; the others may
  /// have none. `inertance`: see MassRatios.
  void expect_inerters(int first_row, double inertance) {
    compliant_from_ = first_row;
    inertance_ = inertance;
  }
  /// Symbolic work, once; `typical` scales rows.
  virtual void analyze(const System& system, const Evaluation& typical) = 0;
  /// The same of a system whose M is singular, or nearly so, by these bodies. False where they are not where the solver
  /// eliminates them with what holds them: then nothing is analyzed. Else a factorization is singular where they have a
  /// motion with hardly any inertia, too.
  virtual bool analyze_as_it_is(const System&, const Evaluation&, const std::vector<int>&) { return false; }
  /// Assembles and factorizes at an evaluation; an empty e is zero. Throws SingularSystemError naming joints where the matrix is singular.
  virtual void factorize(const Evaluation& at, const VectorXd& e) = 0;
  virtual void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) = 0;

  /// Both in one: a solver may carry the right-hand side through its factorization.
  virtual void factorize_and_solve(const Evaluation& at, const VectorXd& e, const ConstVector& a, const ConstVector& b,
                                   MutableVector x, MutableVector lambda) {
    factorize(at, e);
    solve(a, b, x, lambda);
  }

  /// What a factorization depends on beside its evaluation; after `analyze`.
  virtual void keep(Archive&) {}

  /// Whether masses are so far apart that roundoff shows in solutions, and is to be refined.
  virtual bool loses_digits(const MassRatios& ratios) const { return ratios.mass > 1e10; }
  /// Whether a factorization has changed the order of elimination since `analyze`.
  virtual bool reordered() const { return false; }
  /// Whether there is enough work in it for several threads, those of the system; after `analyze`.
  virtual bool shares_work() const { return false; }
  /// Of the last factorization; see Pivot.
  double smallest_pivot() const { return smallest_pivot_.ratio; }
  virtual std::int64_t factor_nonzeros() const = 0;
  virtual std::optional<double> flops() const { return {}; }               ///< see LinearSolver
  virtual std::optional<std::int64_t> factor_bytes() const { return {}; }  ///< see LinearSolver
  /// Entries in the lower triangle of the matrix; none from a solver that forms no matrix.
  virtual std::optional<std::int64_t> matrix_nonzeros() const { return {}; }
  /// Spent in assembling the matrix, in all [s]; zero where the factorization does it on its way.
  double assemble_time() const { return assemble_time_; }

 protected:
  std::vector<int> dropped_;
  int compliant_from_ = std::numeric_limits<int>::max();
  double inertance_ = 1.0;
  Pivot smallest_pivot_;
  double assemble_time_ = 0.0;
};

/// One of the three matrices.
struct MatrixForm {
  const char* name;
  bool definite;                 ///< positive definite: a Cholesky factorization does
  bool velocities, multipliers;  ///< its unknowns: x, lambda
  std::unique_ptr<SaddleSolver> (*make)(std::unique_ptr<LinearSolver>, Storage);
};

const std::vector<MatrixForm>& matrix_forms();
/// OptionError: there is none with this name.
const MatrixForm& matrix_form(const std::string& name);

std::unique_ptr<SaddleSolver> make_saddle_solver(const std::string& form, const LinearSolverInfo& solver);
/// For this system: with its inerters.
std::unique_ptr<SaddleSolver> make_saddle_solver(const std::string& form, const LinearSolverInfo& solver,
                                                 const System& system);

/// Which linear solvers can factorize a form.
bool can_solve(const std::string& form, const LinearSolverInfo& solver);

namespace detail {

/// The error for a vanishing pivot; `row` is the constraint row, or -1 where the factorization does not tell; `e` the
/// compliance.
[[noreturn]] void throw_singular(const System& system, const char* form, const Pivot& pivot, int row,
                                 const VectorXd& e);

std::unique_ptr<SaddleSolver> make_kkt(std::unique_ptr<LinearSolver> solver, Storage storage);
std::unique_ptr<SaddleSolver> make_schur(std::unique_ptr<LinearSolver> solver, Storage storage);
std::unique_ptr<SaddleSolver> make_normal(std::unique_ptr<LinearSolver> solver, Storage storage);
/// Of a system with inerters, whose M is not that of its bodies alone, by a solver for those without.
std::unique_ptr<SaddleSolver> with_inerters(std::unique_ptr<SaddleSolver> solver);

}  // namespace detail
}  // namespace linkwork
