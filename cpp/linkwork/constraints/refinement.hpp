#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "linkwork/assembly/connected_components.hpp"

namespace linkwork {

/// What makes nearby solutions inexact: other inertias, roundoff alone, or roundoff near a singular pose.
enum class Inexactness { inertia, roundoff, singular_pose };

/// When corrections are enough.
class Corrections {
 public:
  explicit Corrections(Inexactness cause);

  /// `slow`: other inertias are so far away that it takes conjugate gradients.
  enum class Progress { going_on, converged, diverged, slow };
  /// After one of this size, relative to the solution and M^-1 a; where other inertias are the cause, to the solution
  /// and forces over the largest mass: what presses a light body against its joints has a very large M^-1 a, and
  /// corrections that are nothing beside that may be far less than errors. Of all connected components the largest.
  Progress judge(double correction);

 private:
  Inexactness cause_;
  double last_ = INFINITY, enough_;
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
/// Comput. 23, 1376-1395, 2001), which needs one iteration for each such motion. Connected components have equations of
/// their own: each is refined as if it were alone.
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
  /// How far the conjugate gradients of a connected component are.
  struct Progress {
    double square = 0.0;                   ///< of the residual on ker D, in the norm of M^-1
    double first = 0.0, least = INFINITY;  ///< sizes of residuals
    double longest = 1.0, softest = 0.0;   ///< of the steps so far: the factor of p, |p|^2 over p . M p
    int waiting = 0;
    bool has_inertia = true;  ///< along all of them
    bool done = false;
  };
  double size_of_body(const ConstVector& x, int body) const;
  void find_sizes(const ConstVector& x, VectorXd& components) const;
  void find_products(const VectorXd& x, const VectorXd& y, VectorXd& components) const;
  void find_free_motion(const ConstVector& a);
  double largest_correction(const ConstVector& x, Inexactness cause);
  void restore(const Nearby& nearby, MutableVector x, MutableVector lambda);
  void precondition(const Evaluation& at, const Nearby& nearby);
  bool judge_residuals(const ConstVector& x);
  bool done() const;
  void find_directions();
  void find_steps(const Evaluation& at);
  void add(const VectorXd& factors, const VectorXd& x, const VectorXd& lambda, MutableVector to_x,
           MutableVector to_lambda) const;
  bool accelerate(const Evaluation& at, const ConstVector& a, const ConstVector& b, MutableVector x,
                  MutableVector lambda, const Nearby& nearby);

  const System* system_ = nullptr;
  const ConnectedComponents* components_ = nullptr;
  VectorXd lengths_;
  VectorXd r_1_, r_2_, dx_, dlambda_;
  VectorXd p_, p_lambda_, Mp_, off_, off_lambda_;  ///< of the conjugate gradients
  std::vector<Progress> progress_;                 ///< of each connected component, as are these:
  VectorXd free_motion_;                           ///< size of M^-1 a, bodies without mass left out
  VectorXd of_heaviest_;                           ///< the largest force over the largest mass
  VectorXd sizes_, corrections_, restored_, descents_, curvatures_, factors_, anew_;
};

}  // namespace linkwork
