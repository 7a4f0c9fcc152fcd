#pragma once

#include "linkwork/integration/collocation_step.hpp"

namespace linkwork {

/// The motion beside a singular pose, resolved where the pose is not in its way.
///
/// The least singular value sigma of the scaled D is about the distance to the pose [rad], and nowhere steeper than
/// some units a radian. A motion that passes at a distance bends there over about that distance: steps by a part of
/// sigma resolve it, however near the pose is. They never come over a pose that is in the way, where sigma is zero and
/// branches of motion meet. Their stages stand on the constraints: what they are off would count by 1 / sigma.
class ResolvedMotion {
 public:
  /// The `step` projects, and tells the speed of the mechanism.
  ResolvedMotion(Dynamics& dynamics, CollocationStep& step) : dynamics_(dynamics), step_(step) {}

  /// From (t, y), taken to the constraints, to t_end. False: a pose is in the way, or something else that such steps do
  /// not resolve. Leaves `dynamics` evaluated somewhere else.
  bool follow(double t, const VectorXd& y, double t_end);
  const VectorXd& y() const { return y_; }  ///< to where it was followed
  /// Whether the pose is in the way.
  bool in_pose() const;
  /// The state on the way that is nearest to the pose.
  double nearest_t() const { return nearest_t_; }
  const VectorXd& nearest_y() const { return nearest_y_; }

 private:
  bool go(double t_end);
  bool step(double h);
  void evaluate(double t, VectorXd& y, VectorXd& rates);
  void note_nearest();
  double usual_step() const;

  Dynamics& dynamics_;
  CollocationStep& step_;
  double t_ = 0.0, sigma_ = 0.0;
  VectorXd y_, rates_;
  double t_new_ = 0.0, sigma_new_ = 0.0;
  VectorXd y_new_, rates_new_, stage_, v_dot_, lambda_;
  double nearest_t_ = 0.0, least_ = 0.0;
  VectorXd nearest_y_;
};

}  // namespace linkwork
