#include "linkwork/linear/backends/cholmod_solver.hpp"

namespace linkwork {

LinearSolverInfo cholmod_supernodal_solver() {
  return {"cholmod_supernodal", "CHOLMOD's supernodal Cholesky factorization (BLAS)", true,
          [](Storage) { return make_cholmod(CholmodMode::supernodal); }};
}

}  // namespace linkwork
