#pragma once

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/math/simd.hpp"

/// Bodies of open branches that have no inertia, or hardly any.
///
/// A body b and the joint that holds it are eliminated together: M_b x_b - D_b^T lambda = a_b, D_b x_b = c, with
/// c = b - D_p x_p. That is regular where M_b, together with what its branches carry, is so on ker D_b, though M_b
/// itself may be singular, of massless links between joints. With
///   M_b + D_b^T S D_b,   lambda + S c,   S = diag(s) of the rows that do not yield,
/// for M_b and lambda it is the same equation: a ballast that only moves where the joint is driven. It is regular, and
/// well conditioned with s as large as the inertia that the branch carries. Of the parent's articulated inertia and force
/// D_p^T S D_p and D_p^T S b are taken again, of lambda S D_b x_b. A hinge and a slider that are eliminated by their
/// freedom need none.
namespace linkwork::block {
namespace {

/// s of row d of a joint, 1 / (d M^-1 d^T) of the ballast's M, or 0 where it yields.
template <class Access>
LINKWORK_INLINE typename Access::Number ballast_of_row(const double* d, const double* ballast,
                                                       typename Access::Number compliance) {
  using Number = typename Access::Number;
  const auto square = [&](int k) { return Access::get(d, k) * Access::get(d, k); };
  const Number translation = square(0) + square(1) + square(2), rotation = square(3) + square(4) + square(5);
  const Number s = 1.0 / (translation * Access::get(ballast, 0) + rotation * Access::get(ballast, 1));
  return compliance == Number{} ? s : Number{};
}

/// s d x, the force of the ballast along such a row.
template <class Access>
LINKWORK_INLINE typename Access::Number force_of_ballast(const double* d, const double* ballast,
                                                         typename Access::Number compliance, const double* x) {
  typename Access::Number rate = Access::get(d, 0) * Access::get(x, 0);
  LINKWORK_UNROLL for (int k = 1; k < 6; ++k)
    rate += Access::get(d, k) * Access::get(x, k);
  return ballast_of_row<Access>(d, ballast, compliance) * rate;
}

}  // namespace
}  // namespace linkwork::block
