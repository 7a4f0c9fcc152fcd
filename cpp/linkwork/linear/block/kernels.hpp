#pragma once

#include <cstddef>

#include "linkwork/assembly/body_forces.hpp"

/// The inner loops of the block solver, compiled once per instruction set (kernels.cpp) and chosen at run time. They
/// use nothing but plain arrays, so that no inline function of a library is compiled for a processor that may be
/// absent.
namespace linkwork::block {

constexpr int lanes = 8;            ///< storage is padded to vectors of 8 doubles on every instruction set
constexpr int ground_rows = 5;      ///< of the joint of a grounded body
constexpr int right_hand_side = 6;  ///< lane that carries the right-hand side beside the 6 rows of a body

/// A body at the end of an open branch and the joint that holds it, eliminated together.
struct TreeStep {
  int body;
  int parent;          ///< the joint's other body, or -1 for the ground (or where there is no joint)
  int row, rows;       ///< of the joint, 6 at most; rows = 0 for a body without joints
  int slot;            ///< of the body's articulated inertia, or -1 while it has only its own mass
  int parent_slot;     ///< of the parent's articulated inertia
  bool parent_begins;  ///< the parent's articulated inertia begins with its own mass here
  bool turning;        ///< of a hinge or of a joint that holds all, whose rows have the form of turning_kernels.hpp
  bool slides;         ///< of a slider
  int scattered;       ///< place in `step_rows` of rows that do not stand one after the other, as those of a joint with
                       ///< others attached, or -1
  std::ptrdiff_t D_body, D_parent;
  std::ptrdiff_t storage;  ///< place of the factors
};

/// A row of a step, wherever it stands: D of the body and of the parent, and its multiplier.
struct StepRow {
  std::ptrdiff_t D_body, D_parent;
  int row;
};

/// Factors of a step, without what is always zero: six vectors of `rows` numbers and one of the right-hand side, then
/// `rows` vectors of 6 and one.
constexpr std::ptrdiff_t second_factors(int rows) { return 6 * (rows + 1); }  ///< where the others begin
/// Doubles of all of them, in whole lines; of five or six rows also of those of turning_kernels.hpp.
constexpr std::ptrdiff_t step_storage(int rows) {
  const std::ptrdiff_t size = rows >= 5 ? 6 * 7 + 7 * rows + 1 : second_factors(rows) + 7 * rows;
  return (size + lanes - 1) / lanes * lanes;
}
/// Place of a number among them that is 0 where they are those of TreeStep, not those of turning_kernels.hpp.
constexpr std::ptrdiff_t sign_place(int rows) { return 6 * 7 + 7 * rows; }
/// Doubles of the factors of a body of the core with branches: L, and D^-1 L^-1 a.
constexpr std::ptrdiff_t own_factor_size = 7 * lanes;
/// Of a body, L^-1 D^T with and without D^-1; of a front, 8.
constexpr int scratch_columns = 12;
/// Doubles of an articulated inertia with its force: 6 columns of [M; a].
constexpr std::ptrdiff_t articulated_inertia_size = 6 * lanes;

/// A dense front of the core, of joints and hubs: `size` unknowns of which the first `width` are eliminated and the
/// others kept.
///
/// Rows have positions: those eliminated from 0 on, those kept from `top` on, both parts filled up to vectors. The
/// panel holds the eliminated columns, the right-hand side, and diag(D M^-1 D^T + E), each over all positions; the
/// contribution block holds the kept columns over the kept positions, and is added to the parent.
struct Front {
  int width, size;
  int top, contribution_rows;  ///< positions of the two parts
  int parent;                  ///< front that takes the contribution block, or -1
  int first_body, bodies;      ///< that are eliminated into this front
  int mixed;                   ///< place in `mixed` of a front that has to do with hubs, or -1
  bool childless;              ///< no other front clears it
  bool begins_parent;          ///< the first child: the parent is cleared before its contribution block is added
  std::ptrdiff_t unknown;      ///< place in `unknowns`: for each row, the index in lambda, or ~ the index in x
  std::ptrdiff_t panel, contribution;
  int first_relative_indices, relative_indices;  ///< of the contribution block in the parent

  int stride() const { return top + contribution_rows; }
};

/// A body of the core that is no hub: its part of D M^-1 D^T is added to the front of its first joint, where all its
/// rows have a place.
///
/// `vectors` of the front's positions hold its rows; the rows stand in these, one after the other, in the same lanes.
///
/// A grounded one is eliminated with its hinge or slider on the ground, which is part of no front: see
/// GroundElimination.
struct CoreBody {
  int body;
  int slot;         ///< of its articulated inertia, or -1 for a body without branches
  int mass_factor;  ///< of a body without branches, else -1
  int first_vector, vectors;
  int first_run, runs;         ///< of its rows, in `runs`: where they stand in the vectors, and in the front
  int first_row, rows;         ///< in `rows`
  std::ptrdiff_t own_factors;  ///< of a body with branches: place of L and of D^-1 L^-1 a
  int ground_row;              ///< of a grounded body the first of that joint, or -1
  bool slides;                 ///< it is a slider
  std::ptrdiff_t ground_D, ground_factors;

  bool grounded() const { return ground_row >= 0; }
};

/// Eight positions of a front from `position` on, and where the rows of D stand that belong there, or a row of
/// zeros.
struct RowVector {
  int position;
  std::ptrdiff_t D[lanes];
};

/// A row of D of a body, and its multiplier.
struct BodyRow {
  std::ptrdiff_t D;
  int row;
};

/// A run of relative indices: kept rows `begin` .. `begin + length` of a front have positions `parent_begin` .. in its
/// parent, all eliminated there or all kept.
struct RelativeIndices {
  int begin, parent_begin, length;
};

/// A body that is eliminated among joints instead of before them: its rows are -M x + D^T lambda = -a.
struct Hub {
  int body;
  int slot;      ///< of its articulated inertia, or -1
  int position;  ///< of its first row in the front
};

/// D of a hub in the rows of one of its joints, at the first positions of the two in the front.
struct Coupling {
  int joint, hub, rows;
  std::ptrdiff_t D;
};

/// Hubs that a front eliminates, and couplings between hubs and joints of which it eliminates one.
struct MixedFront {
  int first_hub, hubs, first_coupling, couplings;
};

/// M = L D L^T of a body without branches: constant, and all of L but three numbers is that of a unit matrix.
struct MassFactor {
  double L43, L53, L54;
  double inverse[6];  ///< of the pivots
  bool diagonal;
};

/// What a body of an open branch may lack in inertia, see ballast_kernels.hpp: inverse mass and moment, and the smallest
/// ones that count as pivots.
struct Ballast {
  double inverse_mass, inverse_moment;
  double least_mass, least_moment;
};

/// What is done with what an elimination contributes to its parent.
enum class Handing {
  over,   ///< it is added at once
  later,  ///< it is kept
  only    ///< what was kept is added, and nothing else is done
};

/// Eliminations `first` .. `last` - 1, steps or fronts.
struct NodeRange {
  int first, last;
  Handing handing;
};

/// Positions of a front from which on several threads can work on it.
constexpr int divisible_front = 256;

/// Helpers for such a front: calls part(context, k, worker) for k = 0 .. count - 1, at the same time.
struct Helpers {
  void* pool = nullptr;  ///< none: there are no helpers
  void (*run)(void* pool, int count, void (*part)(const void* context, int k, int worker),
              const void* context) = nullptr;
  double* const* scratch = nullptr;  ///< of each worker
};

/// Everything that the sweeps read, and the factors that they write.
struct Data {
  const TreeStep* steps;
  const StepRow* step_rows;
  const Front* fronts;
  const RelativeIndices* relative_indices;
  const CoreBody* bodies;
  const RowVector* vectors;
  const RelativeIndices* runs;
  const BodyRow* rows;
  const MixedFront* mixed;
  const Hub* hubs;
  const Coupling* couplings;
  const int* unknowns;
  const MassBlock* mass;
  const MassFactor* mass_factors;  ///< of the bodies that name one
  const Ballast* ballast;          ///< of each body; none where all have inertia
  const double* D;
  const double* e;  ///< compliance of each row; none where it is zero in all
  bool compliant;   ///< e is not zero in all rows that are not dropped
  double* factors;
  double* articulated_inertias;
  double* panels;
  double* contributions;
  double* scratch;   ///< `scratch_columns` of the highest front
  double* pivots;    ///< of the widest front
  bool large;        ///< more than a core's own cache holds: worth to be prefetched
  bool streamed;     ///< `factors` are more than any cache holds: they are written past them
  double breakdown;  ///< relative pivot from which no elimination should go on
  Helpers helpers;
};

/// The smallest pivot relative to its diagonal entry, and its constraint row or -1.
struct SmallestPivot {
  double ratio = 1.0;
  int row = -1;
};

/// Each does a part of its sweep: `count` ranges, those of the way back last to first. `scratch` and `pivots` are the
/// caller's own.
struct Kernels {
  /// Factors, with forward substitution of a (6 per body) and b (one per row) on the way.
  SmallestPivot (*factor_branches)(const Data&, const NodeRange*, int count, const double* a, const double* b);
  SmallestPivot (*factor_core)(const Data&, const NodeRange*, int count, const double* a, const double* b);
  /// The same forward substitution with factors that are there. On open branches it would cost what the factorization
  /// does, because both wait for the way to the root: there it is factor_branches.
  void (*forward_core)(const Data&, const NodeRange*, int count, const double* a, const double* b);
  /// x (6 per body) and lambda from what a forward substitution of the same a left.
  void (*backward_core)(const Data&, const NodeRange*, int count, const double* a, double* x, double* lambda);
  void (*backward_branches)(const Data&, const NodeRange*, int count, double* x, double* lambda);
};

const Kernels& kernels(const InstructionSet& instructions);

}  // namespace linkwork::block
