#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "linkwork/constraints/constrained_solver.hpp"
#include "linkwork/constraints/regularized_inertia.hpp"
#include "linkwork/formulation/options.hpp"
#include "linkwork/linear/saddle_solver.hpp"

namespace linkwork {

/// How the iterations of a formulation went, over a run.
struct IterationStatistics {
  std::int64_t iterations = 0;
  int most = 0;                  ///< in one solve
  std::int64_t accelerated = 0;  ///< solves that went on by conjugate residuals
  std::int64_t stagnations = 0;  ///< solves that ended at roundoff above the tolerance
  double last_change = 0.0;      ///< |d v_dot| / (|v_dot| + |M^-1 a|) of the last solve
  double last_residual = 0.0;    ///< max |b - D v_dot| of the last solve
  double worst_residual = 0.0;   ///< the same over the run
};

/// What a formulation knows of the constraint rows.
struct ConstraintRows {
  VectorXd delassus;         ///< see mean_delassus_diagonal
  std::vector<int> dropped;  ///< rows that are left out: their D is zero in every evaluation, and their b is 0
  const RegularizedInertia* inertia = nullptr;
};

/// How v_dot and lambda follow from M v_dot - D^T lambda = a, D v_dot = b at one evaluation.
class Formulation : public ConstrainedSolver {
 public:
  virtual void analyze(const System& system, const Evaluation& typical, const ConstraintRows& rows) = 0;
  /// After analyze: roundoff in solutions must not show where only relative errors of this size are tolerated.
  virtual void require_accuracy(double) {}
  /// Whether solutions are refined where they stand, see Refinement.
  virtual bool refines() const { return false; }
  /// Whether small inertias are eliminated as they are: else, what is factorized is the system of RegularizedInertia.
  virtual bool takes_small_inertias() const { return false; }
  virtual void factorize(const Evaluation& at) = 0;
  /// After factorize, for any number of right-hand sides.
  void solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) override = 0;

  virtual void factorize_and_solve(const Evaluation& at, const ConstVector& a, const ConstVector& b,
                                   MutableVector v_dot, MutableVector lambda) {
    factorize(at);
    solve(a, b, v_dot, lambda);
  }

  virtual SaddleSolver& saddle() const = 0;  ///< that of the last factorization
  /// What a factorization depends on beside its evaluation; after `analyze`.
  virtual void keep(Archive& archive) { saddle().keep(archive); }
  const IterationStatistics& iterations() const { return iterations_; }

 protected:
  IterationStatistics iterations_;
};

struct FormulationInfo {
  std::string name;
  std::string documentation;
  std::vector<std::string> forms;         ///< matrices it can use, see SaddleSolver
  std::vector<std::string> options = {};  ///< of some methods only that it has, see options.def
  bool needs_full_rank = false;           ///< a singular pose is an error
  bool regularizes_inertia = false;       ///< it takes massless bodies with any linear solver, see RegularizedInertia
  bool compliant = false;                 ///< constraints yield to forces: accelerations meet them only nearly
  bool lanes = false;                     ///< ensembles have it in lanes
  std::unique_ptr<Formulation> (*make)(std::unique_ptr<SaddleSolver>, const Options&) = nullptr;
};

/// All registered formulations, in the order of formulations.def.
const std::vector<FormulationInfo>& formulations();
const FormulationInfo& formulation_info(const std::string& name);

/// diag(D M^-1 D^T), the mean over a joint's translations and the mean over its rotations: it does not depend on the
/// directions of axes. Rows between massless bodies get the least of the others.
VectorXd mean_delassus_diagonal(const System& system, const Evaluation& at);

/// The same penalty for every row where the user gave one, else scale / delassus: then every row is as stiff against
/// its own inertia, and results do not depend on units.
VectorXd row_penalties(const ConstraintRows& rows, const std::optional<double>& penalty, double scale);

}  // namespace linkwork
