#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Rows of D by rows.
using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The closed loops of a system: the 2-core of its graph of bodies and joints. Leaves are pruned one by one: the
/// equations of their joints are independent of all others where they are independent on the outer body. What is left
/// falls into components that share no body.
class ClosedLoops {
 public:
  ClosedLoops(const System& system, const Evaluation& at, double tolerance);

  const System& system() const { return *system_; }
  const std::vector<int>& rows() const { return rows_; }  ///< constraint rows, ascending
  int row_count() const { return static_cast<int>(rows_.size()); }
  int joint_of_row(int place) const { return row_joint_[place]; }
  int component_count() const { return component_count_; }
  int component_of_row(int place) const { return row_component_[place]; }
  /// -1 for bodies outside.
  int component_of_body(int body) const { return body_component_[body]; }

  /// A spanning tree of short ways to the ground leaves out these joints: each closes a loop. The equations of the
  /// others are independent in (almost) every pose. Joints of more than two bodies count among them.
  bool closing(int joint) const { return closing_[joint] != 0; }
  /// A closing joint and those of the tree with which it closes a loop; empty where they are more than `most`, or where
  /// the joint has more than two bodies.
  std::vector<int> loop_of(int joint, std::size_t most) const;

  /// D of the rows in loops in velocities of natural size (see velocity_scale), every row scaled to unit length; a row
  /// that is roundoff of zero becomes zero. `lengths`, where given, becomes the lengths of the rows, 1 for such ones.
  SparseRows scaled_D(const Evaluation& at, VectorXd* lengths = nullptr) const;

 private:
  void find_components();
  void find_tree();

  const System* system_;
  VectorXd scale_;  ///< of velocities
  std::vector<int> rows_, row_joint_, row_component_, body_component_;
  std::vector<char> pruned_, closing_;     ///< of all joints
  std::vector<int> parent_joint_, depth_;  ///< in the tree: of the ground, then of the bodies
  int component_count_ = 0;
};

/// The rows of A with these numbers.
SparseRows select_rows(const SparseRows& A, const std::vector<int>& rows);

}  // namespace linkwork
