#pragma once

#include <optional>
#include <string>
#include <vector>

#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/integration/collocation_step.hpp"
#include "linkwork/integration/departure.hpp"
#include "linkwork/integration/interpolant.hpp"
#include "linkwork/integration/passage.hpp"
#include "linkwork/integration/recorder.hpp"
#include "linkwork/integration/resolved_motion.hpp"
#include "linkwork/integration/singular_pose_search.hpp"
#include "linkwork/integration/touch_search.hpp"

namespace linkwork {

/// How fast the bodies of a mechanism move; rotations of rotors about their axes do not count.
struct Speeds {
  double linear = 0.0, angular = 0.0;  ///< the largest components of bodies in loops [m/s, rad/s]
  double outside[2]{}, inside[2]{};    ///< the largest squares of both, of bodies outside of loops and in them
  bool none() const { return outside[0] + outside[1] + inside[0] + inside[1] == 0.0; }
};

/// Who brings `dynamics` to the state that is looked at, which it gives: where it is needed at all.
class Arrival {
 public:
  virtual ~Arrival() = default;
  virtual const VectorXd& arrive() = 0;
  /// The least singular value there, if it is found without that; of which the watch has heard then.
  virtual std::optional<double> least_singular_value() { return {}; }
};

/// Takes a run through singular poses.
///
/// Where branches of motion cross, the constraint matrix loses rank: a state that violates the constraints by delta has
/// accelerations wrong by delta / sigma, sigma the smallest singular value, and the stages of explicit steps violate
/// them by about h^2. On the branch itself the motion is smooth. So the pose is foreseen, and taken in one leap by
/// Gauss collocation whose nodes stand on the constraints and around the pose: none nearer than some hundredths of the
/// leap. The leap has a size of its own, some hundredths of a radian, that does not shrink with the step of the run:
/// the errors that roundoff makes grow with 1 / sigma^2.
///
/// Forces of contacts and stops are not smooth where these begin or end: a leap ends before that, and where it would be
/// too short for a leap there is none. Usual steps end there.
///
/// Two signs tell the pose: the smallest pivot of every factorization, which falls like the square of the time to it,
/// and sigma itself, which falls linearly and is looked at now and then. Pivots hide a pose where the order of
/// elimination is to blame, sigma one that is local to a part of a large mechanism.
class Crossing final : public Interpolant {
 public:
  explicit Crossing(Dynamics& dynamics);
  ~Crossing() override { dynamics_.formulation().watch().list_evaluations(true); }
  Crossing(const Crossing&) = delete;
  Crossing& operator=(const Crossing&) = delete;

  /// Whether there are loops, in which poses can be singular.
  bool watches() const { return prepared_; }
  /// Before a step of size h from (t, y), where `dynamics` is evaluated: whether a pose may be too near for it.
  bool due(double t, double h, const VectorXd& y, bool adaptive);
  /// The same where somebody else knows the speeds, and `dynamics` need not be evaluated there; it is where the answer
  /// is true.
  bool due(double t, double h, const Speeds& speeds, bool adaptive, Arrival& state);
  const std::vector<char>& in_loops() const { return in_loops_; }  ///< one a body; empty where nothing is watched
  const Eigen::Matrix3Xd& rotors() const { return step_.rotors(); }
  /// Somebody, such as a function of an event, looks at how far rotors turn: leaps are short enough to tell.
  void watch_rotors() { step_.watch_rotors(); }
  /// For an adaptive step where none is due: to where a leap over the pose ahead begins well.
  double most_step() const { return most_step_; }
  /// After an adaptive step h from t, where `dynamics` is evaluated at its end: a shorter one, where that is beside a
  /// pose that was not foreseen, as its stages were off the branch where that counts; else infinite.
  double shorter_step(double t, double h);
  /// After a change of the state: it may be near a pose without a trend that tells.
  void restart() {
    fresh_ = true;
    known_ = -INFINITY;
    forget_looks();
    passage_.forget();
    poses_.restart();
  }

  /// Tries to leap from (t, y) over the pose that is due, to t + k `grid`, k whole, or anywhere where that is 0, but
  /// not beyond t + `most`: the time until something is not smooth, or until the end of the run where what acts may not
  /// be known beyond it. Leaves `dynamics` evaluated somewhere else.
  bool leap(double t, double h, double grid, double most, const VectorXd& y);
  /// The run ends in the leap, after `length`.
  void cut(double length);
  /// Whether `most` has had a say in a leap, or in that there is none.
  bool limited() const { return limited_; }

  // Poses that were passed are listed.
  // True, or nothing: `dynamics` was evaluated somewhere else.
  /// After a usual step h from (t, y).
  bool look_back(double t, double h, const VectorXd& y);
  /// After a leap, of which the motion follows the part before `until`.
  void look_into_leap(double until);
  /// At the end of the motion, or of a part of it.
  bool end(double t, const VectorXd& y);

  const Leap& last() const { return leap_; }
  double theta(double t) const { return (t - leap_.t) / leap_.followed; }
  /// Between steps; `leaping`: in or at the end of the last leap.
  void keep(Archive& archive, bool leaping);

  /// The state in what is followed of the last leap, with unit Euler parameters.
  void interpolate(const System& system, double theta, VectorXd& y) const override;
  /// The same on the constraints, unless a pose is too near. Leaves `dynamics` evaluated somewhere else.
  void place(double theta, VectorXd& y);
  /// A frame at t of the state y where the last leap begins: on the constraints; in or beside a pose, where equations
  /// tell little of what goes on, by the leap. Leaves `dynamics` evaluated somewhere else.
  void correct_frame(Recorder& recorder, double t, const VectorXd& y);
  /// The last frame of a run, of the state y at t, beside a pose on the constraints. True where `dynamics` was evaluated
  /// somewhere else.
  bool correct_last_frame(Recorder& recorder, double t, const VectorXd& y);
  /// Accelerations and multipliers at `at` in a usual step h from t, where `dynamics` is evaluated; false: its
  /// equations tell them, no pose is near.
  bool accelerations_beside(const Interpolant& step, double t, double h, double at, MutableVector v_dot,
                            MutableVector lambda);
  /// Accelerations and multipliers there.
  void interpolate(double theta, MutableVector v_dot, MutableVector lambda) const;

 private:
  static constexpr double reach = 0.14;        ///< of a leap [rad]: what the fastest body of the loops turns
  static constexpr double before_pose = 0.3;   ///< of a leap: where adaptive steps end before the pose
  static constexpr double least_beside = 0.4;  ///< of a usual leap: shorter ones beside the pose are not worth it
  static constexpr double solvable = 1e-2;     ///< of the usual root: nearer to a pose, forces are of few digits
  static constexpr double margin = 0.06;       ///< least distance of nodes from the pose, relative to the leap

  /// For a length with which the nodes are clear of the poses. Times in s, from the start of the leap.
  struct Search {
    double t, grid, most;
    double usual;               ///< length for a smooth motion
    std::vector<double> poses;  ///< foreseen, then found
    double least;               ///< length to begin with
    Leap best = {};
    double error = INFINITY;                         ///< of it
    double base = 0.0;                               ///< of other lengths
    std::vector<std::pair<double, int>> tried = {};  ///< lengths, with the node left out
    double too_far = INFINITY;                       ///< a pose
    double smooth = INFINITY;                        ///< up to where a contact or a stop begins or ends, at most
    int failures = 0;                                ///< since the last that converged
    bool ahead = false, done = false;
  };

  bool is_due_by(double t, double h, const Speeds& speeds, bool adaptive, Arrival& state);
  void look(double t, Arrival& state);
  double least_singular_value(Arrival& state);
  bool rows_turn_bad(double small, double measure, double& highest, Arrival& state);
  void forget_looks();
  double pivots_say(double t);
  double looks_say(double t);
  double time_to_pose(double t);
  static bool declined_before(double value, double& declined);
  bool starts_near(double t, const VectorXd& y);
  bool pivot_changes(double t, const VectorXd& y, double root);
  bool in_singular_pose(double t, const VectorXd& y);
  void depart(double t, const VectorXd& y);
  void begin_unwatched(double t, const VectorXd& y);
  double usual_length(const ConstVector& v, const ConstVector& v_dot) const;
  // Without accelerations.
  double usual_length(const Speeds& speeds) const;
  double usual_length(const ConstVector& v) const { return usual_length(speeds(v)); }
  bool beside_a_pose(double time) const;
  bool near_pose(double part);
  bool tell(const Interpolant& step, double t, double h, double time, VectorXd& v_dot, VectorXd& lambda);
  bool tell_on_constraints(double time, VectorXd& v_dot, VectorXd& lambda);
  bool tells_forces() const;
  enum class ForcesBeside { none, unsure, sure };
  ForcesBeside between_forces_beside(const Interpolant& step, double t, double h, double at, VectorXd& v_dot,
                                     VectorXd& lambda);
  [[noreturn]] void throw_no_branch(double t) const;
  [[noreturn]] void throw_not_left(double t) const;
  [[noreturn]] void throw_several_motions(double t) const;
  [[noreturn]] void throw_no_motion(double t) const;
  [[noreturn]] void throw_in_this_pose(double t, const char* code, const std::string& does, const std::string& why,
                                       const std::string& where = "in") const;
  void keep_rows_good(Arrival& state);
  Speeds speeds(const ConstVector& v) const;
  double largest_rate(const Speeds& speeds) const;
  double largest_rate(const ConstVector& v) const { return largest_rate(speeds(v)); }
  int parts_to(double t) const;
  bool leap_beside(double most, double usual);
  bool try_lengths(Search& search);
  void weigh(Search& search, CollocationStep::Quality quality);
  double switches_in_leap();
  bool stays_before_switches(Search& search);
  double near_enough(double usual, double h, bool adaptive) const;
  bool weaker_than_usual() const;
  double nearest_node(const std::vector<double>& poses, double h, int left_out = CollocationStep::none) const;
  int node_in_pose(const Search& search, double h) const;
  bool starts_with_node_in_pose(const Search& search, double h) const;
  VectorXd of_loops(const ConstVector& v) const;
  void check_passage(double t, Arrival& state);
  void begin_passage(double t, const VectorXd& y, double ahead);
  void compare_with_motion(double t, const VectorXd& v);
  [[noreturn]] void throw_left_branch(double t, const ResolvedMotion& motion, bool resolved);
  double best_length(const Search& search);
  double limit(const Search& search, double h);
  double allowed_length(const Search& search, double h);
  std::vector<double> poses_in_leap(double beyond_it);
  bool look_ahead(Search& search);

  Dynamics& dynamics_;
  CollocationStep step_;
  Leap& leap_ = step_.leap();
  SingularPoseSearch poses_;
  TouchSearch touches_;
  std::vector<char> in_loops_;  ///< bodies
  bool prepared_ = false;
  bool starting_ = false;    ///< the leap begins near the pose, not before it
  bool in_pose_ = false;     ///< or in it
  std::vector<int> joints_;  ///< whose equations depend on each other there
  VectorXd departing_;       ///< accelerations there
  Passage passage_;          ///< of usual steps
  bool decided_ = false;     ///< by velocities
  bool stepped_in_ = false;  ///< it begins in one that a step of the run ends in
  bool fresh_ = true;        ///< no step was looked at yet
  bool limited_ = false;
  bool approached_ = false, leaves_ = false;  ///< a leap beside the pose: there was one before it; is to be, after it
  double beside_ = 0.0;                       ///< length of the one that is due, else 0
  SingularValueAt least_ = {};                ///< singular value, when it was looked at last
  SingularValueAt ended_ = {};                ///< the same, where the last step that was tried ends
  double falls_to_ = INFINITY;                ///< time of the pose to which it falls
  double next_look_ = 0.0;                    ///< at it, when the fastest body has turned so far since [rad]
  double turned_ = 0.0, turned_until_ = 0.0;
  double highest_ = 0.0, highest_root_ = 0.0;          ///< of it and of pivots, since the redundant rows were looked at
  double declined_least_ = 0.0, declined_root_ = 0.0;  ///< at which there was nothing to leap over
  double most_step_ = INFINITY;
  double fastest_ = 0.0;      ///< motion before the step [rad/s]
  double known_ = -INFINITY;  ///< time of a pose that a leap found too far ahead
  double known_rate_ = 0.0;   ///< `fastest_` when it was found
  VectorXd y_;
};

}  // namespace linkwork
