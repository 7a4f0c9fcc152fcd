#pragma once

#include <memory>

#include "linkwork/linear/linear_solver.hpp"

namespace linkwork {

enum class CholmodMode { automatic, simplicial, supernodal };

/// CHOLMOD's sparse Cholesky (supernodal, LL^T) or LDL^T (simplicial) factorization.
std::unique_ptr<LinearSolver> make_cholmod(CholmodMode mode);

}  // namespace linkwork
