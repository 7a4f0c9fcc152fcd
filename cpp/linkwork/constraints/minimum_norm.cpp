#include "linkwork/constraints/minimum_norm.hpp"

namespace linkwork {
namespace {

constexpr double tolerance = 1e-12;  // of the residual of the normal equations
constexpr int spare_iterations = 10;

}  // namespace

// With the dropped rows d as parameters, N = [1; C] is a basis of ker D^T, where C omega = -S_k^-1 D_k M^-1 D_d^T omega
// is the multiplier of the kept rows k under the load a = D_d^T omega, b = 0. Under a = 0, b = u_k the motion is
// x = M^-1 D_k^T S_k^-1 u_k, so N^T u = u_d - D_d x. In scaled variables, lambda = w^-1/2 mu and omega = w_d^-1/2 nu,
// the normal equations of min |mu + N nu| are 1 + C^T C: conjugate gradients need few iterations.
MinimumNorm::MinimumNorm(const System& system, const VectorXd& delassus, const DroppedRows& dropped) {
  if (dropped.empty()) return;
  root_ = delassus.cwiseSqrt();
  scale_.resize(dropped.count());
  dropped.gather(root_, scale_);
  scale_ = scale_.cwiseInverse();
  for (VectorXd* velocities : {&a_, &x_}) velocities->setZero(system.v_size());
  for (VectorXd* rows : {&b_, &lambda_}) rows->setZero(system.row_count());
  for (VectorXd* parameters : {&omega_, &r_, &p_, &u_d_, &product_}) parameters->setZero(dropped.count());
}

/// lambda_ = w^1/2 N w_d^-1/2 omega.
void MinimumNorm::multiply_N(const DroppedRows& dropped, ConstrainedSolver& solver, const ConstVector& omega) {
  product_ = scale_.cwiseProduct(omega);
  a_.setZero();
  b_.setZero();
  dropped.add_transposed(product_, a_);
  solver.solve(a_, b_, x_, lambda_);
  dropped.scatter(product_, lambda_);
  lambda_.array() *= root_.array();
}

/// product_ = w_d^-1/2 N^T w^1/2 u.
void MinimumNorm::multiply_N_transposed(const DroppedRows& dropped, ConstrainedSolver& solver, const ConstVector& u) {
  a_.setZero();
  b_ = root_.cwiseProduct(u);
  dropped.gather(b_, u_d_);
  dropped.take_from(b_);
  solver.solve(a_, b_, x_, lambda_);
  dropped.multiply(x_, product_);
  product_ = scale_.cwiseProduct(u_d_ - product_);
}

void MinimumNorm::distribute(const DroppedRows& dropped, ConstrainedSolver& solver, MutableVector lambda) {
  lambda.array() *= root_.array();
  multiply_N_transposed(dropped, solver, lambda);
  omega_.setZero();
  r_ = p_ = -product_;
  double rr = r_.squaredNorm();
  const double enough = tolerance * tolerance * lambda.squaredNorm();
  for (int k = 0; k < dropped.count() + spare_iterations && rr > enough; ++k) {
    multiply_N(dropped, solver, p_);
    b_ = lambda_;
    multiply_N_transposed(dropped, solver, b_);
    const double step = rr / p_.dot(product_);
    omega_ += step * p_;
    r_ -= step * product_;
    const double before = rr;
    rr = r_.squaredNorm();
    p_ = r_ + (rr / before) * p_;
  }
  multiply_N(dropped, solver, omega_);
  lambda += lambda_;
  lambda.array() /= root_.array();
}

}  // namespace linkwork
