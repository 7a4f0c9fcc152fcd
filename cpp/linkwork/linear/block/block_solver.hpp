#pragma once

#include <memory>

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/linear/saddle_solver.hpp"

namespace linkwork::block {

/// Factorizes [M D^T; D -E] by dense blocks in a static order; see SymbolicFactorization. M must be regular.
std::unique_ptr<SaddleSolver> make_block_solver(const InstructionSet& instructions = best_instruction_set());

/// Light bodies between heavy ones cost digits, which the residual brings back.
bool masses_far_apart(const System& system);
/// Of a body's mass matrix.
MassFactor mass_factor(const System& system, int body);

}  // namespace linkwork::block
