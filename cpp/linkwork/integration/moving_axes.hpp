#pragma once

#include <vector>

#include "linkwork/integration/step_sampling.hpp"

namespace linkwork {

/// Axes in uniform translation, which move with each connected part of a mechanism as a whole: with the bodies that
/// joints and forces connect, the ground connects nothing. Mechanics is the same in them (Galilei), so that errors are
/// to be weighed by the motion that is seen there: a platform at 7 km/s under a vibration says nothing about it, nor
/// does what else there is beside it.
struct MovingAxes {
  double t = 0.0;             ///< when they coincide with those of the ground [s]
  std::vector<int> part;      ///< of each body; none: all are seen from the ground
  Eigen::Matrix3Xd velocity;  ///< of the axes of each part [m/s]

  /// With the mean velocity that the center of mass of each part has in a run of which these steps are known. In a
  /// motion that repeats itself on the ground that is almost none.
  static MovingAxes of(const System& system, const std::vector<const KeptStep*>& steps);
  /// With the velocity that it has where this step begins.
  static MovingAxes at_start(const System& system, const KeptStep& step);

  /// y = (q, v, ...) at `at`, as these axes see it.
  void see(double at, VectorXd& y) const { move(at, -1.0, y); }
  /// And back.
  void carry(double at, VectorXd& y) const { move(at, 1.0, y); }
  /// Diagonal of the box around the centers of mass of each part at the ends of these steps, as these axes see them
  /// [m].
  VectorXd diagonals(const std::vector<const KeptStep*>& steps) const;

 private:
  void move(double at, double sign, VectorXd& y) const;
};

}  // namespace linkwork
