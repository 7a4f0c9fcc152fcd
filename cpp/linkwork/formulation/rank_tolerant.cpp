#include "linkwork/formulation/rank_tolerant.hpp"

#include "linkwork/constraints/row_selection.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double yielding_part = 1e-9;  // of the Delassus diagonal
constexpr double enough = 1e-10;        // of changes by conjugate residuals
constexpr int most_steps = 100;
constexpr double tolerances[] = {1e-8, 1e-7, 1e-6, 1e-4};  // the first that leaves a matrix with a factorization

}  // namespace

RankTolerant::RankTolerant(const System& system, const RegularizedInertia& inertia)
    : inertia_(inertia),
      solver_(inertia.system()),
      at_(system.make_evaluation()),
      refinement_(system, inertia.lengths()),
      residuals_(system),
      b_(VectorXd::Zero(system.row_count())) {}

void RankTolerant::factorize(const Evaluation& at) {
  for (const double tolerance : tolerances)
    if (factorize(at, tolerance)) return;
  throw SingularSystemError("singular_system",
                            "the constraints have no independent subset in this pose; use formulation "
                            "'augmented_lagrangian'");
}

bool RankTolerant::factorize(const Evaluation& at, double tolerance) {
  const System& system = solver_.system();
  const ClosedLoops loops(system, at, tolerance);
  std::vector<int> rows;
  for (const int place : dependent_rows(loops, loops.scaled_D(at), tolerance)) rows.push_back(loops.rows()[place]);
  left_out_ = DroppedRows(system, rows);
  at_ = at;
  residuals_.measure_rows(at_);
  left_out_.take_out(at_);
  return factorize(!inertia_.regularized());
}

bool RankTolerant::factorize(bool yielding) {
  const System& system = solver_.system();
  VectorXd e = VectorXd::Zero(system.row_count());
  if (yielding) e = yielding_part * mean_delassus_diagonal(system, at_);
  left_out_.scatter(VectorXd::Ones(left_out_.count()), e);
  yields_ = yielding;
  return solver_.factorize(at_, e);
}

/// Without forces, and none for the accelerations: a part of an iteration whose end its caller judges, as it does not
/// depend on all digits of its steps.
bool RankTolerant::corrects(const ConstVector& a, const ConstVector& b) const {
  if (!a.isZero(0.0)) return false;
  VectorXd difference = b - at_.gamma;
  left_out_.take_from(difference);
  return !difference.isZero(0.0);
}

/// Where the masses are so uneven that conjugate residuals get nowhere, elimination may do.
bool RankTolerant::exact(const ConstVector& a, MutableVector v_dot, MutableVector lambda) {
  if (yields_) {
    if (residuals_.solve(at_, a, b_, v_dot, lambda, nearby_, enough, most_steps)) return true;
    if (!factorize(false)) return false;
    solver_.solve(a, b_, v_dot, lambda);
  }
  const auto cause = inertia_.regularized() ? Inexactness::inertia : Inexactness::singular_pose;
  return refinement_.refine(at_, a, b_, v_dot, lambda, nearby_, cause);
}

void RankTolerant::solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  b_ = b;
  left_out_.take_from(b_);
  solver_.solve(a, b_, v_dot, lambda);
  if (exact(a, v_dot, lambda) || corrects(a, b)) return;
  throw NotConvergedError("singular_pose",
                          "too near to a singular pose: the accelerations are not determined to half of the digits; "
                          "use another step, or formulation 'augmented_lagrangian'; where the run begins so, turn the "
                          "mechanism a little along one branch");
}

}  // namespace linkwork
