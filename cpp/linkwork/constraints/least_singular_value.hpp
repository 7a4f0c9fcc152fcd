#pragma once

#include <functional>
#include <vector>

#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/linear/saddle_solver.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork {

/// The least singular value of the constraint matrix, in the metric of the masses and relative to its rows (of unit
/// length at the start): it goes linearly to zero toward a singular pose, whatever the order of elimination. By inverse
/// iteration, which goes on from the vector of the last pose. One of each part that has equations of its own, see
/// ConnectedComponents: the least of all would hide what others come to.
class LeastSingularValue {
 public:
  LeastSingularValue() = default;
  /// `delassus`: see mean_delassus_diagonal.
  LeastSingularValue(const System& system, const VectorXd& delassus, const DroppedRows& dropped);

  /// M x - D^T lambda = 0, D x = b by some factorization.
  using Solve = std::function<void(const ConstVector& b, MutableVector x, MutableVector lambda)>;

  /// Of the parts; 0 where nothing finite comes of it. `at`: for the mass matrix; see System::multiply_mass.
  const VectorXd& of(const Solve& solve, const Evaluation& at);
  /// With the last factorization of `saddle`.
  const VectorXd& of(SaddleSolver& saddle, const Evaluation& at);

  void keep(Archive& archive) { archive(u_); }

 private:
  void begin();
  void iterate(const Solve& solve, const Evaluation& at);
  bool falls(const VectorXd& last) const;
  void add_up(const VectorXd& a, const VectorXd& b, const std::vector<int>& part, Eigen::Index each,
              VectorXd& sums) const;

  const System* system_ = nullptr;
  VectorXd scale_;                               ///< roots of the Delassus diagonal in kept rows, 0 of dropped ones
  VectorXd u_;                                   ///< the last left singular vector; empty: none yet
  VectorXd some_;                                ///< a vector with a part in all directions
  std::vector<int> part_of_row_, part_of_body_;  ///< -1: of none
  VectorXd quotients_, lengths_, values_;        ///< of the parts
  VectorXd none_, b_, x_, lambda_, momentum_;
};

}  // namespace linkwork
