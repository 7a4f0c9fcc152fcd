#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "linkwork/formulation/projection.hpp"
#include "linkwork/integration/embedded_pair.hpp"
#include "linkwork/integration/integrator.hpp"
#include "linkwork/integration/moving_axes.hpp"
#include "linkwork/integration/relative_violation.hpp"
#include "linkwork/integration/step_parts.hpp"
#include "linkwork/integration/step_sampling.hpp"

namespace linkwork {

/// How the steps of a method are taken again: by this integrator in two parts, the first of this share, each of which
/// may be divided likewise, or with a share of 1 at once; and which part of the error is left then in two parts.
/// `pair`, where the run records states inside of steps: by its interpolant, which may be worse than their ends.
struct SecondTake {
  std::unique_ptr<Integrator> integrator;
  double share = 1.0;
  double left = 0.0;
  std::optional<EmbeddedPair> pair = {};
  std::function<void(int)> divide = {};  ///< of an integrator that takes parts by itself: in so many powers of two
  bool staggered = false;                ///< see of_staggered_velocities
};

/// Two parts a h and (1 - a) h by the same one-step method, Richardson (1911): with a local error c h^(p+1) the parts
/// are off by b = a^(p+1) + (1 - a)^(p+1) of it, so it is the difference / (1 - b); in four parts / (1 - b^2). Halves
/// would see a force that oscillates, or a driver that turns, in step with h / 4 as the whole step does, at rest: a is
/// the golden ratio, which is in step with nothing. An order of 0 is one that nobody knows: nothing is then taken to be
/// left.
SecondTake in_parts(std::unique_ptr<Integrator> integrator);
/// A multistep method cannot take its step in parts, nor one of which nobody knows what it is: it is compared with a
/// one-step method in two parts, such as its starter, whose error is small beside its own, from the same state and with
/// the same correction of the violation, apart from the rates. Where a contact begins in eight: at which speed is known
/// where a part ends, whatever the method.
SecondTake by_one_step_method(const ButcherTableau& other, bool corrects = true);

/// Semi-implicit Euler takes the steps of the Stoermer-Verlet method, of order 2, from velocities that are half a step
/// late, Hairer, Lubich and Wanner (2003), Acta Numerica 12, 399-450: with v_n + h/2 v_dot_n instead of v_n the local
/// errors of its steps do not add up to what they seem to, each takes back that of the one before. Steps between such
/// states are compared, and that half a step of velocities counts once, with what it moves.
SecondTake of_staggered_velocities(const ButcherTableau& other);

/// What a step was off by in a connected part, the largest of its bodies or joints, and how large the motion was there.
/// Speeds are those that the judge's axes see, and no rounding of y counts.
struct PartError {
  StateDifference end, inside;  ///< inside: where the first part of the step ends; zero where that was not looked at
  StateDifference fading;       ///< what errors come to that stabilization or forces take back soon; at least what
                                ///< velocities miss the constraints by
  StateDifference late;         ///< what half a step of staggered velocities is
  double force = std::numeric_limits<double>::quiet_NaN();  ///< of reactions [N]; NaN: not looked at
  double torque = force;                                    ///< likewise [N m]
  double change = 0.0;                                      ///< see KeptStep [m/s^2]
  double speed = 0.0;                                       ///< also of turning, by the arm of the part [m/s]
  double body_speed = 0.0;                                  ///< also of turning, by the size of its bodies [m/s]
  double acceleration = 0.0, spin_rate = 0.0;               ///< mean over the step [m/s^2, rad/s^2]
  double largest_force = force, largest_torque = force;     ///< NaN likewise
  double yielded_force = force, yielded_torque = force;     ///< of reactions where constraints yield; NaN likewise
  double load = 0.0;     ///< largest force on a body, or torque by the size of the part; looked at with reactions [N]
  double kinetic = 0.0;  ///< energy [J]
  double energy = 0.0;   ///< made, where that is looked at, see energies_apart [J]
  double in_inerters = 0.0;  ///< kinetic energy, likewise [J]
  bool contact_begins = false;
  double onset = 0.0;  ///< by that of the speed at which it does [m/s], also in that of the velocity
  double rounding = 0.0, displacement = 0.0;  ///< of positions in space, where it is the same in many steps [m]
  double noise = 0.0;                         ///< of velocities, which rounding of positions may be in a step [m/s]
};

/// All of it in the local error of one step alone.
struct StepError {
  double t = 0.0, h = 0.0;
  std::vector<PartError> of_part;  ///< of each of ConnectedParts
  double violation = 0.0;          ///< of positions where the step ended, see RelativeViolation
  double work = 0.0;               ///< up to there, of all forces that have no potential [J]
  bool failed = false;             ///< it could not be taken again in parts: nothing else but t and h is known
};

/// Where a step ends in parts.
struct RetakenStep {
  VectorXd end;                 ///< empty where that has to be found
  bool rows_change = false;     ///< other rows were left out before: its first stage is factorized ahead
  double smallest_pivot = 0.0;  ///< of all factorizations on the way
};

/// Takes steps again. `dynamics` is used up: its memory, statistics and watch are those of these steps afterwards.
class StepJudge {
 public:
  /// `breaks`, ascending [s]: where something is not smooth; parts end there.
  StepJudge(Dynamics& dynamics, SecondTake take, std::vector<double> breaks = {});
  /// As of StepParts.
  void divide_parts(int times);
  /// All choices of redundant rows of the run: where it passed over a pose in which its own is bad, the parts of a step
  /// may come too near, and another is taken.
  void choose_from(std::vector<std::vector<int>> choices) { choices_ = std::move(choices); }

  /// States of the run, by which it is known how long contacts last.
  void look_in(const StateLog& log) { log_ = &log; }

  /// The same mechanism, to be used up, by the equations of the run where `dynamics` has exact ones: what is recorded of
  /// reactions, be the state right or wrong, is what these give.
  void compare_with(Dynamics* recorded) { recorded_ = recorded; }

  /// `reactions`: those, too, as always where there are others to compare with; it takes two more evaluations. `inside`: where the run records there, too; it takes one
  /// more step. `retaken`: if somebody else has taken it again.
  StepError judge(const KeptStep& step, bool reactions, bool inside = false, const RetakenStep& retaken = {});
  /// Motion is seen from these, from now on; from the ground, if nobody says so. `arms`: of each connected part [m], by
  /// which turning counts as a speed; without them its size.
  void move_with(MovingAxes axes, VectorXd arms) {
    axes_ = std::move(axes);
    arms_ = std::move(arms);
  }
  const MovingAxes& axes() const { return axes_; }
  /// Where the step that was judged last ended, and where it would have: y = (q, v, work), of staggered velocities half a
  /// step later.
  const VectorXd& end() const { return run_end_; }
  const VectorXd& exact_end() const { return y_; }
  /// Energies that steps make are looked at, too, as where forces may have a potential but do not tell it: the balance
  /// of the run has their work by the same stages, and sees a part of what these err.
  void weigh_energies() { weighs_energies_ = true; }
  /// Largest kinetic energy at these steps, relative to what the ground sees; at most 1.
  double kinetic_share() const;
  /// Largest of each connected part there [J].
  const VectorXd& kinetic_energies() const { return kinetic_of_part_; }

 private:
  void look_at(const KeptStep& step, bool reactions, bool inside, const RetakenStep& retaken, StepError& out);
  KeptStep half_a_step_later(const KeptStep& step, StepError& out);
  VectorXd half_a_step_later(double t, double h, const VectorXd& y);
  void find_end(const KeptStep& step, const RetakenStep& retaken);
  double take_again(const KeptStep& step);
  void choose_rows(const KeptStep& step);
  double least_with(const std::vector<int>& rows, const KeptStep& step, double most);
  void leave_out_as_in(const KeptStep& step);
  void leave_out(const std::vector<int>& rows) { leave_out(dynamics_, rows); }
  static void leave_out(Dynamics& dynamics, const std::vector<int>& rows);
  void finish(double t);
  void compare(const KeptStep& step, StepError& out);
  void find_violation(const KeptStep& step, StepError& out);
  bool separate_fading(const KeptStep& step, double share, StepError& out);
  void separate_damped(const KeptStep& step, StepError& out);
  void look_at_motion(const KeptStep& step, StepError& out);
  void compare_inside(const KeptStep& step, StepError& out);
  void compare_energies(const KeptStep& step, StepError& out);
  void compare_history(const KeptStep& step, StepError& out);
  double by_onset(double t, Eigen::Index variable, const VectorXd& history, const VectorXd& other) const;
  bool stays(double t, Eigen::Index variable) const;
  void compare_reactions(const KeptStep& step, StepError& out);
  struct Reactions {
    Eigen::Matrix3Xd force, torque;
  };
  void find_reactions(Dynamics& dynamics, double t, const VectorXd& y, Reactions& out);
  void look_at_loads(StepError& out);
  void find_recorded_reactions(const KeptStep& step);
  VectorXd kinetic_energies_of(const VectorXd& y) const;

  Dynamics& dynamics_;
  Dynamics* recorded_ = nullptr;
  const StateLog* log_ = nullptr;
  const ConnectedParts& connected_;
  SecondTake take_;
  StepParts parts_;
  StepSpan span_;  ///< of the step
  double factor_;
  std::unique_ptr<Projection> projection_;  ///< where the run projects
  RelativeViolation violation_;
  MovingAxes axes_;
  VectorXd arms_;
  double kinetic_ = 0.0, ground_kinetic_ = 0.0;  ///< largest [J]
  VectorXd kinetic_of_part_;                     ///< of each part
  std::unique_ptr<PairStepper> stepper_;         ///< of a run that records inside of steps
  std::vector<std::vector<int>> choices_;
  std::vector<int> rows_;  ///< that are left out in this step
  VectorXd y_, run_end_, v_dot_, lambda_, seen_;
  VectorXd inside_, interpolated_;
  bool weighs_energies_ = false;
  bool came_inside_ = false;                ///< to inside_, where the first part ends
  Reactions reactions_, there_, yielding_;  ///< of this end, of that of the run, and there by its own equations
};

}  // namespace linkwork
