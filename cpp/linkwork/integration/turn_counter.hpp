#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/model/joint_coordinates.hpp"

namespace linkwork {

/// How far the angles that joints leave free turn from one recorded frame to the next, where there are steps between:
/// frames tell full turns by the rates at them alone. Each step is taken to turn by nearly the mean of its rates.
class TurnCounter {
 public:
  explicit TurnCounter(const System& system);

  /// From the frame at `before` to the one at `t` [s].
  struct Turned {
    double before, t;
    int joint;
    std::string_view coordinate;
    double angle;  ///< [rad]
  };

  /// The run goes on from this state.
  void pass(double t, const ConstVector& q, const ConstVector& v);
  /// It is recorded; not before the last one from which the run went on.
  void record(double t, const ConstVector& q, const ConstVector& v);

  /// Where the rates at the frames would tell something else, or not for sure. No more than some ten thousand.
  const std::vector<Turned>& found() const { return found_; }

 private:
  struct State {
    double angle = 0.0, rate = 0.0;  ///< [rad] over full turns, [rad/s]
  };
  struct Angle {
    int joint;
    const FreeCoordinate* coordinate;
    State passed, recorded;
  };

  State at(const Angle& angle, double t, const ConstVector& q, const ConstVector& v) const;

  const System& system_;
  std::vector<Angle> angles_;
  double passed_ = NAN, recorded_ = NAN;  ///< when [s]
  std::vector<Turned> found_;
};

}  // namespace linkwork
