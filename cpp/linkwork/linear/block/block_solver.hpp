#pragma once

#include <memory>

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/linear/saddle_solver.hpp"

namespace linkwork::block {

/// Factorizes [M D^T; D -E] by dense blocks in a static order; see SymbolicFactorization. M must be regular.
std::unique_ptr<SaddleSolver> make_block_solver(const InstructionSet& instructions = best_instruction_set());

}  // namespace linkwork::block
