#include "linkwork/linear/backends/cholmod_solver.hpp"

namespace linkwork {

LinearSolverInfo cholmod_simplicial_solver() {
  return {"cholmod_simplicial", "CHOLMOD's simplicial LDL^T factorization", true,
          [](Storage) { return make_cholmod(CholmodMode::simplicial); }};
}

}  // namespace linkwork
