#include "linkwork/formulation/rank_tolerant.hpp"

#include <cmath>

#include "linkwork/constraints/row_selection.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double tolerances[] = {1e-8, 1e-7, 1e-6, 1e-4};  // the first that leaves a matrix with a factorization
constexpr double exact = 1e-14, roundoff = 1e-7, shrinking = 0.5;
constexpr int most_refinements = 30;

}  // namespace

RankTolerant::RankTolerant(const System& system) : solver_(system), at_(system.make_evaluation()) {
  for (VectorXd* velocities : {&r_1_, &dx_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&b_, &r_2_, &dlambda_}) rows->setZero(system.row_count());
}

void RankTolerant::factorize(const Evaluation& at) {
  for (const double tolerance : tolerances)
    if (factorize(at, tolerance)) return;
  throw SingularSystemError("singular_system",
                            "the constraints have no independent subset in this pose; use formulation "
                            "'augmented_lagrangian'");
}

bool RankTolerant::factorize(const Evaluation& at, double tolerance) {
  const System& system = solver_.system();
  const LoopCore core(system, at, tolerance);
  std::vector<int> rows;
  for (const int place : dependent_rows(core.scaled_D(at), tolerance))
    rows.push_back(core.rows()[static_cast<std::size_t>(place)]);
  left_out_ = DroppedRows(system, rows);
  at_ = at;
  left_out_.take_out(at_);
  VectorXd e = VectorXd::Zero(system.row_count());
  left_out_.scatter(VectorXd::Ones(left_out_.count()), e);
  return solver_.factorize(at_, e);
}

void RankTolerant::solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  const System& system = solver_.system();
  b_ = b;
  left_out_.take_from(b_);
  solver_.solve(a, b_, v_dot, lambda);
  double last = INFINITY;
  for (int k = 0; k < most_refinements; ++k) {
    system.multiply_mass(v_dot, dx_);
    r_1_ = a - dx_;
    system.add_D_transposed(at_, lambda, r_1_);
    system.multiply_D(at_, v_dot, r_2_);
    r_2_ = b_ - r_2_;
    solver_.solve(r_1_, r_2_, dx_, dlambda_);
    v_dot += dx_;
    lambda += dlambda_;
    const double change = dx_.norm() / (1.0 + v_dot.norm());
    if (change <= exact || (change <= roundoff && change > shrinking * last)) return;
    if (!std::isfinite(change)) break;
    last = change;
  }
  throw NotConvergedError("singular_pose",
                          "too near to a singular pose: the accelerations are not determined to half of the digits; "
                          "use another step, or formulation 'augmented_lagrangian'");
}

}  // namespace linkwork
