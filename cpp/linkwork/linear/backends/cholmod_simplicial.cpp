#include "linkwork/linear/backends/cholmod_solver.hpp"

namespace linkwork {

LinearSolverInfo cholmod_simplicial_solver() {
  return cholmod_info("cholmod_simplicial", "CHOLMOD's simplicial LDL^T factorization", CholmodMode::simplicial);
}

}  // namespace linkwork
