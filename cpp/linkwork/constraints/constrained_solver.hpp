#pragma once

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Solves the equations of constrained motion, whatever the method, at the evaluation that it was factorized for:
///   M x - D^T lambda = a,   D x = b.
class ConstrainedSolver {
 public:
  virtual ~ConstrainedSolver() = default;
  virtual void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) = 0;
};

}  // namespace linkwork
