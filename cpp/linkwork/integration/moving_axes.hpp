#pragma once

#include <vector>

#include "linkwork/integration/step_sampling.hpp"

namespace linkwork {

/// Axes in uniform translation, which move with a mechanism as a whole. Mechanics is the same in them (Galilei), so that
/// errors are to be weighed by the motion that is seen there: a platform at 7 km/s under a vibration says nothing about
/// it.
struct MovingAxes {
  double t = 0.0;                                ///< when they coincide with those of the ground [s]
  Vec3<double> velocity = Vec3<double>::Zero();  ///< m/s

  /// With the mean velocity that the center of mass of all bodies has in a run of which these steps are known. In a
  /// motion that repeats itself on the ground that is almost none.
  static MovingAxes of(const System& system, const std::vector<const KeptStep*>& steps);
  /// With the velocity that it has where this step begins.
  static MovingAxes at_start(const System& system, const KeptStep& step);

  /// y = (q, v, ...) at `at`, as these axes see it.
  void see(double at, VectorXd& y) const { move(at, -1.0, y); }
  /// And back.
  void carry(double at, VectorXd& y) const { move(at, 1.0, y); }

 private:
  void move(double at, double sign, VectorXd& y) const;
};

}  // namespace linkwork
