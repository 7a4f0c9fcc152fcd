#pragma once

#include <string>
#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// What is left of a row of unit length that depends on the others: roundoff.
constexpr double rank_tolerance = 1e-9;

/// Rank of the constraint matrix at one evaluation.
struct PoseRank {
  int rows = 0;
  int rank = 0;
  std::vector<int> dependent_rows;  ///< rows that repeat what the others fix, ascending
  int degrees_of_freedom = 0;       ///< 6 per body less the rank
};

/// Joints at the ends of open branches are taken off one by one: their equations are independent of all others where
/// they are independent on the outer body. What is left, the closed loops, goes through a rank-revealing sparse QR of
/// D^T, rows of D scaled to unit length in velocities of natural size (see velocity_scale). `tolerance` is relative.
PoseRank rank_of_constraints(const System& system, const Evaluation& at, double tolerance = rank_tolerance);

/// Rank of the constraints of a mechanism: what is redundant in every pose, and what only in the assembled one.
struct RankReport {
  int rows = 0;
  int rank = 0;                     ///< away from singular poses
  int degrees_of_freedom = 0;       ///< 6 per body less that rank
  std::vector<int> redundant_rows;  ///< permanently redundant, ascending: the others imply them in every pose
  std::vector<int> singular_rows;   ///< of the others, those that depend on the rest in the assembled pose
  std::vector<char> unique;         ///< per joint: its multipliers, and so its reaction, follow from the motion
  int nearly_dependent = 0;         ///< kept rows that depend on the others but for digits of the geometry
  double least_part = 1.0;          ///< what is independent in the least of them
  double near = 0.0;                ///< no more in any
  bool beside_drivers = false;      ///< these three are those of the mechanism without its drivers
  VectorXd q;  ///< pose, as MassWeightedLeastSquares::of_geometry sees it, at which dependent groups are found:
               ///< perturbed where that was possible
};

/// The rank at the assembled pose (t = 0, projected onto the constraints first) and at a randomly perturbed consistent
/// pose near it. Rows that depend on the others at both are redundant; of each dependent group the rows that leave the
/// others best conditioned, at both poses, are chosen. A component of loops that cannot be perturbed though it has a
/// free velocity (its assembled pose is a dead center) has no redundant rows, and singular ones instead. The least
/// `tolerance` becomes larger where the roundoff of positions or a residual that assembly leaves is of that size: what
/// the given geometry does not say is not told from its rank. Where the mechanism stands makes no other difference.
RankReport examine_rank(const System& system, double tolerance = rank_tolerance);
/// The same with an evaluation of the system's, whatever it holds, as scratch memory.
RankReport examine_rank(const System& system, Evaluation& scratch, double tolerance = rank_tolerance);

/// Whether both have joints and an initial pose that are the same to the last bit, and nothing else that examine_rank
/// looks at: where a report of the one is one of the other. False where that takes more than a look at numbers.
bool same_geometry(const System& a, const System& b);

/// A redundant row with those that imply it; without any one of these it would not be.
struct DependentGroup {
  int row;
  std::vector<int> others;  ///< ascending; empty for a row that holds nothing
};

/// The groups of the first `most` redundant rows.
std::vector<DependentGroup> dependent_groups(const System& system, const RankReport& report, std::size_t most);

/// Such as "revolute 'F', rotation about joint x, repeats what 'A', 'B', 'C', 'D', 'E' already fix".
std::string describe(const Model& model, const DependentGroup& group);

/// Bodies with a motion that has no inertia, not of inerters either, and that no joint resists (ker M and ker D meet).
std::vector<int> free_massless_bodies(const System& system, const Evaluation& at, double tolerance = rank_tolerance);

}  // namespace linkwork
