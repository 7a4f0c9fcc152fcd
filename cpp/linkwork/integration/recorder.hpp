#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/turn_counter.hpp"

namespace linkwork {

/// Recorded states, one after the other (frame by frame).
struct Frames {
  std::vector<double> t;
  std::vector<double> q, v, v_dot, lambda;  ///< 7 n, 6 n, 6 n and rows numbers a frame
  std::vector<double> kinetic, potential, work;
  std::vector<double> violation;  ///< 3 a frame: max |Phi|, max |Phi_dot|, max |D v_dot - gamma|
  std::vector<double> history;    ///< history variables, see history.hpp
  /// 3 joints each a frame, see System::reactions; none where they are not recorded.
  std::vector<double> reaction_force, reaction_torque;
};

/// Collects frames until somebody takes them.
class Recorder {
 public:
  explicit Recorder(Dynamics& dynamics);

  /// Records the state y at t, where `dynamics` is evaluated. NotFiniteError: no NaN is ever recorded.
  void record(double t, const VectorXd& y);

  /// The same with accelerations and multipliers that are known otherwise.
  void record(double t, const VectorXd& y, const ConstVector& v_dot, const ConstVector& lambda);

  /// The same where a step goes on from this state: in the course of it, without changing a bit of it.
  void record_in_step(double t, const VectorXd& y);
  /// Time of the last frame that nobody has taken; NaN: there is none.
  double last() const { return frames_.t.empty() ? NAN : frames_.t.back(); }
  /// Its accelerations and multipliers are known better now; `dynamics` is evaluated there.
  void correct_last(const VectorXd& y, const ConstVector& v_dot, const ConstVector& lambda);
  /// From here on frames have reactions, which whoever needs them can find later, too, but not for less.
  void record_reactions() { with_reactions_ = true; }
  /// From here on turns of joints between frames are counted. Before the first of them.
  void count_turns() { turns_ = std::make_unique<TurnCounter>(dynamics_.system()); }
  /// The run goes on from the state y at t.
  void pass(double t, const VectorXd& y);
  /// Nothing where they are not counted.
  const TurnCounter* turns() const { return turns_.get(); }
  /// Frames up to t are not kept.
  void silence_until(double t) { silent_until_ = t; }
  /// A frame that waits for a step which will not come.
  void finish();

  std::size_t count() const { return frames_.t.size(); }
  Frames take() { return std::exchange(frames_, {}); }

 private:
  void look_for_interruption() { meter_.add(dynamics_.system().body_count()); }
  void add_reactions(double t, const ConstVector& q, const ConstVector& lambda);

  Dynamics& dynamics_;
  std::shared_ptr<char> here_ = std::make_shared<char>();  ///< `dynamics` may outlive what it was asked to call
  bool with_reactions_ = false;
  std::unique_ptr<TurnCounter> turns_;
  std::unique_ptr<Evaluation> anew_;  ///< of reactions that the evaluation of the dynamics does not tell
  double silent_until_ = -INFINITY;
  double waiting_t_ = 0.0;
  VectorXd waiting_y_;
  VectorXd v_dot_, lambda_, residual_;
  InterruptionMeter meter_;
  Frames frames_;
};

}  // namespace linkwork
