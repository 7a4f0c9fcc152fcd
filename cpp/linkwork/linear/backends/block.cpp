#include "linkwork/linear/block/block_solver.hpp"

namespace linkwork {

LinearSolverInfo block_solver() {
  return {.name = "block",
          .documentation = "Dense blocks on a static schedule: open branches leaf to root, loops by supernodes",
          .lanes = true,
          .make_saddle = [] { return block::make_block_solver(); }};
}

}  // namespace linkwork
