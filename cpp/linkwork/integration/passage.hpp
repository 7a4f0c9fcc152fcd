#pragma once

#include <utility>

#include "linkwork/math/archive.hpp"
#include "linkwork/math/types.hpp"

namespace linkwork {

/// Usual steps near a singular pose, over which no leap was found: whether they stay on the branch.
///
/// Along a branch velocities change by what it bends, little over some hundredths of a radian, and by accelerations.
/// What local errors took to another branch has accelerations of that one: the earlier velocities are none of theirs.
/// So it is where the motion itself bends beside a pose: ResolvedMotion tells one from the other.
class Passage {
 public:
  /// At a state y with velocities v of the bodies in loops; the pose is some `ahead` [rad]. The first counts.
  void begin(double t, const VectorXd& y, const VectorXd& v, double ahead);
  /// To t, at a rate [rad/s].
  void go_on(double t, double rate) { turned_ += rate * (t - std::exchange(t_, t)); }
  void forget() { y_.resize(0); }
  bool open() const { return y_.size() > 0; }
  bool over() const { return open() && turned_ > until_; }
  /// With velocities and accelerations after it.
  bool left_branch(const VectorXd& v, const VectorXd& v_dot) const;
  /// Whether velocities that should be the same are those of different branches.
  static bool differ(const VectorXd& v, const VectorXd& other_v);
  double begun() const { return begun_; }  ///< [s]
  const VectorXd& y() const { return y_; }

  void keep(Archive& archive) { archive(y_, v_, begun_, t_, turned_, until_); }

 private:
  VectorXd y_, v_;
  double begun_ = 0.0, t_ = 0.0, turned_ = 0.0, until_ = 0.0;  ///< [s], [rad]
};

}  // namespace linkwork
