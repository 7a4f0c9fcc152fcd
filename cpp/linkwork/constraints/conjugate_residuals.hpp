#pragma once

#include <vector>

#include "linkwork/constraints/natural_size.hpp"
#include "linkwork/constraints/refinement.hpp"

namespace linkwork {

/// Conjugate residuals on the multipliers of
///   M x - D^T lambda = a,   D x = b,
/// which are those of D M^-1 D^T lambda = b - D M^-1 a, preconditioned by a factorization with penalties,
///   M dx - D^T dlambda = r_1,   D dx + E dlambda = r_2.
/// Such a correction shrinks errors by e / (s + e) only, s an eigenvalue of D M^-1 D^T and e that of E: where joints
/// connect very heavy and very light bodies, or a pose is nearly singular, it changes hardly anything far from the
/// solution. Conjugate residuals need about one iteration for each such s, and unlike conjugate gradients stay bounded
/// where rows contradict each other (E. Stiefel, Comment. Math. Helv. 29, 157-179, 1955). Each connected component goes
/// on until it is done.
class ConjugateResiduals {
 public:
  explicit ConjugateResiduals(const System& system);

  /// Lengths of the rows of D, which make them comparable whatever the units: before the first solution, of a pose that
  /// is not too far from those to come.
  void measure_rows(const Evaluation& at);

  /// From x and lambda that satisfy the first equation until D x = b but for roundoff, until steps change them by less
  /// than `enough`, or until what is left is a motion that joints do not resist, as in a singular pose; after `most`
  /// steps, or where roundoff leaves no way there, it is false.
  bool solve(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda,
             const Refinement::Nearby& nearby, double enough, int most);
  int steps() const { return steps_; }          ///< of the last solution
  const VectorXd& r_2() const { return r_2_; }  ///< before its last step

 private:
  /// How far a connected component is.
  struct Progress {
    double least = INFINITY;  ///< residual so far
    int small = 0, waiting = 0;
    bool done = false;
    bool has_stalled() const;
  };
  bool satisfies_rows(const Evaluation& at, const ConstVector& b, const ConstVector& x);
  bool go_on(const Evaluation& at, const ConstVector& x, const ConstVector& lambda, double enough);
  template <class IsDone>
  bool mark_done(const IsDone& is_done);
  void find_residuals_of_terms(const Evaluation& at, const ConstVector& b, const ConstVector& x);
  void measure_step(const Evaluation& at, const ConstVector& x, const ConstVector& lambda);
  void begin_anew();
  bool find_step(const Evaluation& at, const Refinement::Nearby& nearby);
  void find_largest(const ConstVector& multipliers, VectorXd& components) const;
  void find_largest_rates(const VectorXd& rows, VectorXd& components) const;
  void find_largest_forces(const Evaluation& at);

  const System* system_ = nullptr;
  const ConnectedComponents* components_ = nullptr;
  NaturalSize size_;
  VectorXd row_lengths_;
  VectorXd r_1_, r_2_, none_, no_rows_, terms_, dx_, dlambda_;
  VectorXd p_, p_lambda_, Mx_, Dp_;
  std::vector<Progress> progress_;  ///< of each component, as are these:
  VectorXd residuals_, free_motion_, of_heaviest_, sizes_, motions_, rates_, left_, multipliers_, all_multipliers_,
      forces_;
  double scale_ = 1.0;  ///< of directions
  double square_ = 0.0, step_ = 0.0;
  int steps_ = 0;
};

}  // namespace linkwork
