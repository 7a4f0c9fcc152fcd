#include "linkwork/constraints/constraint_kernel.hpp"

#include <random>

namespace linkwork {

ConstraintKernel::ConstraintKernel(MassWeightedLeastSquares& solver, const ClosedLoops& loops, Evaluation& at,
                                   const std::vector<int>& dependent)
    : solver_(solver),
      loops_(loops),
      at_(at),
      scale_(solver.system().delassus_diagonal(at).cwiseSqrt()),
      dropped_(solver.system(), dependent),
      refinement_(solver.system()) {
  const System& system = solver.system();
  scale_ = (scale_.array() > 0.0).select(scale_, 1.0);
  dropped_.take_out(at_);
  VectorXd e = VectorXd::Zero(system.row_count());
  dropped_.scatter(VectorXd::Ones(dropped_.count()), e);
  regular_ = solver.factorize(at_, e);
  for (VectorXd* velocities : {&a_, &x_}) velocities->setZero(system.v_size());
  for (VectorXd* values : {&b_, &lambda_}) values->setZero(system.row_count());
}

VectorXd ConstraintKernel::vector(const VectorXd& n_d) {
  VectorXd omega(size());
  dropped_.gather(scale_, omega);
  omega = n_d.cwiseQuotient(omega);
  a_.setZero();
  b_.setZero();
  dropped_.add_transposed(omega, a_);
  solver_.solve(a_, b_, x_, lambda_);
  const auto once_more = [this](const ConstVector& r_1, const ConstVector& r_2, MutableVector dx,
                                MutableVector dlambda) { solver_.solve(r_1, r_2, dx, dlambda); };
  refinement_.correct(at_, a_, b_, x_, lambda_, once_more);
  dropped_.scatter(omega, lambda_);
  VectorXd n(loops_.row_count());
  for (int place = 0; place < loops_.row_count(); ++place) n[place] = lambda_[row(place)] * scale_[row(place)];
  return n;
}

void ConstraintKernel::mark_members(std::vector<char>& marks) {
  if (size() == 0) return;
  std::mt19937_64 engine(2);
  VectorXd n_d(size());
  for (double& x : n_d) x = 0.5 + static_cast<double>(engine() >> 11) * 0x1p-53;
  const VectorXd n = vector(n_d);
  const double least = member * n.cwiseAbs().maxCoeff();
  for (Eigen::Index k = 0; k < n.size(); ++k)
    if (std::abs(n[k]) > least) marks[k] = 1;
}

}  // namespace linkwork
