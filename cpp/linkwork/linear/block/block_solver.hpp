#pragma once

#include <memory>

#include "linkwork/linear/block/kernels.hpp"
#include "linkwork/linear/saddle_solver.hpp"

namespace linkwork::block {

/// Factorizes [M D^T; D -E] by dense blocks in a static order; see SymbolicFactorization. M must be regular, or
/// regular with ballast, see SaddleSolver::analyze_as_it_is.
std::unique_ptr<SaddleSolver> make_block_solver(const InstructionSet& instructions = best_instruction_set());

/// Light bodies between heavy ones cost digits, which the residual brings back, and so do inertances far above what they
/// move that are eliminated row by row. Massless bodies do not count.
bool masses_far_apart(const System& system);
constexpr int most_refinements = 5;
/// Whether after a correction of this size, in amount, comes another one.
inline bool goes_on_refining(double solution, double correction) {
  constexpr double refined_enough = 1e-13;
  return correction > refined_enough * solution;
}
/// Of a body's mass matrix.
MassFactor mass_factor(const System& system, int body);

}  // namespace linkwork::block
