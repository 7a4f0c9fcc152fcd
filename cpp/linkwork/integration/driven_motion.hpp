#pragma once

#include <chrono>
#include <random>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/turn_counter.hpp"
#include "linkwork/linear/sparse_lu.hpp"

namespace linkwork {

/// What a step from one pose to the next may be, and when a pose counts as found. Sizes are parts of the mechanism's.
struct DrivenLimits {
  double longest_step = 0.2;        ///< that the predictor may move a body [rad, sizes]
  double largest_correction = 0.1;  ///< of the predicted pose, as a part of the step
  double fastest_end = 0.8;         ///< by its velocity at the end: a step that seems short may go once round
  double converged = 1e-14;         ///< corrections at which Newton's method ends
  double rounding = 1e-11;          ///< corrections that may be rounding
  int iterations = 30;
  double closed = 1e-10;        ///< violations of redundant joints in a pose where all hold
  double regular = 1e-4;        ///< the smallest singular value of a pose that is far from singular
  double balanced = 1e-9;       ///< forces that multipliers may leave, as a part of theirs
  double shortest_part = 1e-6;  ///< of the time to the next frame that a step may take
  double touch_part = 1e-9;  ///< the same of the step in which a contact begins: its force depends on the speed there
};

/// Frame after frame of a driven motion.
struct DrivenFrames {
  int count = 0;
  bool paused = false;  ///< the time was over on the way to the next one
  std::vector<double> t, q, v, v_dot, lambda, history, potential, power, violation;
  std::int64_t steps = 0, evaluations = 0, factorizations = 0;
};

struct DrivenState {
  double t = 0.0;
  VectorXd q, v, v_dot, history;
};

/// D by compressed columns.
struct SparsePattern {
  explicit SparsePattern(const System& system);
  std::vector<int> begin, row, column;
  std::vector<std::ptrdiff_t> source;  ///< of each entry: its place in Evaluation::D
};

/// The motion of a mechanism whose freedoms drivers fix, away from singular poses: Phi(q, t) = 0 by Newton's method
/// from the pose that velocity and acceleration predict, D v = -Phi_t, D v_dot = gamma, and the multipliers of
/// M v_dot - D^T lambda = g.
///
/// D is scaled: its columns of rotations by `length`, each row to length 1. Where its smallest singular value comes
/// below `regular` of `unit`, where it or the determinant changes its sign, or where a step is not to be trusted, nothing
/// is decided: `follow` ends before that frame.
class DrivenMotion {
 public:
  /// `length` is the size of the mechanism [m], `row_lengths` (m) what residuals are relative to, `rounding` that of
  /// positions, `unit` what counts as a singular value of 1. Turns are counted from one to another of the times
  /// `recorded`, which increase: other frames serve whoever asks for them only.
  DrivenMotion(Dynamics& dynamics, double length, VectorXd row_lengths, double rounding, double unit,
               std::vector<double> recorded);

  /// From the pose on the constraints at t = 0 to which q leads. False: there is none, or it is singular, or nearly so.
  bool start(const ConstVector& q, const ConstVector& history);
  /// From a state on the constraints. False: it is singular, or nearly so.
  bool begin(double t, const ConstVector& q, const ConstVector& v, const ConstVector& v_dot,
             const ConstVector& history);
  /// Frames at `times`, as many as there are before something unusual, and until `seconds` are over, also on the way to
  /// one. After something unusual it has to `begin` again.
  DrivenFrames follow(const std::vector<double>& times, double seconds);
  /// Where it has come.
  const DrivenState& state() const { return now_; }
  /// How far joints turned between frames.
  const TurnCounter& turns() const { return turns_; }
  /// Somebody else has taken a step to this state.
  void pass(double t, const ConstVector& q, const ConstVector& v) { turns_.pass(t, q, v); }
  /// And has made a frame of it.
  void record_turns(double t, const ConstVector& q, const ConstVector& v);

 private:
  enum class Step { taken, refused, touches };  ///< `touches`: it is not taken, as a contact begins in it

  bool try_frame(double t, DrivenFrames& out);
  bool go_to(double t, bool& paused);
  bool time_is_over() const { return std::chrono::steady_clock::now() > ends_; }
  bool touch(double t, double soon);
  Step step(double t, double soon);
  bool foreseen(double h, double largest_correction);
  VectorXd predicted(double h) const;
  bool correct(double t, VectorXd& q, double largest);
  void evaluate_at_rest(double t, const VectorXd& q);
  bool closed() const;
  void complete(DrivenState& next);
  bool same_side(int sign_before, int pivots_before);
  void scale(const Evaluation& at);
  bool factorize(const Evaluation& at);
  bool regular(int iterations, VectorXd& left);
  bool choose_pivots(const Evaluation& at);
  bool begins_regular();
  void solve(const VectorXd& residual, VectorXd& x);
  void reduce(const VectorXd& b, VectorXd& x);
  double reach(const VectorXd& x) const;
  bool add_frame(DrivenFrames& out);
  bool find_multipliers(VectorXd& lambda);
  bool shared_multipliers(const VectorXd& force, VectorXd& lambda);

  Dynamics& dynamics_;
  const System& system_;
  DrivenLimits limits_;
  double length_, rounding_, unit_;
  VectorXd row_lengths_;
  SparsePattern pattern_;
  SparseLu lu_;
  int pivots_ = 0;  ///< how often they have been chosen
  std::vector<double> values_;
  VectorXd row_scale_, column_scale_;
  DrivenState now_;
  TurnCounter turns_;
  std::vector<double> recorded_;
  Evaluation here_, there_;  ///< where the mechanism is, and at what a step tries
  VectorXd right_, left_;    ///< singular vectors of the smallest singular value, D^T left = sigma right
  VectorXd rest_, b_, dx_;
  std::chrono::steady_clock::time_point ends_;
  std::minstd_rand random_;
  std::int64_t steps_ = 0, evaluations_ = 0, factorizations_ = 0;
};

}  // namespace linkwork
