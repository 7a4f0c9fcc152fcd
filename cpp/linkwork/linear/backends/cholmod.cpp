#include "linkwork/linear/backends/cholmod_solver.hpp"

namespace linkwork {

LinearSolverInfo cholmod_solver() {
  return {"cholmod", "CHOLMOD, supernodal or simplicial by its own flop count", true,
          [](Storage) { return make_cholmod(CholmodMode::automatic); }};
}

}  // namespace linkwork
