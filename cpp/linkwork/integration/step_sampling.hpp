#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/formulation/dynamics.hpp"
#include "linkwork/integration/kept_step.hpp"
#include "linkwork/integration/kink_watch.hpp"
#include "linkwork/integration/reversal_watch.hpp"
#include "linkwork/integration/state_difference.hpp"
#include "linkwork/integration/state_log.hpp"
#include "linkwork/integration/step_groups.hpp"

namespace linkwork {

/// What energies came to over a run, at the ends of its steps [J].
struct EnergyRange {
  double kinetic = 0.0, work = 0.0;  ///< largest, of the work in amount
  double least_potential = std::numeric_limits<double>::infinity();
  double largest_potential = -std::numeric_limits<double>::infinity();
};

/// Of the accelerations of a step of a mechanism that is one connected part.
struct Rates {
  double change = 0.0, largest = 0.0;  ///< from those of the step before; of any body [m/s^2]
};

/// Keeps some steps of a run, spread over it and more where accelerations change most, or where steps that follow
/// tolerances err most by their own estimate, so that they can be taken again when it is over: the run itself is not
/// touched, and knows nothing of what they give. The run is cut into parts of equally many steps, with two kept steps
/// each, after the first step, where nobody knows what came before; where nobody knows how many steps will come, parts
/// are joined in pairs when there are too many.
///
/// Steps with breaks, those in which contacts and stops begin or end or characteristics have kinks, and those that depend
/// on such a step, stand for others of their kind, not for the smooth ones around them, see StepGroups.
///
/// Accelerations count as differences of velocities over steps, of angular ones times a length of the connected part; in
/// large models only some bodies are looked at. How much they change, of all bodies, and the largest come of each step.
/// Where there are several connected parts, how much those of each change counts relative to the mean so far, so that
/// what happens to a small part is seen beside a large one.
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
  void expect_breaks(std::vector<double> times);
  const std::vector<double>& breaks() const { return breaks_; }
  /// States are logged, too, for errors that are followed: up to where an event, a jump or a kink of a
  /// characteristic is.
  void log_states();
  const StateLog& log() const { return log_; }
  /// See Integrator::memory.
  void remember(int steps) { memory_ = steps; }

  /// The steps so far, and the work up to here [J], are not of the run; but for the last one, to y, where it goes past
  /// its start.
  void begin_anew(const Dynamics& dynamics, const VectorXd& y, double start);

  // Of every step: `before` where `dynamics` is evaluated at its start y, and at the end of the run; then `after`, or
  // `pass_over` where the step is not one of the method's own (cut by an event, a leap over a singular pose).
  void before(const Dynamics& dynamics, const VectorXd& y);
  void after(double t, double h, const VectorXd& y, const VectorXd& y_new);
  /// `errors`: of the step in each connected part, as the method itself estimates them, in units of the tolerances.
  void after(double t, double h, const VectorXd& y, const VectorXd& y_new, const VectorXd& errors);
  // The same where somebody else knows the energies and the switches there, and the rates: those of several connected
  // parts are found here anyway.
  void before(const Dynamics& dynamics, const VectorXd& y, double kinetic, double potential, const VectorXd& switches);
  void after(double t, double h, const VectorXd& y, const VectorXd& y_new, const Rates& rates);
  /// v_dot over the last step (6n,), of every so many bodies; angular rates count by the square of a length.
  VectorXd& rates() { return rates_; }
  int every_body() const { return every_body_; }
  double squared_length() const { return squared_lengths_[0]; }  ///< of the first part
  void pass_over() {
    compared_ = false;
    last_.h = 0.0;
  }

  /// The run found its state y off by so much, and went on from another one.
  void correct(const VectorXd& y, const VectorXd& corrected);

  /// An event, a driver that jumps or another choice of rows changed the state, and its energy.
  void strike() {
    struck_ = true;
    log_.end();
  }
  bool struck() const { return struck_; }

  /// The parts with what is to be taken again of them: of short runs less than what was kept.
  std::vector<RunPart> parts() const;
  std::int64_t steps() const { return steps_; }  ///< that `after` was told of
  const EnergyRange& energies() const { return energies_; }
  /// Largest squared speed of each connected part where steps began; where there is but one, energies tell.
  const VectorXd& fastest() const { return fastest_; }
  /// Of each connected part the largest of its bodies, turning included by the size of the part [m^2/s^2].
  void find_squared_speeds(const VectorXd& y, VectorXd& out) const;
  const DifferencesOfParts& corrections() const { return corrections_; }  ///< the largest; empty: none
  /// The steps in which the balance of energy jumps far more than elsewhere, as a speed, without those of `parts`.
  std::vector<KeptStep> outliers(const std::vector<RunPart>& parts) const;
  bool empty() const { return parts_.empty(); }  ///< there was no step
  /// Those that made far more energy than any of `parts`, without these: some may be worse than all of them.
  std::vector<KeptStep> suspects(const std::vector<RunPart>& parts) const;
  /// The steps that contain breaks: a part of the run of its own for each that was kept.
  std::vector<RunPart> broken() const { return broken_.parts(); }
  /// Of the steps in which a contact or a stop begins or ends, or a characteristic has a kink, and of those that depend
  /// on them, some likewise: forces are not smooth there, and at which speed a contact begins is found one step late,
  /// and held from there on.
  std::vector<RunPart> switched() const { return switched_.parts(); }

  /// How many of so many steps are taken again.
  static std::int64_t samples(std::int64_t steps, int bodies);

 private:
  void look_for_switches(const VectorXd& history, const VectorXd& switches, const VectorXd& y);
  bool pass_switches(const VectorXd& history, const VectorXd& switches);
  void pass_kinks(const VectorXd& history, const VectorXd& y);
  void pass_reversals(const VectorXd& y);
  const std::vector<int>& pieces(double t, const VectorXd& y, const VectorXd& history);
  void balance(const VectorXd& y, double kinetic, double potential);
  /// The steps with the largest of some numbers.
  struct Largest {
    double least = 0.0;  ///< of these, once there are enough
    std::vector<std::pair<double, KeptStep>> steps;

    /// Those with larger ones that are not among `there`.
    std::vector<KeptStep> above(double limit, const std::vector<const KeptStep*>& there) const;
  };
  void keep_jump(double made, const VectorXd& y_new);
  void keep_largest(Largest& list, double number, const VectorXd& y_new) const;
  void choose(RunPart& part, double change, const VectorXd& y_new);
  bool meet_break(double t, double h, const VectorXd& y_new);
  void look_at_rates(double h, const VectorXd& y, const VectorXd& y_new);
  void note_speeds(const VectorXd& y);
  double change_of_all(const VectorXd& least);
  void follow(double t, double h, const VectorXd& y, const VectorXd& y_new, double change);
  void begin_part_if_full(double t);
  void keep(KeptStep& place, const VectorXd& y_new) const;

  int q_size_, body_count_, every_body_;
  VectorXd squared_lengths_;  ///< of the connected parts
  std::size_t most_parts_;
  std::int64_t width_ = 1, chosen_ = 0;  ///< steps of a part, and which of them is kept in any case
  std::int64_t steps_ = 0;
  bool compared_ = false;  ///< rates_ are those of the step before
  VectorXd rates_;
  bool logs_ = false;
  StateLog log_;
  // Of the connected parts:
  VectorXd changes_, sums_of_changes_;  ///< of this step, of all compared ones; see KeptStep
  VectorXd largest_, speeds_;           ///< largest acceleration of a body [m/s^2], squared speed
  VectorXd fastest_;                    ///< of all steps
  VectorXd usual_changes_;              ///< mean up to the part of the run; 0: none yet
  double compared_steps_ = 0.0;
  VectorXd history_;
  double correction_length_ = 0.0;
  std::vector<int> left_out_;
  std::vector<RunPart> parts_;
  const System* system_;
  const ConnectedParts* connected_;
  double kinetic_ = 0.0, balance_ = 0.0;  ///< T and B where the step begins
  EnergyRange energies_;
  double work_before_ = 0.0;
  DifferencesOfParts corrections_;
  bool struck_ = false;
  bool touches_ = false;  ///< where the step begins
  double sum_of_jumps_ = 0.0;
  KeptStep last_;  ///< without y_new, which `before` will see; h = 0: none
  Largest by_jump_, by_energy_;
  std::vector<double> breaks_;
  std::size_t next_break_ = 0;
  std::vector<int> group_of_break_;
  StepGroups broken_, switched_;
  int memory_ = 0;
  std::vector<char> sides_;  ///< of switches, positive or not, where the step begins
  std::optional<KinkWatch> kinks_;
  std::vector<int> pieces_;  ///< between kinks, where the step begins
  std::optional<ReversalWatch> reversals_;
  std::vector<int> directions_;  ///< of them, where the step begins
  GroupsOfSwitches groups_;
  std::vector<std::int64_t> since_switch_, since_kink_;  ///< steps, of each group
  std::vector<int> groups_of_step_;
};

/// Time that a run of so many steps spends on following them, without what they take themselves [s].
double time_sampling(const Dynamics& dynamics, std::int64_t steps);

}  // namespace linkwork
