#pragma once

#include <vector>

#include "linkwork/constraints/mass_weighted_least_squares.hpp"

namespace linkwork {

/// Takes initial positions, then velocities, to constraints at t = 0 that may be redundant (P. E. Nikravesh, Initial
/// condition correction in multibody dynamics, Multibody System Dynamics 18, 2007, 107-115). Both change as little as
/// possible: positions by the displacement of the bodies' mass, integral |x - x_given|^2 w dm, velocities by
/// (v - v_given) . M w (v - v_given), with a weight w of each body.
///
/// Held bodies keep what they have: joints do not move them.
class InitialConditions {
 public:
  /// `weights` per body, or empty for 1; `held` indices of bodies.
  InitialConditions(const System& system, const VectorXd& weights, std::vector<int> held);

  /// Takes q to the constraints and from there to the pose nearest to `given`, without leaving its branch. False where
  /// the constraints cannot be met: q is then a pose that violates them least, and joints still violated conflict.
  bool positions(const VectorXd& given, VectorXd& q);
  /// Corrects v at q; likewise.
  bool velocities(const VectorXd& q, VectorXd& v);

  /// integral |x - x_given|^2 w dm [kg m2].
  double distance(const VectorXd& given, const VectorXd& q) const;

  int iterations() const { return iterations_; }  ///< factorizations, over all calls

 private:
  const System& system() const { return solver_.system(); }
  void evaluate(const VectorXd& q, const VectorXd& v);
  bool solve(const VectorXd& a, const VectorXd& b, double damping);
  double relative(const VectorXd& residuals) const;
  double rate_of_motion(const VectorXd& v) const;
  double rate(const VectorXd& v) const;
  bool is_roundoff(double residual, const VectorXd& v, double given) const;
  VectorXd velocity_residuals(const VectorXd& q, const VectorXd& v);
  bool conjugate_velocities(const VectorXd& q, VectorXd& v, double given, double least);
  double nearly_met() const;
  double merit() const;
  bool descend(VectorXd& q);
  void approach(const VectorXd& given, VectorXd& q);
  VectorXd pull(const VectorXd& given, const VectorXd& q) const;

  MassWeightedLeastSquares solver_;
  std::vector<int> held_;
  Evaluation at_;
  VectorXd history_, delassus_, rest_, x_, lambda_;
  VectorXd lengths_;      ///< of the bodies, see characteristic_lengths
  VectorXd row_lengths_;  ///< at the given pose
  double extent_;         ///< of the mechanism [m]
  double rounding_;       ///< of positions, by that of the lengths; at least 1
  int iterations_ = 0;
};

}  // namespace linkwork
