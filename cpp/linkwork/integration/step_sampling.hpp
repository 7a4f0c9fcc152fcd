#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// A step as a run took it, from y at t to y_new at t + h; y = (q, v, work).
struct KeptStep {
  double t = 0.0, h = 0.0;
  double correction_length = 0.0;  ///< see Dynamics::correct_over
  double change = -1.0;  ///< how much the accelerations differ from those of the step before; see StepSampling
  double jump = 0.0;     ///< of the balance of energy, as a speed in the metric of the masses; see StepSampling
  VectorXd y, y_new;
  VectorXd history;           ///< variables of the elements, at t
  VectorXd history_new;       ///< at t + h, of a step in which contacts begin; else empty
  bool switched = false;      ///< see StepSampling::switched
  std::vector<int> left_out;  ///< redundant rows, at t

  bool kept() const { return h > 0.0; }
};

/// The largest of any body.
struct StateDifference {
  double position = 0.0, rotation = 0.0, velocity = 0.0, omega = 0.0;  ///< m, rad, m/s, rad/s

  void raise(const StateDifference& other);
  void lower(const StateDifference& by);  ///< not below zero
  /// Between y = (q, v, ...) of both.
  void raise(const System& system, const VectorXd& a, const VectorXd& b);
};

/// What energies came to over a run, at the ends of its steps [J].
struct EnergyRange {
  double kinetic = 0.0, work = 0.0;  ///< largest, of the work in amount
  double least_potential = std::numeric_limits<double>::infinity();
  double largest_potential = -std::numeric_limits<double>::infinity();
};

/// Some steps of a run, one after the other, and the two of them that are kept: one that the accelerations did not
/// choose, and the one in which they change most.
/// `Step`: those steps, or where they are.
template <class Step>
struct PartOfRun {
  std::int64_t steps = 0;
  double t = 0.0, seconds = 0.0;
  double sum_of_changes = 0.0;
  double peak = 0.0;  ///< largest acceleration of a body [m/s^2]
  Step any{}, steepest{};
};
using RunPart = PartOfRun<KeptStep>;

/// Of the accelerations of a step.
struct Rates {
  double change = 0.0, largest = 0.0;  ///< from those of the step before; of any body [m/s^2]
};

/// Keeps some steps of a run, spread over it and more where accelerations change most, so that they can be taken again
/// when it is over: the run itself is not touched, and knows nothing of what they give. The run is cut into parts of
/// equally many steps, with two kept steps each, after the first step, where nobody knows what came before; where
/// nobody knows how many steps will come, parts are joined in pairs when there are too many.
///
/// Steps in which contacts and stops begin or end, and those that depend on such a step, stand for others of their kind,
/// not for the smooth ones around them.
///
/// Accelerations count as differences of velocities over steps, of angular ones times a length of the mechanism; in
/// large models only some bodies are looked at. How much they change, of all bodies, and the largest come of each step.
///
/// A single bad step, such as one beside a singular pose, shows in the balance of energy, which costs no evaluation:
/// with T and B = T + V - W at the start of a step and B' at its end, d = |B' - B|, speeds in the metric of the masses
/// are off by at least (T + d)^1/2 - T^1/2, about d / (4 T + d)^1/2. The steps in which this is largest are kept, too.
class StepSampling {
 public:
  explicit StepSampling(const Dynamics& dynamics);

  /// The run will have so many steps.
  void expect(std::int64_t steps);
  /// Times [s], ascending, at which something is not smooth: steps that contain one are kept, too, if there are not
  /// many.
  void expect_breaks(std::vector<double> times) { breaks_ = std::move(times); }
  const std::vector<double>& breaks() const { return breaks_; }
  /// See Integrator::memory.
  void remember(int steps) { memory_ = steps; }

  /// The steps so far, and the work up to here [J], are not of the run.
  void begin_anew(const Dynamics& dynamics, double work);

  // Of every step: `before` where `dynamics` is evaluated at its start y, and at the end of the run; then `after`, or
  // `pass_over` where the step is not one of the method's own (cut by an event, a leap over a singular pose).
  void before(const Dynamics& dynamics, const VectorXd& y);
  void after(double t, double h, const VectorXd& y, const VectorXd& y_new);
  // The same where somebody else knows the energies and the switches there, and the rates.
  void before(const Dynamics& dynamics, const VectorXd& y, double kinetic, double potential, const VectorXd& switches);
  void after(double t, double h, const VectorXd& y, const VectorXd& y_new, const Rates& rates);
  /// v_dot over the last step (6n,), of every so many bodies; angular rates count by the square of a length.
  VectorXd& rates() { return rates_; }
  int every_body() const { return every_body_; }
  double squared_length() const { return squared_length_; }
  void pass_over() {
    compared_ = false;
    last_.h = 0.0;
  }

  /// The run found its state y off by so much, and went on from another one.
  void correct(const VectorXd& y, const VectorXd& corrected) { corrections_.raise(*system_, y, corrected); }

  /// The parts with what is to be taken again of them: of short runs less than what was kept.
  std::vector<RunPart> parts() const;
  std::int64_t steps() const { return steps_; }  ///< that `after` was told of
  const EnergyRange& energies() const { return energies_; }
  const StateDifference& corrections() const { return corrections_; }  ///< the largest
  /// The steps in which the balance of energy jumps far more than elsewhere, or more than in any of `parts`, without
  /// those.
  std::vector<KeptStep> outliers(const std::vector<RunPart>& parts) const;
  /// The steps that contain breaks: a part of the run of its own for each that was kept.
  std::vector<RunPart> broken() const;
  /// Of the steps in which a contact or a stop begins or ends, and of those that depend on them, some likewise: forces
  /// are not smooth there, and at which speed a contact begins is found one step late, and held from there on.
  std::vector<RunPart> switched() const;

  /// How many of so many steps are taken again.
  static std::int64_t samples(std::int64_t steps, int bodies);

 private:
  void look_for_switches(const VectorXd& history, const VectorXd& switches, const VectorXd& y);
  bool pass_switches(const VectorXd& switches);
  void keep_switched(const VectorXd& y_new);
  void balance(const VectorXd& y, double kinetic, double potential);
  void keep_jump(double jump, const VectorXd& y_new);
  void meet_break(double t, double h, const VectorXd& y, const VectorXd& y_new);
  Rates look_at_rates(double h, const VectorXd& y, const VectorXd& y_new);
  void begin_part(double t);
  void keep(KeptStep& place, double t, double h, double change, const VectorXd& y, const VectorXd& y_new) const;

  int q_size_, body_count_, every_body_;
  double squared_length_;
  std::size_t most_parts_;
  std::int64_t width_ = 1, chosen_ = 0;  ///< steps of a part, and which of them is kept in any case
  std::int64_t steps_ = 0;
  bool compared_ = false;  ///< rates_ are those of the step before
  VectorXd rates_;
  VectorXd history_;
  double correction_length_ = 0.0;
  std::vector<int> left_out_;
  std::vector<RunPart> parts_;
  const System* system_;
  double kinetic_ = 0.0, balance_ = 0.0;  ///< T and B where the step begins
  EnergyRange energies_;
  double work_before_ = 0.0;
  StateDifference corrections_;
  double sum_of_jumps_ = 0.0, least_jump_ = 0.0;
  KeptStep last_;  ///< without y_new, which `before` will see; h = 0: none
  std::vector<KeptStep> worst_;
  std::vector<double> breaks_;
  std::size_t next_break_ = 0;
  std::int64_t steps_with_breaks_ = 0;
  std::vector<KeptStep> broken_;
  int memory_ = 0;
  std::vector<char> sides_;  ///< of switches, positive or not, where the step begins
  std::int64_t since_switch_ = std::numeric_limits<int>::max(), switched_steps_ = 0;
  double share_switched_ = 1.0;  ///< of those steps that are kept, and where each stands in their order:
  struct Switched {
    double place;
    KeptStep step;
  };
  std::vector<Switched> switched_;
};

/// Time that a run of so many steps spends on following them, without what they take themselves [s].
double time_sampling(const Dynamics& dynamics, std::int64_t steps);

}  // namespace linkwork
