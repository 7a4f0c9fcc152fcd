#pragma once

#include <cstdint>
#include <vector>

#include "linkwork/integration/touch_search.hpp"

namespace linkwork {

/// A contact or a stop whose bodies pass through each other, as steps are too long for their speed.
struct PassedTouch {
  int which;      ///< switch
  double t;       ///< begin of the first such step [s]
  double until;   ///< end of the last
  double speed;   ///< largest at which they came nearer [m/s or rad/s]
  double change;  ///< of velocities, relative to them, that its force would make on the way through, in all steps
  std::int64_t steps;
};

/// Tells where fixed steps, which cannot end there, go over contacts and stops, see TouchSearch.
class TouchMonitor {
 public:
  explicit TouchMonitor(const Dynamics& dynamics) : dynamics_(dynamics), search_(dynamics, 0.0) {}

  /// Of the step of h from (t, y) to y_new, where the switches are these.
  void pass(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& switches);
  /// The state at which the next step begins, with these, is not the end of one.
  void restart(const VectorXd& switches);
  const std::vector<PassedTouch>& passed() const { return passed_; }

 private:
  void note(int which, double t, double h, double speed, double change);
  double change(const Interpolant& step, const TouchSearch::Touch& touch, double t, double h) const;

  const Dynamics& dynamics_;
  TouchSearch search_;
  VectorXd now_;  ///< switches where the last step ended
  std::vector<PassedTouch> passed_;
};

}  // namespace linkwork
