#include "linkwork/integration/step_judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/integration/damped_error.hpp"
#include "linkwork/integration/energies_made.hpp"
#include "linkwork/integration/runge_kutta.hpp"
#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr int divisions_where_contacts_begin = 3;
constexpr double long_contact = 0.1;  // share of the run: beyond, it is no bounce
constexpr double well_chosen = 0.1;   // root of the smallest pivot, relative to the usual one
constexpr double beside = 1e-9;       // of a step: times that are one
constexpr double soon = 0.1;          // share that a step takes back: then errors off the constraints do not add up
constexpr double little = 0.25;       // of what velocities are off, that is along the constraints: then it counts alone
constexpr double above_noise = 10.0;  // of what rounding of positions is in a step: less is none that is taken back
constexpr double roundoff = 8.0 * std::numeric_limits<double>::epsilon();

/// One step of a one-step method in parts, with the correction that a multistep method adds, if asked for.
class CorrectedApart final : public Integrator {
 public:
  CorrectedApart(const ButcherTableau& tableau, bool corrects) : tableau_(tableau), corrects_(corrects) {
    check(tableau);
  }

  const std::string& name() const override { return tableau_.name; }
  int order() const override { return tableau_.order; }
  void start(int y_size) override {
    k_.resize(y_size, tableau_.b.size());
    for (VectorXd* state : {&stage_, &correction_}) state->resize(y_size);
  }

  void divide(int times) { divisions_ = times; }

  void step(Dynamics& dynamics, const StepSpan& step, VectorXd& y) override {
    correction_.setZero();
    if (corrects_) dynamics.add_correction(step.h, correction_);
    advance(dynamics, step, y, divisions_);
    y += correction_;
  }

 private:
  void advance(Dynamics& dynamics, const StepSpan& step, VectorXd& y, int divisions) {
    if (divisions == 0) {
      evaluate_free_stages(tableau_, dynamics, step, y, k_, stage_);
      return add_combination(step.h, tableau_.b, k_, y);
    }
    const auto [part, rest] = step.divided(golden_share);
    advance(dynamics, part, y, divisions - 1);
    dynamics.evaluate(rest.at(0.0), y);
    dynamics.advance_history();
    advance(dynamics, rest, y, divisions - 1);
  }

  ButcherTableau tableau_;
  bool corrects_;
  int divisions_ = 1;
  MatrixXd k_;
  VectorXd stage_, correction_;
};

/// By which two states that are one may differ.
DifferencesOfParts rounding(const System& system, const VectorXd& y) {
  DifferencesOfParts out = differences(system, y, VectorXd::Zero(y.size()));
  for (StateDifference& of_part : out) {
    of_part.rotation = 1.0;
    of_part.scale(roundoff);
  }
  return out;
}

/// What rounding makes of positions in a step, if the displacements of the next are the same to the last digit: then all
/// are rounded to the same side [m].
double lasting_rounding(const System& system, int body, const KeptStep& step) {
  const int r = position_size * body, v = system.q_size() + velocity_size * body;
  const auto velocity = step.y_new.segment<3>(v);
  const double unit = std::numeric_limits<double>::epsilon() * step.y_new.segment<3>(r).norm();
  if ((velocity - step.y.segment<3>(v)).norm() * step.h > unit) return 0.0;
  return std::min(unit, velocity.norm() * step.h);
}

/// By how much a step of Baumgarte stabilization takes violations back, at least: the slower root of
/// x^2 + 2 alpha x + beta^2 = 0, times h; all of them where it is sampled with the gains of the step.
double share_taken_back(const Dynamics& dynamics, double h) {
  const bool sampled = dynamics.stabilization() == StabilizationKind::sampled_baumgarte;
  if (!sampled && dynamics.stabilization() != StabilizationKind::baumgarte) return 0.0;
  if (sampled && !dynamics.options().baumgarte_alpha && !dynamics.options().baumgarte_beta) return 1.0;
  const double alpha = dynamics.options().baumgarte_alpha.value_or(textbook_gains.alpha);
  const double beta = dynamics.options().baumgarte_beta.value_or(textbook_gains.beta);
  return h * (alpha < beta ? alpha : beta * beta / (2.0 * alpha));
}

/// Raises those of a part to those of this joint, NaN: not looked at.
void raise(double& force, double& torque, double of_force, double of_torque) {
  force = std::fmax(force, of_force);
  torque = std::fmax(torque, of_torque);
}

}  // namespace

SecondTake in_parts(std::unique_ptr<Integrator> integrator) {
  const int order = integrator->order();
  const double left = elementary::power(golden_share, order + 1) + elementary::power(1.0 - golden_share, order + 1);
  return {std::move(integrator), golden_share, order > 0 ? left : 0.0};
}

SecondTake by_one_step_method(const ButcherTableau& other, bool corrects) {
  auto method = std::make_unique<CorrectedApart>(other, corrects);
  const auto divide = [method = method.get()](int times) { method->divide(times); };
  return {std::move(method), 1.0, 0.0, {}, divide};
}

SecondTake of_staggered_velocities(const ButcherTableau& other) {
  SecondTake take = by_one_step_method(other, false);
  take.staggered = true;
  return take;
}

StepJudge::StepJudge(Dynamics& dynamics, SecondTake take, std::vector<double> breaks)
    : dynamics_(dynamics),
      connected_(ConnectedParts::of(dynamics.system())),
      take_(std::move(take)),
      parts_(std::move(breaks), take_.share),
      factor_(1.0 / (1.0 - take_.left)),
      violation_(dynamics.system()),
      arms_(violation_.lengths()),
      kinetic_of_part_(VectorXd::Zero(connected_.count())),
      v_dot_(dynamics.system().v_size()),
      lambda_(VectorXd::Zero(dynamics.system().row_count())) {
  if (projects_positions(dynamics.stabilization()) || projects_velocities(dynamics.stabilization()))
    projection_ = std::make_unique<Projection>(dynamics);
  take_.integrator->start(dynamics.y_size());
  if (take_.pair) {
    stepper_ = std::make_unique<PairStepper>(*take_.pair);
    stepper_->start(dynamics.y_size());
  }
  for (Reactions* reactions : {&reactions_, &there_, &yielding_})
    for (Eigen::Matrix3Xd* vectors : {&reactions->force, &reactions->torque})
      vectors->setZero(3, dynamics.system().joint_count());
}

StepError StepJudge::judge(const KeptStep& step, bool reactions, bool inside, const RetakenStep& retaken) {
  StepError out;
  out.t = step.t;
  out.h = step.h;
  out.of_part.resize(connected_.count());
  came_inside_ = false;
  span_ = parts_.whole(step.t, step.h);
  dynamics_.correct_over(step.correction_length);
  if (take_.divide) take_.divide(step.history_new.size() > 0 ? divisions_where_contacts_begin : 1);
  try {
    if (take_.staggered) look_at(half_a_step_later(step, out), reactions, inside, retaken, out);
    else look_at(step, reactions, inside, retaken, out);
    find_violation(step, out);
  } catch (const Error&) {
    out.failed = true;
  }
  dynamics_.end_parts();
  return out;
}

/// What the velocities miss the constraints by is an error of theirs, the same in a step that is taken again: far from
/// the origin violations of positions are rounding, which stabilization turns into velocities.
void StepJudge::find_violation(const KeptStep& step, StepError& out) {
  out.violation = violation_.largest(span_.at(1.0), step.y_new, step.history);
  if (take_.staggered) return;
  const DifferencesOfParts rounded = rounding(dynamics_.system(), step.y_new);
  for (std::size_t part = 0; part < out.of_part.size(); ++part) {
    const double speed = violation_.speeds()[static_cast<Eigen::Index>(part)];
    out.of_part[part].fading.raise({0.0, 0.0, speed, 0.0});
    out.of_part[part].noise = std::min(speed, rounded[part].position / step.h);
  }
}

void StepJudge::look_at(const KeptStep& step, bool reactions, bool inside, const RetakenStep& retaken, StepError& out) {
  find_end(step, retaken);
  run_end_ = step.y_new;
  compare(step, out);
  if (step.history_new.size() > 0) compare_history(step, out);
  if ((reactions || recorded_) && dynamics_.system().joint_count() > 0) compare_reactions(step, out);
  out.failed = !y_.allFinite();
  if (inside && stepper_ && came_inside_) compare_inside(step, out);
  if (weighs_energies_ && !out.failed) compare_energies(step, out);
}

void StepJudge::compare_energies(const KeptStep& step, StepError& out) {
  dynamics_.evaluate(span_.at(1.0), y_);
  const System& system = dynamics_.system();
  const VectorXd made = energies_apart(system, dynamics_.evaluation(), y_, step.y_new);
  const VectorXd unseen = roundoff * scales_of_energies(system, dynamics_.evaluation(), y_);
  const VectorXd its_v = y_.segment(system.q_size(), system.v_size());
  const VectorXd in_inerters = energies_in_inerters(system, dynamics_.evaluation(), its_v);
  for (std::size_t k = 0; k < out.of_part.size(); ++k) {
    const auto part = static_cast<Eigen::Index>(k);
    out.of_part[k].energy = std::copysign(factor_ * std::max(std::abs(made[part]) - unseen[part], 0.0), made[part]);
    out.of_part[k].in_inerters = in_inerters[part];
  }
}

KeptStep StepJudge::half_a_step_later(const KeptStep& step, StepError& out) {
  KeptStep later = step;
  rows_ = step.left_out;
  dynamics_.set_history(step.history);
  later.y = half_a_step_later(span_.at(0.0), step.h, step.y);
  later.y_new = half_a_step_later(span_.at(1.0), step.h, step.y_new);
  const DifferencesOfParts late = differences(dynamics_.system(), later.y, step.y);
  for (std::size_t k = 0; k < late.size(); ++k) out.of_part[k].late = late[k];
  return later;
}

VectorXd StepJudge::half_a_step_later(double t, double h, const VectorXd& y) {
  const System& system = dynamics_.system();
  dynamics_.evaluate(t, y);
  if (dynamics_.dropped().rows() != rows_) leave_out(rows_);
  dynamics_.accelerations(v_dot_, lambda_);
  VectorXd out = y;
  out.segment(system.q_size(), system.v_size()) += 0.5 * h * v_dot_;
  return out;
}

/// With the rows that the run left out in this step; with others, where parts came near a pose in which these are bad.
void StepJudge::find_end(const KeptStep& step, const RetakenStep& retaken) {
  rows_ = step.left_out;
  const bool known = retaken.end.size() > 0, rows_change = dynamics_.dropped().rows() != rows_;
  const double pivot = known ? retaken.smallest_pivot : take_again(step);
  const bool suspicious = std::sqrt(pivot) < well_chosen * dynamics_.watch().root_of_level();
  if (choices_.size() > 1 && suspicious) choose_rows(step);
  if (rows_ != step.left_out || (known && retaken.rows_change != rows_change)) {
    take_again(step);
    return;
  }
  if (known) y_ = retaken.end;
  if (dynamics_.dropped().rows() != rows_) leave_out_as_in(step);
}

/// Others that are as many, where the run had such, and these are better all over the step.
void StepJudge::choose_rows(const KeptStep& step) {
  double most = -1.0;
  for (const std::vector<int>& rows : choices_) {
    if (rows.size() != step.left_out.size() || rows == step.left_out) continue;
    if (most < 0.0) most = least_with(step.left_out, step, 0.0);
    const double least = least_with(rows, step, most);
    if (least <= most) continue;
    most = least;
    rows_ = rows;
  }
}

/// The least singular value at the begin, in the middle and at the end; up to where it is no more than `most`.
double StepJudge::least_with(const std::vector<int>& rows, const KeptStep& step, double most) {
  double least = INFINITY;
  dynamics_.set_history(step.history);
  for (const double theta : {0.0, 0.5, 1.0}) {
    VectorXd y = (1.0 - theta) * step.y + theta * step.y_new;
    dynamics_.system().normalize(y.head(dynamics_.system().q_size()));
    dynamics_.evaluate(span_.at(theta), y);
    try {
      leave_out(rows);
      least = std::min(least, dynamics_.formulation().least_singular_value_of_all());
    } catch (const SingularSystemError&) {
      return 0.0;
    }
    if (least <= most) break;
  }
  return least;
}

/// The smallest pivot on the way.
double StepJudge::take_again(const KeptStep& step) {
  const std::vector<StepSpan> parts = parts_.of(step.t, step.h);
  const double end_of_first = step.t + take_.share * step.h;
  came_inside_ = false;
  y_ = step.y;
  dynamics_.formulation().take_smallest_pivot();
  dynamics_.set_history(step.history);
  dynamics_.begin_parts(parts.front().h / std::max(step.h, step.correction_length));
  for (const StepSpan& part : parts) {
    dynamics_.evaluate(part.at(0.0), y_);
    if (&part == &parts.front()) leave_out(rows_);
    else dynamics_.advance_history();
    take_.integrator->step(dynamics_, part, y_);
    finish(part.at(1.0));
    if (stepper_ && std::abs(part.t + part.h - end_of_first) <= beside * step.h) {
      inside_ = y_;
      came_inside_ = true;
    }
  }
  dynamics_.end_parts();
  return dynamics_.formulation().take_smallest_pivot();
}

/// What comes afterwards looks at the end of the step with what solves as it was analyzed at its begin.
void StepJudge::leave_out_as_in(const KeptStep& step) {
  dynamics_.set_history(step.history);
  dynamics_.evaluate(span_.at(0.0), step.y);
  leave_out(rows_);
}

void StepJudge::divide_parts(int times) {
  parts_.divide(times);
  factor_ = 1.0 / (1.0 - elementary::power(take_.left, times));
}

/// The rows that the run left out in this step; others have become redundant since, or were before.
void StepJudge::leave_out(Dynamics& dynamics, const std::vector<int>& rows) {
  if (dynamics.dropped().rows() != rows) dynamics.formulation().change_redundant_rows(rows, {});
}

void StepJudge::finish(double t) {
  dynamics_.system().normalize(y_.head(dynamics_.system().q_size()));
  if (projection_) projection_->stabilize(t, y_);
}

/// Of rounding only that which comes from far away or from a speed as a whole is no error: small ones of the method, of
/// as little as that of the motion, add up over many steps.
void StepJudge::compare(const KeptStep& step, StepError& out) {
  const System& system = dynamics_.system();
  const DifferencesOfParts apart = differences(system, step.y_new, y_);
  for (std::size_t k = 0; k < apart.size(); ++k) {
    out.of_part[k].end = apart[k];
    if (step.changes.size() > 0) out.of_part[k].change = step.changes[static_cast<Eigen::Index>(k)];
  }
  const double share = take_.staggered ? 1.0 : share_taken_back(dynamics_, step.h);
  if (!(take_.staggered || share >= soon) || !separate_fading(step, share, out)) separate_damped(step, out);
  look_at_motion(step, out);
  DifferencesOfParts unseen = rounding(system, step.y_new);
  for (std::size_t k = 0; k < unseen.size(); ++k) {
    PartError& of_part = out.of_part[k];
    unseen[k].lower({roundoff * arms_[static_cast<Eigen::Index>(k)], INFINITY, roundoff * of_part.speed, INFINITY});
    of_part.end.lower(unseen[k]);
    of_part.end.scale(factor_);
  }
}

/// What remains is the difference of the states on the constraints; the rest is there until it is taken back. Where
/// stabilization is sampled both are of one size as a rule, and all of it is taken to remain. False: nothing is separated.
bool StepJudge::separate_fading(const KeptStep& step, double share, StepError& out) {
  const bool rarely = dynamics_.sampled() && !recorded_ && !take_.staggered;
  const double end = span_.at(1.0);
  VectorXd ours = step.y_new, others = y_;
  try {
    Projection projection(dynamics_);
    for (VectorXd* y : {&ours, &others}) {
      dynamics_.evaluate(end, *y);
      projection.positions(end, *y);
      projection.velocities(end, *y);
    }
  } catch (const Error&) {
    return !rarely;
  }
  const DifferencesOfParts lasting = differences(dynamics_.system(), ours, others);
  const DifferencesOfParts rounded = rounding(dynamics_.system(), step.y_new);
  bool found = !rarely;
  for (std::size_t k = 0; k < lasting.size(); ++k) {
    const double all = out.of_part[k].end.velocity, noise = rounded[k].position / step.h;
    if (rarely && (lasting[k].velocity > little * all || all < above_noise * noise)) continue;
    out.of_part[k].fading = std::exchange(out.of_part[k].end, lasting[k]);
    out.of_part[k].fading.scale(factor_ / std::fmin(share, 1.0));
    found = true;
  }
  return found;
}

/// What friction that sticks and stiff dampers take back does not add up.
void StepJudge::separate_damped(const KeptStep& step, StepError& out) {
  const VectorXd history = dynamics_.history();
  dynamics_.set_history(step.history_new.size() > 0 ? step.history_new : step.history);
  std::vector<DampedError> found;
  try {
    found = find_damped_errors(dynamics_, span_.at(1.0), step.h, step.y_new, y_);
  } catch (const Error&) {  // then all of it adds up
  }
  dynamics_.set_history(history);
  for (std::size_t k = 0; k < found.size(); ++k) {
    PartError& of_part = out.of_part[k];
    of_part.end.position += found[k].lasting.position;
    of_part.end.rotation += found[k].lasting.rotation;
    of_part.end.velocity = found[k].lasting.velocity;
    of_part.end.omega = found[k].lasting.omega;
    of_part.fading = found[k].fading;
    of_part.fading.scale(factor_);
  }
}

void StepJudge::look_at_motion(const KeptStep& step, StepError& out) {
  const System& system = dynamics_.system();
  const VectorXd& a = step.y_new;
  seen_ = a;
  axes_.see(step.t + step.h, seen_);
  for (int body = 0; body < system.body_count(); ++body) {
    const int v = system.q_size() + velocity_size * body, part = connected_.of_body(body);
    PartError& of_part = out.of_part[part];
    const auto rate = [&](int at) { return (a.segment<3>(at) - step.y.segment<3>(at)).norm() / step.h; };
    const double speed = seen_.segment<3>(v).norm(), turning = a.segment<3>(v + 3).norm();
    of_part.speed = std::max({of_part.speed, speed, arms_[part] * turning});
    of_part.body_speed = std::max({of_part.body_speed, speed, violation_.lengths()[part] * turning});
    of_part.acceleration = std::max(of_part.acceleration, rate(v));
    of_part.rounding = std::max(of_part.rounding, lasting_rounding(system, body, step));
    of_part.displacement = std::max(of_part.displacement, a.segment<3>(v).norm() * step.h);
    of_part.spin_rate = std::max(of_part.spin_rate, rate(v + 3));
  }
  out.work = a[a.size() - 1];
  const VectorXd kinetic = kinetic_energies_of(seen_);
  for (Eigen::Index k = 0; k < kinetic.size(); ++k) {
    out.of_part[static_cast<std::size_t>(k)].kinetic = kinetic[k];
    kinetic_of_part_[k] = std::max(kinetic_of_part_[k], kinetic[k]);
  }
  kinetic_ = std::max(kinetic_, kinetic.sum());
  ground_kinetic_ = std::max(ground_kinetic_, kinetic_energies_of(a).sum());
}

VectorXd StepJudge::kinetic_energies_of(const VectorXd& y) const {
  const System& system = dynamics_.system();
  VectorXd twice = VectorXd::Zero(connected_.count());
  for (int body = 0; body < system.body_count(); ++body) {
    const auto v = y.segment<velocity_size>(system.q_size() + velocity_size * body);
    twice[connected_.of_body(body)] +=
        system.mass(body) * v.head<3>().squaredNorm() + v.tail<3>().dot(system.inertia(body) * v.tail<3>());
  }
  return 0.5 * twice;
}

double StepJudge::kinetic_share() const {
  return kinetic_ < ground_kinetic_ && std::isfinite(ground_kinetic_) ? kinetic_ / ground_kinetic_ : 1.0;
}

/// The state that the interpolant of the step gives beside the one to which its first part came.
void StepJudge::compare_inside(const KeptStep& step, StepError& out) {
  dynamics_.set_history(step.history);
  dynamics_.evaluate(span_.at(0.0), step.y);
  if (!stepper_->take(dynamics_, span_, step.y)) return;
  stepper_->prepare_interpolation(dynamics_);
  stepper_->interpolate(dynamics_.system(), take_.share, interpolated_);
  const DifferencesOfParts apart = differences(dynamics_.system(), interpolated_, inside_);
  const DifferencesOfParts unseen = rounding(dynamics_.system(), inside_);
  for (std::size_t k = 0; k < apart.size(); ++k) {
    out.of_part[k].inside = apart[k];
    out.of_part[k].inside.lower(unseen[k]);
  }
}

/// The speed at which a contact begins scales its damping as long as it lasts.
/// Steps that follow tolerances end where a contact begins: whether it has begun there is a matter of roundoff.
void StepJudge::compare_history(const KeptStep& step, StepError& out) {
  const double end = span_.at(1.0);
  dynamics_.evaluate(end, y_);
  dynamics_.advance_history();
  bool at_beginning = false;
  const auto contact = [this](Eigen::Index k) {
    return dynamics_.system().history_owners()[static_cast<std::size_t>(k)].kind == HistoryKind::onset;
  };
  for (Eigen::Index k = 0; k < step.history_new.size(); ++k) {
    if (!contact(k) || dynamics_.history()[k] != 0.0 || step.history_new[k] == 0.0) continue;
    dynamics_.begin_contact(static_cast<int>(k));
    at_beginning = true;
  }
  if (at_beginning) {
    dynamics_.evaluate(end, y_);
    dynamics_.advance_history();
  }
  const VectorXd found = dynamics_.history();
  for (Eigen::Index k = 0; k < found.size(); ++k) {
    if (!contact(k) || step.history_new[k] == 0.0) continue;  // it begins in the next step
    PartError& of_part = out.of_part[connected_.of_history(dynamics_.system(), k)];
    of_part.contact_begins = true;
    of_part.onset = std::max(of_part.onset, by_onset(end, k, found, step.history_new));
    of_part.end.velocity = std::max(of_part.end.velocity, of_part.onset);
  }
}

/// What another speed at which a contact begins makes of that with which it ends: by the share of the force that damps,
/// none of it without hysteresis. Where contact stays each oscillation ends with another speed: by all of it.
double StepJudge::by_onset(double t, Eigen::Index variable, const VectorXd& history, const VectorXd& other) const {
  const System& system = dynamics_.system();
  const auto place = static_cast<int>(variable);
  ForceElement contact(system, system.history_owners()[static_cast<std::size_t>(place)].element, place);
  const auto forces = [&](const VectorXd& of) {
    return contact.forces(t, y_.head(system.q_size()), y_.segment(system.q_size(), system.v_size()), of);
  };
  const auto own = forces(history), others = forces(other);
  double apart = 0.0, whole = 0.0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    apart += (own[k] - others[k]) * (own[k] - others[k]);
    whole += own[k] * own[k];
  }
  if (!(apart > 0.0)) return 0.0;
  if (stays(t, variable)) return std::abs(history[variable] - other[variable]);
  return std::min(std::sqrt(apart / whole), 1.0) * history[variable];
}

/// Whether a contact that begins at t lasts for long, by its history variable, or nobody knows.
bool StepJudge::stays(double t, Eigen::Index variable) const {
  if (!log_ || log_->size() < 2 || log_->t(log_->size() - 1) < t) return true;
  const double begin = log_->t(0), end = log_->t(log_->size() - 1);
  for (std::size_t k = 0; k < log_->size(); ++k)
    if (log_->t(k) > t && log_->history(k)[variable] == 0.0) return log_->t(k) - t > long_contact * (end - begin);
  return end - t > long_contact * (end - begin);
}

void StepJudge::compare_reactions(const KeptStep& step, StepError& out) {
  const double end = span_.at(1.0);
  find_reactions(dynamics_, end, y_, reactions_);
  find_reactions(dynamics_, end, step.y_new, there_);
  look_at_loads(out);
  if (recorded_) find_recorded_reactions(step);
  const std::vector<Element>& joints = dynamics_.system().model().joints();
  for (Eigen::Index k = 0; k < reactions_.force.cols(); ++k) {
    const Element& joint = joints[static_cast<std::size_t>(k)];
    PartError& of_part = out.of_part[connected_.of_bodies(joint.i, joint.j)];
    const auto apart = [k](const Reactions& a, const Reactions& b) {
      return std::pair((a.force.col(k) - b.force.col(k)).norm(), (a.torque.col(k) - b.torque.col(k)).norm());
    };
    raise(of_part.largest_force, of_part.largest_torque, reactions_.force.col(k).norm(),
          reactions_.torque.col(k).norm());
    const auto [force, torque] = apart(reactions_, there_);
    raise(of_part.force, of_part.torque, factor_ * force, factor_ * torque);
    if (!recorded_) continue;
    const auto [yielded_force, yielded_torque] = apart(there_, yielding_);
    raise(of_part.yielded_force, of_part.yielded_torque, yielded_force, yielded_torque);
  }
}

void StepJudge::look_at_loads(StepError& out) {
  const VectorXd& g = dynamics_.evaluation().g;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    const int part = connected_.of_body(body);
    const auto force = g.segment<3>(velocity_size * body), torque = g.segment<3>(velocity_size * body + 3);
    out.of_part[part].load =
        std::max({out.of_part[part].load, force.norm(), torque.norm() / violation_.lengths()[part]});
  }
}

/// Where the run ended the step.
void StepJudge::find_recorded_reactions(const KeptStep& step) {
  recorded_->set_history(dynamics_.history());
  recorded_->evaluate(span_.at(0.0), step.y);
  leave_out(*recorded_, rows_);
  find_reactions(*recorded_, span_.at(1.0), step.y_new, yielding_);
}

void StepJudge::find_reactions(Dynamics& dynamics, double t, const VectorXd& y, Reactions& out) {
  dynamics.evaluate(t, y);
  dynamics.accelerations(v_dot_, lambda_);
  dynamics.reactions(lambda_, out.force, out.torque);
}

}  // namespace linkwork
