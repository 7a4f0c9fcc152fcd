#pragma once

#include "linkwork/linear/linear_solver.hpp"

namespace linkwork {

enum class CholmodMode { automatic, simplicial, supernodal };

/// CHOLMOD's sparse Cholesky (supernodal, LL^T) or LDL^T (simplicial) factorization; missing where the build has none.
LinearSolverInfo cholmod_info(const std::string& name, const std::string& documentation, CholmodMode mode);

}  // namespace linkwork
