#pragma once

#include <cstddef>

#include "linkwork/assembly/constraint_block.hpp"
#include "linkwork/linear/block/kernels.hpp"

/// The inner loops of ensembles: mechanisms of one structure, each in a lane. Every number here is `width` of them, one
/// of each mechanism, side by side. Compiled once per instruction set (lane_kernels.cpp, lane_solution.cpp) and chosen at
/// run time; without fused operations and in the order of operations of a run by itself with `deterministic`, so that a
/// lane has the bits of that run, whatever the width and whatever the other lanes hold.
namespace linkwork {

/// What is known of D of a row and body in every state: the numbers of its translation are zero, or one of them is 1 or
/// -1. What is multiplied by them need not be.
enum class RowForm : unsigned char { general, rotation, x, y, z };

/// What an elimination reads and writes; places are those of SymbolicFactorization, in numbers.
struct LaneData {
  const block::TreeStep* steps;
  const block::StepRow* step_rows;
  std::ptrdiff_t step_count;
  const block::Front* fronts;
  std::ptrdiff_t front_count;
  const block::MixedFront* mixed;
  const block::Hub* hubs;
  const block::Coupling* couplings;
  const block::RelativeIndices* relative_indices;
  const block::CoreBody* bodies;
  const block::BodyRow* rows;
  const int* row_positions;  ///< of `rows` in their fronts
  const RowForm* row_forms;  ///< of `rows`
  const int* unknowns;
  const double* compliance;    ///< one a row: of those that are left out and of inerters; others are zero
  bool compliant;              ///< there are inerters
  double breakdown;            ///< as in block::Data
  const double* mass;          ///< 10 a body: m, J row by row
  const double* mass_factors;  ///< 9 a body that has one: L43, L53, L54, six inverse pivots
  const double* ballast;       ///< 4 a body, see block::Ballast; or none
  const double* D;
  double* factors;
  double* articulated_inertias;
  double* panels;
  double* contributions;
  double* scratch;  ///< 12 of the most rows of a body; 8 of the highest front; 1 of the widest
};

/// The equations M x - D^T lambda = a, D x + e lambda = b as refinement sees them. Inerters are rows of D with the
/// compliance e, or inertia in M.
struct LaneEquations {
  int bodies, rows;
  const ConstraintBlock* blocks;
  std::ptrdiff_t block_count;
  const double* compliance = nullptr;  ///< of each row; without it they do not yield
  const ConstraintBlock* inerters = nullptr;
  std::ptrdiff_t inerter_count = 0;   ///< of their blocks
  const double* inertance = nullptr;  ///< one a row of them
  const double* mass;                 ///< 10 a body
  const double* lengths;              ///< one a body: make rotations comparable with translations
  const int* components = nullptr;    ///< of each body its connected component, of so many:
  int component_count = 0;
  const double* D;
};

/// y = (q, v, work), 13 n + 1 numbers.
struct LaneKernels {
  int width;

  /// Numbers of BodyState (18 a body) from y; of the ground behind them.
  void (*states)(int bodies, const double* y, double* states);
  /// g = (m gravity, -omega x J omega), 6 a body; and the potential -sum m gravity . r.
  void (*body_forces)(int bodies, const double* mass, const double* gravity, const double* y, double* g,
                      double* potential);
  /// g += sum b gamma d^T of inerters, whose blocks these are; row `first` is that of the first one.
  void (*inertia_forces)(const ConstraintBlock* blocks, std::ptrdiff_t count, int first, const double* inertance,
                         const double* gamma, const double* D, double* g);
  /// x = M^-1 a of bodies without joints and inerters; `inverse_mass`: 10 a body, 1/m and J^-1 row by row.
  void (*accelerate_freely)(int bodies, const double* inverse_mass, const double* a, double* x);
  /// q_dot = N(q) v and v_dot, without the work.
  void (*rates)(int bodies, const double* y, const double* v_dot, double* y_dot);
  /// Every p to unit length.
  void (*normalize)(int bodies, double* y);
  /// out = y + sum_k factors[k] x[k], of `count` numbers; factors of each lane its own.
  void (*combine)(int count, const double* y, int terms, const double* factors, const double* const* x, double* out);
  /// out = f x + g z, likewise.
  void (*weigh)(int count, const double* f, const double* x, const double* g, const double* z, double* out);
  /// The largest amount of all numbers in each lane; infinite where one is no number.
  void (*largest)(int count, const double* x, double* out);
  /// r_1 = a - M x + D^T lambda, r_2 = b - D x - e lambda.
  void (*residuals)(const LaneEquations& at, const double* a, const double* b, const double* x, const double* lambda,
                    double* r_1, double* r_2);
  /// Of each connected component the largest motion of a body in x, as in Refinement; in M^-1 a, where `of_heaviest` is
  /// not zero of forces over the largest mass, for which `scratch` has twice as many numbers.
  void (*motion)(const LaneEquations& at, const double* x, double* out);
  void (*free_motion)(const LaneEquations& at, const double* of_heaviest, const double* a, double* scratch,
                      double* out);
  /// x += dx in the lanes where `chosen` is not zero.
  void (*add)(int count, const double* chosen, const double* dx, double* x);
};

/// In the order of operations of the block solver by the instructions that every processor has.
struct LaneElimination {
  /// Factors, with forward substitution of a (6 a body) and b (one a row) on the way; the smallest pivot of each lane,
  /// relative to its diagonal entry.
  void (*factor)(const LaneData&, const double* a, const double* b, double* smallest);
  /// The same forward substitution with factors that are there.
  void (*forward)(const LaneData&, const double* a, const double* b);
  void (*backward)(const LaneData&, const double* a, double* x, double* lambda);
};

const LaneKernels& lane_kernels(const InstructionSet& instructions);
const LaneElimination& lane_elimination(const InstructionSet& instructions);

}  // namespace linkwork
