#pragma once

#include "linkwork/math/types.hpp"

namespace linkwork {

/// A place to write N constraint equations of bodies i and j:
/// Phi, Phi_t, gamma (N each) and D_i, D_j (N x 6, row after row: translation 3, rotation 3).
template <class Real, int N>
struct Rows {
  Real* Phi;
  Real* Phi_t;
  Real* gamma;
  Real* D_i;
  Real* D_j;

  /// Count equations beginning with the First-th.
  template <int First, int Count>
  Rows<Real, Count> slice() const {
    static_assert(First + Count <= N, "rows out of range");
    return {Phi + First, Phi_t + First, gamma + First, D_i + 6 * First, D_j + 6 * First};
  }
};

/// Row `row` of a D block: coefficients of r_dot and of omega.
template <class Real>
void set_row(Real* D, int row, const Vec3<Real>& translation, const Vec3<Real>& rotation) {
  Eigen::Map<Vec3<Real>>(D + 6 * row) = translation;
  Eigen::Map<Vec3<Real>>(D + 6 * row + 3) = rotation;
}

}  // namespace linkwork
