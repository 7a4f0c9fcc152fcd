#pragma once

#include <optional>
#include <vector>

#include "linkwork/formulation/projection.hpp"
#include "linkwork/integration/gauss_collocation.hpp"

namespace linkwork {

/// A step by collocation, with everything in between.
struct Leap {
  double t = 0.0, h = 0.0;
  VectorXd y;       ///< at t, on the constraints
  VectorXd y_new;   ///< at t + h, on the constraints
  MatrixXd k;       ///< y_dot at the nodes
  MatrixXd lambda;  ///< multipliers at the nodes

  double end() const { return t + h; }
  bool covers(double time) const { return time <= t + h * (1.0 + 1e-12); }
};

/// Takes a run through singular poses.
///
/// Where branches of motion cross, the constraint matrix loses rank: a state that violates the constraints by delta has
/// accelerations wrong by delta / sigma, sigma the smallest singular value, and the stages of explicit steps violate
/// them by about h^2. On the branch itself the motion is smooth. So the pose is foreseen from the smallest pivot, which
/// falls like the square of the time to it, and taken in one leap by Gauss collocation whose nodes stand on the
/// constraints, Phi = 0 and D v + Phi_t = 0, and around the pose: none nearer than about an eighth of the leap. The leap
/// has a size of its own, some hundredths of a radian, that does not shrink with the step of the run: the errors that
/// roundoff makes grow with 1 / sigma^2.
class Crossing {
 public:
  explicit Crossing(Dynamics& dynamics);

  /// Before a step of size h from (t, y), where `dynamics` is evaluated: whether a pose may be too near for it.
  bool due(double t, double h, const VectorXd& y);

  /// Tries to leap from (t, y) over the pose that is due, to t + k `grid`, k whole, or anywhere where that is 0, but not
  /// beyond t + `most`. Leaves `dynamics` evaluated somewhere else.
  bool leap(double t, double h, double grid, double most, const VectorXd& y);

  const Leap& last() const { return leap_; }
  /// The state at a time inside of the last leap, with unit Euler parameters.
  void interpolate(double t, VectorXd& y) const;
  /// Accelerations and multipliers there.
  void interpolate(double t, MutableVector v_dot, MutableVector lambda) const;

 private:
  static constexpr int stages = GaussCollocation::stages;

  struct Quality {
    bool converged = false;
    double correction = 0.0;  ///< of the nodes by the constraints [rad, or relative to the length]
    double resolution = 0.0;  ///< what the polynomials do not resolve of the velocities, relative to them
    double energy = 0.0;      ///< that is missing at the end, relative to the kinetic energy
    double nearest = 0.0;     ///< root of the smallest pivot of the nodes
    bool good() const;
    bool fair() const;
    double badness() const;
  };

  double foreseen(double t) const;
  double longest(const VectorXd& y) const;
  bool falls_at(double t, double tau, const VectorXd& y);
  Quality attempt(double t, double h, const VectorXd& y);
  bool iterate();
  double node(int i);
  void finish(Quality& quality);
  double energy(const VectorXd& y) const;
  double best_length(double pose, double grid, double least, double most) const;
  double place_of_pose() const;
  bool report();
  double size(const ConstVector& velocities) const;

  Dynamics& dynamics_;
  Projection projection_;
  GaussCollocation gauss_;
  std::vector<char> in_loops_;  ///< bodies
  double length_ = 1.0;         ///< of the mechanism
  bool prepared_ = false;
  double declined_ = 0.0;       ///< root of the pivot at which there was nothing to leap over
  Leap leap_;
  GaussCollocation::Weights root_;  ///< of the smallest pivots at the nodes
  double correction_ = 0.0;
  double energy_before_ = 0.0;
  VectorXd y_, v_dot_, rates_;
};

}  // namespace linkwork
