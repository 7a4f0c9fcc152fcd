#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Rank of the constraint matrix at one evaluation.
struct RankReport {
  int rows = 0;
  int rank = 0;
  std::vector<int> dependent_rows;  ///< rows that repeat what the others fix, ascending
  int degrees_of_freedom = 0;       ///< 6 per body less the rank
};

/// Joints at the ends of open branches are taken off one by one: their equations are independent of all others where
/// they are independent on the outer body. What is left, the closed loops, goes through a rank-revealing sparse QR of
/// D^T, rows of D scaled to unit length in the metric M^-1. `tolerance` is relative.
RankReport rank_of_constraints(const System& system, const Evaluation& at, double tolerance = 1e-9);

/// Bodies with a motion that has no inertia and that no joint resists (ker M and ker D meet).
std::vector<int> free_massless_bodies(const System& system, const Evaluation& at, double tolerance = 1e-9);

}  // namespace linkwork
