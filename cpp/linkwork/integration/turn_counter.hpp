#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/model/joint_coordinates.hpp"

namespace linkwork {

/// How far the angles that joints leave free turn from one recorded frame to the next, where there are steps between:
/// frames tell full turns by the rates at them alone. States are looked at before the fastest body may have turned by a
/// radian since the last look, so that each angle goes on to the nearest one; in a longer step it turns by nearly the
/// mean of its rates. None is looked at between frames that are too near for any doubt.
class TurnCounter {
 public:
  explicit TurnCounter(const System& system);

  /// From the frame at `before` to the one at `t` [s].
  struct Turned {
    double before, t;
    int joint;
    std::string_view coordinate;
    double angle;  ///< [rad]; NaN: there were steps too long to tell
  };

  struct State {
    double angle = 0.0, rate = 0.0;  ///< [rad] over full turns, [rad/s]
  };
  struct Angle {
    int joint;
    const FreeCoordinate* coordinate;
    State at_frame = {}, last = {};
    bool sure = true;  ///< since the frame
  };
  struct Passed {
    double t = NAN;
    VectorXd q, v;
    double fastest = 0.0;  ///< rate of a body [rad/s]
  };

  /// The run goes on from this state.
  void pass(double t, const ConstVector& q, const ConstVector& v);
  /// It is recorded; not before the last one from which the run went on.
  void record(double t, const ConstVector& q, const ConstVector& v);

  /// Where the rates at the frames would tell something else, or not for sure.
  const std::vector<Turned>& found() const { return found_; }

  /// From the last frame to the last state.
  struct Way {
    Passed frame, last;
    std::vector<Angle> angles;
    double looked_at = NAN;                      ///< when, since the frame [s]
    bool looked = false, kept = false;           ///< whether at the last state; whether its q and v are kept
    double since_frame = 0.0, since_look = 0.0;  ///< by which any angle may have turned [rad]
  };
  const Way& way() const { return way_; }
  /// The run goes on from where it was then; no frame was recorded since.
  void go_back(const Way& way) { way_ = way; }

 private:
  bool is_first() const { return std::isnan(way_.frame.t); }  ///< there is no frame yet
  void advance(double t, const ConstVector& q, const ConstVector& v);
  void look(double t, const ConstVector& q, const ConstVector& v);
  static void follow_long_step(double h, Angle& angle, State& now);
  State state(const Angle& angle, const ConstVector& q, const ConstVector& v) const;
  void compare();
  double fastest(const ConstVector& v) const;

  const System& system_;
  Way way_;
  std::vector<Turned> found_;
};

}  // namespace linkwork
