#pragma once

#include <cstddef>

#include "linkwork/assembly/body_forces.hpp"

/// The inner loops of the block solver, compiled once per instruction set (kernels.cpp) and chosen at run time. They
/// use nothing but plain arrays, so that no inline function of a library is compiled for a processor that may be
/// absent.
namespace linkwork::block {

constexpr int lanes = 8;            ///< storage is padded to vectors of 8 doubles on every instruction set
constexpr int right_hand_side = 6;  ///< lane that carries the right-hand side beside the 6 rows of a body

/// A body at the end of an open branch and the joint that holds it, eliminated together.
struct TreeStep {
  int body;
  int parent;          ///< the joint's other body, or -1 for the ground (or where there is no joint)
  int row, rows;       ///< of the joint; rows = 0 for a body without joints
  int slot;            ///< accumulator of the body, or -1 while it has only its own mass
  int parent_slot;     ///< accumulator of the parent
  bool parent_begins;  ///< the parent's accumulator is filled with its own mass here
  std::ptrdiff_t D_body, D_parent;
  std::ptrdiff_t storage;  ///< place of the factors
};

/// Doubles of factor storage of a step: 6 + rows vectors.
constexpr std::ptrdiff_t step_storage(int rows) { return (6 + rows) * lanes; }
/// Doubles of an accumulator: 6 columns of [M; a].
constexpr std::ptrdiff_t accumulator_size = 6 * lanes;

/// A dense front of the core: `size` unknowns of which the first `width` are eliminated and the others kept.
///
/// Rows have positions: those eliminated from 0 on, those kept from `top` on, both parts filled up to vectors. The
/// panel holds the eliminated columns and the right-hand side, each over all positions; the update holds the kept
/// columns over the kept positions, and is added to the parent.
struct Front {
  int width, size;
  int top, kept;           ///< positions of the two parts
  int parent;              ///< front that takes the update, or -1
  int body;                ///< the body, or -1 for a front of joints
  int slot;                ///< accumulator of the body, or -1
  int mass_factor;         ///< of a body without branches, else -1
  int mixed;               ///< place in `mixed` of a front of joints that has to do with hubs, or -1
  bool begins_parent;      ///< the first child: the parent is cleared before its update is added
  std::ptrdiff_t unknown;  ///< place in `unknowns`: for each row, the index in lambda, or ~ the index in x
  std::ptrdiff_t panel, update;
  std::ptrdiff_t D_row;         ///< of a body: place in `D_rows`
  int first_segment, segments;  ///< runs of kept rows that stand together in the parent

  int stride() const { return top + kept; }
  /// A body without branches needs no factors for the way back: D and M are at hand.
  bool keeps_panel() const { return mass_factor < 0; }
};

/// Kept rows `begin` .. `begin + length` of a front have positions `parent_begin` .. in its parent, all eliminated
/// there or all kept.
struct Segment {
  int begin, parent_begin, length;
};

/// A body that is eliminated among joints instead of before them: its rows are -M x + D^T lambda = -a.
struct Hub {
  int body;
  int slot;      ///< accumulator, or -1
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
  bool childless;  ///< nothing else clears it
};

/// M = L D L^T of a body without branches: constant, and all of L but three numbers is that of a unit matrix.
struct MassFactor {
  double L43, L53, L54;
  double inverse[6];  ///< of the pivots
};

/// Everything that the sweeps read, and the factors that they write.
struct Data {
  const TreeStep* steps;
  std::ptrdiff_t step_count;
  const Front* fronts;
  std::ptrdiff_t front_count;
  const Segment* segments;
  const MixedFront* mixed;
  const Hub* hubs;
  const Coupling* couplings;
  const std::ptrdiff_t* D_rows;  ///< for each kept row of a body's front, where its row of D is
  const int* unknowns;
  const MassBlock* mass;
  const MassFactor* mass_factors;  ///< of the fronts that name one
  const double* D;
  const double* e;  ///< compliance of each row
  double* factors;
  double* accumulators;
  double* panels;
  double* updates;
  double* scratch;   ///< 8 columns of the highest front
  double* pivots;    ///< of the widest front
  double* diagonal;  ///< diag(D M^-1 D^T + E) of the rows in the core
  double breakdown;  ///< relative pivot from which no elimination should go on
};

/// The smallest pivot relative to its diagonal entry, and its constraint row or -1.
struct SmallestPivot {
  double ratio = 1.0;
  int row = -1;
};

struct Kernels {
  /// Factors, with forward substitution of a (6 per body) and b (one per row) on the way.
  SmallestPivot (*factor)(const Data&, const double* a, const double* b);
  /// The same forward substitution with factors that are there.
  void (*forward)(const Data&, const double* a, const double* b);
  /// x (6 per body) and lambda from what a forward substitution of the same a left.
  void (*backward)(const Data&, const double* a, double* x, double* lambda);
};

const Kernels& kernels(const InstructionSet& instructions);

}  // namespace linkwork::block
