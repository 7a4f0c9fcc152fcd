#include "linkwork/linear/backends/cholmod_solver.hpp"

namespace linkwork {

LinearSolverInfo cholmod_supernodal_solver() {
  return cholmod_info("cholmod_supernodal", "CHOLMOD's supernodal Cholesky factorization (BLAS)",
                      CholmodMode::supernodal);
}

}  // namespace linkwork
