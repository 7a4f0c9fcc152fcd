#pragma once

#include <array>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Gauss collocation of order 16: y' is a polynomial of degree 7 in theta = (t - t_0) / h that satisfies the equations
/// at eight nodes, y(theta) = y_0 + h sum_i (integral_0^theta l_i) k_i (E. Hairer, S. P. Norsett, G. Wanner, Solving
/// Ordinary Differential Equations I, Springer 1993, section II.7). No node is at an end or in the middle.
struct GaussCollocation {
  static constexpr int stages = 8;
  using Weights = Eigen::Matrix<double, stages, 1>;

  GaussCollocation();

  Weights c;                                ///< nodes
  Eigen::Matrix<double, stages, stages> A;  ///< A_ij = integral of l_j from 0 to c_i

  Weights values(double theta) const;     ///< l_i(theta)
  Weights integrals(double theta) const;  ///< of l_i from 0 to theta
  /// Of the Legendre polynomial of highest degree in sum_i k_i l_i: how much of k the polynomial resolves no better.
  Weights last_coefficient() const { return coefficients_.col(stages - 1); }
  /// The same of the next lower degree, for a polynomial of that.
  Weights last_but_one() const { return coefficients_.col(stages - 2); }
  /// Value at node i of the polynomial through the values at the others.
  Weights from_others(int i) const;

 private:
  Eigen::Matrix<double, stages, stages> coefficients_;  ///< l_i = sum_k coefficients_ik P_k(2 theta - 1)
};

}  // namespace linkwork
