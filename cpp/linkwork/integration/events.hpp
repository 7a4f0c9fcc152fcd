#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "linkwork/integration/interpolant.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork {

/// The state y = (q, v) after an event.
struct Changed {
  VectorXd y;
  bool ends = false;  ///< the run
};

/// What happens when a function of the state passes through zero. States are y = (q, v).
struct Event {
  std::string name;
  std::function<double(double t, const VectorXd& y)> function;
  int direction = 0;                                           ///< 1: rising, -1: falling, 0: both
  bool terminal = false;                                       ///< ends the run
  std::function<Changed(double t, const VectorXd& y)> change;  ///< empty: the state stays the same
  /// Within which events come together [s], beside roundoff; none: EventWatch chooses it.
  std::optional<double> tolerance = {};

  bool stops() const { return terminal || change; }  ///< ends the step
};

/// At a moment [J]; NaN: not known.
struct Energies {
  double work = NAN, kinetic = NAN, potential = NAN;
};

/// On both sides of an event that came.
struct EnergiesAround {
  Energies before, after;
};

/// An event that came: when [s], and the states y = (q, v) before and after it.
struct Occurrence {
  std::size_t event;
  double t;
  VectorXd before, after;
  EnergiesAround energies = {};
};

/// An event that came just when a motion begins: the state y = (q, v) before it.
struct Happened {
  std::size_t event;
  VectorXd before;
};

/// An event that came before a run is resumed [s].
struct Listed {
  std::size_t event;
  double t;
};

/// Finds the events of a step from the signs of their functions at its end and at three places inside; after an event
/// that ended a step also at places ever nearer to the start, where what came back at once can be seen to leave and to
/// return. A value of zero has no sign: what is zero at the start begins to count when it has become positive or
/// negative.
///
/// After an event that changed the state the sign is not known either, its function is zero up to roundoff, unless the
/// change was a barrier, which stopped or turned back the motion through zero, or took it elsewhere. After a barrier the
/// sign is that of the side from which the motion came, and to be on the other side is the same event again; a bounce
/// too small to be seen is not lost. Where an event is found the motion is as far off the constraints as tolerances let
/// it be, and with the change it comes back to them, by which functions may move to either side: what is no larger
/// than that, their drift, counts as zero until the motion has left it. Other events whose functions are as near to zero
/// have the sign from which they came. How fast functions change is asked by moving q and v along the motion.
///
/// Events as little later as the tolerance of their times come with it: 1e-12 s, or 1e-9 of the longest step where that
/// is less, as in motions of nanoseconds.
class EventWatch {
 public:
  /// OptionError: an event without a function, with a direction other than -1, 0, 1, or a negative tolerance.
  explicit EventWatch(std::vector<Event> events);

  struct Found {
    std::size_t event;
    double theta;  ///< place in the step, 0 to 1
    double side;   ///< 1 or -1: the sign after it
  };

  bool empty() const { return events_.empty(); }
  const Event& event(std::size_t index) const { return events_[index]; }
  /// The next step is about so long [s].
  void expect(double step) { longest_ = std::max(longest_, step); }
  /// How exactly the time of an event is found, beside roundoff [s].
  double resolution(std::size_t index) const;

  /// Takes the signs at (t, y), y = (q, v, work), where a motion begins: there the last event may have been, so that what
  /// is zero up to roundoff has none.
  void start(const System& system, double t, const VectorXd& y);
  /// The same where these events have come at t, with states before them, of a motion that goes on there with y_dot.
  void start_after(const System& system, double t, const VectorXd& y, const VectorXd& y_dot,
                   const std::vector<Happened>& happened);
  /// What `restart` needs of the motion up to the events that were found: y_dot.
  void approach(const VectorXd& y_dot) { y_dot_ = y_dot; }
  /// By how much functions move from y, where events were found at t, to `corrected`, which satisfies the constraints.
  void find_drift(const System& system, double t, const VectorXd& y, const VectorXd& corrected);
  /// The same as `start` after events that have changed the state at t from `before` to y.
  void restart(const System& system, double t, const VectorXd& before, const VectorXd& y,
               const std::vector<Found>& happened);
  /// The events of the step from t to t + h in order of time, none after the first that ends the step but those that
  /// come with it. `last`: of the run, at whose end zero counts as having been passed.
  const std::vector<Found>& scan(const Interpolant& step, const System& system, double t, double h, bool last = false);

  /// Between steps.
  void keep(Archive& archive) { archive(last_value_, fresh_, barrier_t_, left_t_, zero_, stayed_, longest_); }

 private:
  void take_signs(double t, const VectorXd& y);
  double value(std::size_t index, double t, const VectorXd& y);
  double change_along(const System& system, std::size_t index, double t, const VectorXd& y, double& s);
  double rate(const System& system, std::size_t index, double t, const VectorXd& y);
  double change_in_time(const System& system, std::size_t index, double t, const VectorXd& y, double dt);
  double as_located(const System& system, std::size_t index, double t, const VectorXd& y);
  void restart_happened(const System& system, double t, const VectorXd& before, const VectorXd& y,
                        const Found& happened);
  void restart_other(const System& system, std::size_t k, double t, const VectorXd& before, double last_value);
  double tolerance(std::size_t index) const;
  double resolved(std::size_t index, double t) const;
  double found_within(std::size_t index, double t) const;
  double rounding(const System& system, std::size_t index, double t, const VectorXd& y);
  bool is_zero(const System& system, std::size_t index, double t, const VectorXd& y);
  bool end_at_stop(std::size_t first, double t, double h);
  void scan_piece(const Interpolant& step, const System& system, double t, double h, double from, double to, bool last);

  std::vector<Event> events_;
  std::vector<double> last_value_, last_theta_;  ///< of the last sample that was not zero
  std::vector<Found> found_;
  double longest_ = 0.0;           ///< step so far [s]
  bool fresh_ = false;             ///< an event has just ended a step
  std::vector<double> barrier_t_;  ///< when it came, of the last events that ended a step, if the change was a barrier
  std::vector<double> left_t_;     ///< until when what the barrier turned back may still be there
  std::vector<double> zero_;       ///< what is no larger has no sign, until the function has left it
  std::vector<double> drift_;      ///< of the events that are found now
  std::vector<char> stayed_;       ///< nothing has left the last barrier
  VectorXd state_, q_and_v_, y_dot_;
};

}  // namespace linkwork
