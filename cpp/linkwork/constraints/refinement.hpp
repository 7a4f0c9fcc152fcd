#pragma once

#include <cmath>
#include <functional>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// What makes nearby solutions inexact: other inertias, roundoff alone, or roundoff near a singular pose.
enum class Inexactness { inertia, roundoff, singular_pose };

/// When corrections are enough.
class Corrections {
 public:
  /// `free_motion`: size of M^-1 a; where other inertias are the cause, of forces over the largest mass. What presses a
  /// light body against its joints has a very large M^-1 a, and corrections that are nothing beside that may be far less
  /// than errors.
  Corrections(Inexactness cause, double free_motion);

  /// `slow`: other inertias are so far away that it takes conjugate gradients.
  enum class Progress { going_on, converged, diverged, slow };
  /// After one of this size, which led to a solution of that size.
  Progress judge(double solution, double correction);

 private:
  Inexactness cause_;
  double free_motion_, last_ = INFINITY, enough_;
  int count_ = 0;
};

/// r_1 = a - M x + D^T lambda and r_2 = b - D x.
void find_saddle_residuals(const System& system, const Evaluation& at, const ConstVector& a, const ConstVector& b,
                           const ConstVector& x, const ConstVector& lambda, VectorXd& r_1, VectorXd& r_2);

/// THE iterative refinement of solutions of
///   M x - D^T lambda = a,   D x = b:
/// with the residuals r_1 = a - M x + D^T lambda and r_2 = b - D x a solver for a nearby matrix, M^ for M or roundoff
/// in its factors, is asked for the correction
///   M^ dx - D^T dlambda = r_1,   D dx = r_2,
/// again and again. The error shrinks by (M^ - M) / M^ over the motions that D allows, and what is left in the end is
/// the roundoff of the residuals.
///
/// A motion with hardly any inertia in M, and that D allows, makes this slow. Then the corrections become those of the
/// conjugate gradient method with M^ on ker D as its preconditioner (N. Gould, M. Hribar, J. Nocedal, SIAM J. Sci.
/// Comput. 23, 1376-1395, 2001), which needs one iteration for each such motion.
class Refinement {
 public:
  /// Solves for the nearby matrix.
  using Nearby = std::function<void(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda)>;

  Refinement() = default;
  /// `lengths`, one per body, make rotations comparable with translations; `refine` needs them.
  explicit Refinement(const System& system, const VectorXd& lengths = {});

  /// One correction of x and lambda by the residuals at an evaluation.
  void correct(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda,
               const Nearby& nearby);
  const VectorXd& r_2() const { return r_2_; }  ///< before the last correction
  const VectorXd& dx() const { return dx_; }    ///< the last correction

  /// Corrections until they are roundoff of `x` and M^-1 a. Only other inertias may be so far away that it takes
  /// conjugate gradients. False: they do not converge.
  bool refine(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda,
              const Nearby& nearby, Inexactness cause);

  /// The body that the last correction changed most.
  int least_certain_body() const;

 private:
  double size_of_body(const ConstVector& x, int body) const;
  double size_of(const ConstVector& x) const;
  /// M^-1 a, bodies without mass left out, and the largest force over the largest mass.
  struct FreeMotion {
    double size = 0.0, of_heaviest = 0.0;
  };
  FreeMotion free_motion(const ConstVector& a) const;
  double restore(const Nearby& nearby, MutableVector x, MutableVector lambda);
  void precondition(const Evaluation& at, const Nearby& nearby);
  struct Step {
    double length = 1.0;    ///< of p
    double softness = 0.0;  ///< square of the size of p over p . M p
  };
  Step next_step(const Evaluation& at, double& square);
  bool accelerate(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                  MutableVector lambda, const Nearby& nearby, const FreeMotion& free);

  const System* system_ = nullptr;
  VectorXd lengths_;
  VectorXd r_1_, r_2_, dx_, dlambda_;
  VectorXd p_, p_lambda_, Mp_, off_, off_lambda_;  ///< of the conjugate gradients
};

}  // namespace linkwork
