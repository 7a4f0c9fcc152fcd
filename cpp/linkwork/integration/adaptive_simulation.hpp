#pragma once

#include <cmath>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "linkwork/integration/break_points.hpp"
#include "linkwork/integration/crossing.hpp"
#include "linkwork/integration/embedded_pair.hpp"
#include "linkwork/integration/events.hpp"
#include "linkwork/integration/hermite_step.hpp"
#include "linkwork/integration/run.hpp"
#include "linkwork/integration/step_control.hpp"
#include "linkwork/integration/stored_energy_jumps.hpp"

namespace linkwork {

/// How far to go, how exactly, and what to keep. Times in s. `record_every` and `times`, one of them or both, say which
/// states are recorded; output never limits the step. An event that changes the state or ends the run ends a step: that
/// state is recorded with `record_every`, and with `times` where it ends the run.
struct AdaptiveSchedule {
  double t_end = 0.0;
  Tolerances tolerances;
  double largest_step = std::numeric_limits<double>::infinity();
  std::int64_t record_every = 0;   ///< steps between frames, the first and the last state included; 0: `times` alone
  std::vector<double> times = {};  ///< ascending; states between steps come from the interpolant
  double t_start = 0.0;
  VectorXd start = {};                  ///< y = (q, v) at t_start; empty: that of the model
  std::vector<double> breaks = {};      ///< times at which something is not smooth, beside those that the model knows
  std::vector<Happened> happened = {};  ///< events that came at t_start
  /// Of a run that is resumed: events that the run before it has listed since its checkpoint; none: nobody knows.
  std::optional<std::vector<Listed>> listed = {};
};

/// Of the accepted steps, and how many were rejected.
struct StepStatistics {
  std::int64_t rejected = 0;
  std::int64_t breaks = 0;    ///< at which a step ended
  std::int64_t impacts = 0;   ///< of these, by drivers whose velocity jumps
  std::int64_t singular = 0;  ///< accepted to pass a singular pose, with larger errors than the tolerances allow
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
};

/// Bodies struck by drivers at t [s]: before and after it y = (q, v, work), and energies [J].
struct Strike {
  struct Side {
    VectorXd y;
    double kinetic;
  };
  double t, potential;
  Side before, after;
};

/// A run with steps as large as the tolerances allow. After an event that changes the state, velocities and positions
/// go to the constraints (see Projection), the work counts what the event did, and the steps begin anew.
///
/// Steps end at break points, see BreakPoints, and begin anew there. Where the velocity that a driver demands jumps,
/// the bodies are struck: v' - v = M^-1 D^T P with D v' + Phi_t = 0 after it, the least change of velocity in the
/// metric of the masses, as impulses P in the joints alone bring it about; the work takes up the energy.
class AdaptiveSimulation final : public Run {
 public:
  AdaptiveSimulation(Dynamics& dynamics, const EmbeddedPair& pair, const AdaptiveSchedule& schedule,
                     std::vector<Event> events = {});

  double t() const override { return t_; }
  bool records_inside() const override { return !schedule_.times.empty(); }
  const StepStatistics& step_statistics() const { return statistics_; }

  // For somebody who evaluates the stages of several runs side by side:
  Dynamics& mechanism() { return dynamics_; }
  const EmbeddedPair& pair() const { return stepper_.pair(); }
  /// Goes on to where a step is to be tried. False: the run is finished.
  bool advance_to_trial();
  /// The first stage of that step. False where there is none, which `finish_trial` will find.
  bool begin_trial();
  StepSpan trial_span() const { return span(trial_h_); }
  const VectorXd& trial_start() const { return y_; }
  PairStepper& stepper() { return stepper_; }
  /// Tries it, with the stages that were supplied to the stepper, and evaluates those that were not.
  void finish_trial();

  /// The events of the steps finished since the last call.
  std::vector<Occurrence> take_occurrences() { return std::exchange(occurrences_, {}); }
  /// Of all of them. Of an event that changes nothing the work alone is known: forces are not evaluated there.
  const std::vector<EnergiesAround>& energies_around_events() const { return around_events_; }
  /// Events that are listed, by the run that this one goes on from, too, where it `knows_listed` of that.
  const std::vector<Listed>& listed() const { return listed_; }
  bool knows_listed() const { return !resumed() || schedule_.listed; }
  /// The same as `take_occurrences` of strikes.
  std::vector<Strike> take_strikes() { return std::exchange(strikes_, {}); }

 private:
  /// Of t: t + h is exact to some percent.
  static constexpr double least_step = 16 * std::numeric_limits<double>::epsilon();

  void take_step() override;
  void forget() override {
    crossing_.restart();
    controller_.restart();
  }
  void keep(Archive& archive) override;
  void record_start() override;
  bool past_start() const override { return t_ >= start_; }
  double start() const override { return start_; }
  bool near_end() const;
  void begin();
  double initial_step();
  bool go_on();
  bool prepare_trial();
  BodyMaximum trial(double h);
  void accept(double h, double error);
  // Contacts and stops, see adaptive_switches.cpp.
  bool end_at_switch(double h);
  bool stays_apart_for_interpolation();
  void end_at(const SwitchWatch::Switch& found, double h);
  BodyMaximum end_at_zero(int which, double h, double& part);
  bool stages_went_astray();
  BodyMaximum half_a_step() const;
  void settle_history();
  void accept_contacts();
  bool leap();
  const Interpolant& interpolant() const;
  void look_for_events();
  double since_start(std::size_t event, double t);
  double after_start() const { return std::nextafter(start_, std::numeric_limits<double>::infinity()); }
  void finish_event(double t_before);
  void list_events();
  void cross_break();
  void strike(const VectorXd& Phi_t_before);
  double clock() const;
  StepSpan span(double h) const;
  double next_stop() const;
  bool meets_break(double t, double t_new) const;
  double kinetic_energy() const;
  double energy() const { return kinetic_energy() + dynamics_.evaluation().potential; }
  Energies energies() const { return {y_[y_.size() - 1], kinetic_energy(), dynamics_.evaluation().potential}; }
  double end_of_step(double& h) const;
  bool violates(double h) const;
  /// True where the change ends the run.
  bool apply(const Event& event, Occurrence& occurrence);
  void find_drift();
  bool near_singular_pose() const;
  void pass_singular_pose(double h, double error);
  void retry(double h);
  void reject(double h, const BodyMaximum& error);
  [[noreturn]] void throw_step_size(const BodyMaximum& error) const;
  void check_accumulation();
  bool output_inside() const;
  void record_inside();
  void record_in_step(double t, const VectorXd& y);
  void record_in_leap(double t, const VectorXd& y);
  void finish_step();
  void list_singular_poses();
  void sample(double t_before, bool at_break);
  void evaluate(double t, const VectorXd& y);
  void record_if_due();

  AdaptiveSchedule schedule_;
  PairStepper stepper_;
  ErrorMeasure measure_;
  StepController controller_;
  StepStatistics statistics_;
  BreakPoints breaks_;
  StoredEnergyJumps jumps_;
  Crossing crossing_;
  bool leapt_ = false;  ///< the step that was accepted is a leap over a singular pose
  EventWatch watch_;
  SwitchWatch switches_;
  TouchSearch touches_;
  std::optional<SwitchWatch::Switch> switch_;  ///< that ends the current step
  std::vector<Occurrence> of_step_;            ///< found in the current step, which is not finished
  std::vector<Occurrence> occurrences_;        ///< of finished steps
  std::vector<EnergiesAround> around_events_;  ///< of all finished steps
  std::vector<Listed> listed_, repeated_;      ///< `repeated_`: those that may be found once more
  std::vector<Strike> strikes_;
  std::vector<EventWatch::Found> stops_;  ///< the event that ends the current step, and those that come with it
  double last_stop_ = 0.0, last_interval_ = std::numeric_limits<double>::infinity();  ///< between such events
  int shorter_ = 0;             ///< such intervals in a row that were shorter than the one before
  double shorter_since_ = 0.0;  ///< when the first of them began
  double t_ = 0.0, h_ = 0.0, t_new_ = 0.0;
  double start_ = 0.0;              ///< of this run, which may have been resumed from before it
  VectorXd y_new_;                  ///< at t_new_
  VectorXd y_before_;               ///< the start of the last finished step
  double trial_h_ = 0.0;            ///< of the step that is to be tried
  VectorXd errors_;                 ///< of the last step, as they are estimated, of each of ConnectedParts
  double step_ = 0.0;               ///< what the controller proposes
  double proposed_ = 0.0;           ///< what it proposed for this one
  VectorXd Phi_, Phi_dot_;          ///< where the step begins
  double correction_length_ = 0.0;  ///< see Dynamics::correct_over
  bool yields_ = false;             ///< the formulation lets constraints be violated
  // Near a singular pose
  double usual_step_ = 0.0;  ///< the last outside
  int tries_ = 0;
  double best_step_ = 0.0, best_error_ = 0.0;  ///< of these tries
  bool begun_ = false;
  bool accepted_ = false;   ///< the stepper holds the step from t_ to t_new_
  bool evaluated_ = false;  ///< `dynamics` is at the state that comes next: y_, or y_new when accepted
  std::optional<Dynamics::Place> away_from_;  ///< or was, and only looked elsewhere since
  std::size_t next_time_ = 0;
  std::string last_failure_;         ///< of a stage of the last trial
  std::exception_ptr beyond_table_;  ///< thrown by it
  VectorXd workspace_, rates_;
  mutable VectorXd workspace_rows_;
};

}  // namespace linkwork
