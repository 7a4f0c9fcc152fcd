#pragma once

#include <string>
#include <vector>

#include "linkwork/ensemble/lanes.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/integrator.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

namespace linkwork {

/// What mechanisms must have in common to run in the lanes of one pack: bodies, kinds of joints and force elements and
/// the bodies that they join, redundant rows. All numbers may differ, and forces that are no elements may be others.
class LaneStructure {
 public:
  explicit LaneStructure(const Dynamics& dynamics);

  /// Whether there are any joints or inerters.
  bool connected() const { return multipliers() > 0; }
  /// Why lanes cannot run this, in words that end a sentence; empty where they can.
  static std::string refusal(const Dynamics& dynamics);
  /// The same of one whose structure they can.
  static std::string refusal_of_numbers(const Dynamics& dynamics);
  bool same(const Dynamics& dynamics) const;
  /// Whether a run by itself goes on in the same order of elimination after such a smallest pivot.
  bool keeps_order(const Dynamics& dynamics, double pivot) const;

  /// The joints of one kind.
  struct Joints {
    int kind;
    std::vector<int> joint, body_i, body_j, row;  ///< bodies as in JointLanes: the ground is the last
    std::vector<std::ptrdiff_t> D;
  };
  /// Coordinates of force elements of one kind, as in ElementCoordinates; the first rows are those of inerters.
  struct CoordinateRows {
    CoordinateKind kind;
    bool valued;
    std::vector<int> force, body_i, body_j, row;
    std::vector<std::ptrdiff_t> D;

    bool operator==(const CoordinateRows&) const = default;
  };
  /// The force elements of one kind, as in System::force_batches.
  struct Forces {
    int kind;
    std::vector<int> body_i, body_j;
    std::vector<std::ptrdiff_t> history, switches;  ///< places
    std::vector<int> row;                           ///< of coordinates that are evaluated, or none
    std::vector<std::ptrdiff_t> D;
  };

  int bodies, rows;
  int inerters;              ///< rows of D behind the others, with multipliers of their own, see Inerters
  std::ptrdiff_t inerter_D;  ///< where their D begins
  std::ptrdiff_t inerter_D_size;
  std::ptrdiff_t D_size;
  bool time_dependent;  ///< constraints, of any
  bool with_ballast;    ///< small inertias are eliminated as they are
  block::SymbolicFactorization symbolic;
  std::vector<int> row_positions;       ///< of symbolic.rows in their fronts
  std::vector<RowForm> row_forms;       ///< of symbolic.rows
  std::vector<ConstraintBlock> blocks;  ///< first those of joints, then those of inerters
  std::ptrdiff_t joint_blocks;
  std::vector<int> components;  ///< of each body its connected component
  int component_count;
  std::vector<Joints> joints;
  std::vector<CoordinateRows> coordinate_rows;
  std::ptrdiff_t coordinates;  ///< how many rows these are
  std::vector<Forces> forces;
  int history_size, switch_count;
  std::vector<int> special;               ///< special joints
  std::vector<int> dropped;               ///< redundant rows, ascending
  std::vector<std::ptrdiff_t> dropped_D;  ///< where the D of dropped rows is, 6 numbers each

  int y_size() const { return 13 * bodies + 1; }
  int multipliers() const { return rows + inerters; }

 private:
  void find_positions(const System& system);
  void list_joints(const System& system);
  void find_forms();
  std::vector<CoordinateRows> coordinates_of(const System& system) const;
  std::vector<int> places_of(const std::vector<int>& list, std::size_t count) const;
  void list_forces(const System& system);
  bool same_forces(const System& system) const;

  std::vector<Element> elements_;
};

}  // namespace linkwork
