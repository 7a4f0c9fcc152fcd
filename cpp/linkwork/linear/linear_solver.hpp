#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "linkwork/linear/sparse_matrix.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork {

/// How near to singular a factorization came: the smallest pivot relative to its diagonal entry (Cholesky, LDL^T: it
/// does not change under diagonal scaling) or to the largest pivot (LU), and the row where, or -1. Zero or negative:
/// the factorization broke down.
struct Pivot {
  double ratio = 1.0;
  int row = -1;
};

/// Keeps the smaller pivot; a NaN counts as the smallest of all.
inline void keep_smallest(Pivot& smallest, double ratio, int row) {
  if (std::isnan(ratio)) ratio = -std::numeric_limits<double>::infinity();
  if (ratio < smallest.ratio) smallest = {ratio, row};
}

/// Direct solver of A x = b for a sparse symmetric A with a fixed pattern and at least one row.
///
/// analyze once for the pattern (symbolic work, memory); factorize as often as the values change; solve as often as
/// wanted after a factorize. A solver reads only the entries that its `storage` names.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;
  virtual void analyze(const SparseMatrix& pattern) = 0;
  virtual Pivot factorize(const SparseMatrix& A) = 0;
  /// Replaces the columns of `x` (right-hand sides) by the solutions.
  virtual void solve(Eigen::Ref<MatrixXd> x) = 0;
  /// What a factorization depends on beside its matrix; after `analyze`.
  virtual void keep(Archive&) {}
  /// Entries of the factors.
  virtual std::int64_t factor_nonzeros() const = 0;
  /// Of the last factorization, multiplications and additions, as the backend counts them; none where it does not.
  virtual std::optional<double> flops() const { return {}; }
  /// Memory that the factors take with their indices and workspace [bytes]; none where it is not known.
  virtual std::optional<std::int64_t> factor_bytes() const { return {}; }
};

class SaddleSolver;

struct LinearSolverInfo {
  std::string name;
  std::string documentation;
  /// True: needs a positive definite matrix and reads its upper triangle; false: any matrix, all entries.
  bool positive_definite = false;
  std::unique_ptr<LinearSolver> (*make)(Storage) = nullptr;
  bool dense = false;  ///< the quickest for small systems; Cholesky of the upper triangle, or LU of all entries
  bool blas = false;   ///< calls BLAS, which takes other ways on other processors
  bool lanes = false;  ///< ensembles have it in lanes
  /// Instead of `make`: a solver that works on the blocks of the equations themselves, without a sparse matrix.
  std::unique_ptr<SaddleSolver> (*make_saddle)() = nullptr;
  /// Why there is neither in this build; empty where there is one.
  std::string missing = {};

  bool available() const { return make || make_saddle; }  ///< in this build
};

/// All registered solvers, in the order of solvers.def, those missing in this build included.
const std::vector<LinearSolverInfo>& linear_solvers();
/// The solver with this name; an OptionError where it is unknown or not in this build.
const LinearSolverInfo& linear_solver_info(const std::string& name);
/// The first of these names that is in this build.
std::string first_available(std::initializer_list<const char*> names);

}  // namespace linkwork
