#include "linkwork/linear/backends/cholmod_solver.hpp"

namespace linkwork {

LinearSolverInfo cholmod_solver() {
  return cholmod_info("cholmod", "CHOLMOD, supernodal or simplicial by its own flop count", CholmodMode::automatic);
}

}  // namespace linkwork
