#include "linkwork/integration/run.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/math/names.hpp"

namespace linkwork {
namespace {

constexpr std::size_t listed = 8;        // joints in a message
constexpr double unit_tolerance = 1e-6;  // of |p| - 1 at the start, as in Model
constexpr double unit_roundoff = 1e-14;  // below, p stays as it is: a run goes on with the bits of the one before

// Contradictions, relative to the size and the speed of the mechanism, that end a run: of positions; of velocities
// where that of positions is `certain`. What is less may be the inaccuracy of tables, and is told at the end.
constexpr double unbearable = 1e-3, unbearable_speed = 1e-2, certain = 1e-7;

[[noreturn]] void throw_violation(const Dynamics& dynamics, const Excess& excess) {
  constexpr const char* levels[] = {"position", "velocity", "acceleration"};
  const Model& model = dynamics.system().model();
  char values[64];
  std::snprintf(values, sizeof values, "%.2g, limit %.2g", excess.largest,
                dynamics.options().violation_limit[excess.level]);
  ErrorDetails details;
  details.time = excess.t;
  details.joints = {model.joint_name(model.joint_of_row(excess.row))};
  details.residuals = {{details.joints.front(), excess.largest}};
  throw ViolationError("violation",
                       model.describe_row(excess.row) + ": violated in " + levels[excess.level] + " (" + values +
                           "); use a smaller step, another stabilization, or on_violation 'project'",
                       details);
}

}  // namespace

bool keeps_drift(const Dynamics& dynamics) {
  if (!dynamics.sampled()) return dynamics.stabilization() != StabilizationKind::projection;
  return dynamics.options().baumgarte_alpha || dynamics.options().baumgarte_beta;  // else it is gone in two steps
}

void Run::run_on(std::int64_t max_frames, double max_seconds) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  due_ = true;
  while (!finished_ && static_cast<std::int64_t>(recorder_.count()) < max_frames) {
    take_step();
    stop_at_singular_pose();
    if (std::chrono::duration<double>(Clock::now() - start).count() > max_seconds) break;
  }
}

/// A checkpoint counts with the first frame that is not before it.
Frames Run::take_frames(bool at_the_end) {
  if (at_the_end) recorder_.finish();
  Frames frames = recorder_.take();
  if (!frames.t.empty() && frames.t.back() >= latest_.t) settled_ = std::exchange(latest_, {});
  due_ = true;
  return frames;
}

void Run::mark(bool last) {
  if (repeating_ && past_start()) {
    repeating_ = false;
    steps_before_ = steps_done_;
    sampling_.begin_anew(dynamics_, y_, start());
  }
  const bool marks = !bounded_ && !repeating_ && (due_ || last);
  bounded_ = bounded_ || last;
  if (!marks) return;
  due_ = false;
  Archive archive;
  keep(archive);
  latest_ = {t(), archive.take()};
}

void Run::resume(const std::string& state, double work) {
  y_[y_.size() - 1] = work;
  try {
    record_start();
  } catch (const Error&) {  // in a singular pose, where only those can go on that were there before
  }
  recorder_.silence_until(t());
  dynamics_.formulation().watch().silence_until(t());
  singular_poses_ = 0;
  const Eigen::Index size = y_.size();
  Archive archive(state);
  keep(archive);
  archive.finish();
  if (y_.size() != size) throw OptionError("start", "start: what it has to go on from is of another model");
  steps_before_ = steps_done_;
  repeating_ = resumed_ = true;
  settled_ = {t(), state};
}

void Run::stop_at_singular_pose() const {
  if (!stops_ || dynamics_.watch().singular_poses() == singular_poses_) return;
  const SingularityCrossing& crossing = dynamics_.watch().crossings().back();
  ErrorDetails details;
  details.time = crossing.t;
  for (const int joint : crossing.joints) details.joints.push_back(dynamics_.system().model().joint_name(joint));
  throw SingularSystemError("singular_pose",
                            "singular pose: the equations of " + quoted(details.joints, ", ", listed) +
                                " depend on each other for a moment, where the motion may go on in several ways; "
                                "on_singular 'pass' or 'warn' goes on",
                            details);
}

void Run::watch_redundant_rows(double t) {
  const System& system = dynamics_.system();
  const auto v = y_.segment(system.q_size(), system.v_size());
  if (!redundancy_.suspicious(system, dynamics_.evaluation(), dynamics_.dropped(), v)) return;
  if (redundancy_.excess().kept > unbearable) return;  // it has left the joints altogether
  const VectorXd q = y_.head(system.q_size());
  RedundancyExamination found = examine_redundancy(system, {t, q, dynamics_.history()}, dynamics_.dropped().rows());
  if (found.changed) return take_up_rows(t, std::move(found));
  // Whatever the reason: where the equations are left so far, they are not those of the motion any more.
  if (found.contradicts) note_contradiction(t, std::move(found.joints), true);
  else if (!found.consistent || redundancy_.excess().position > unbearable) note_contradiction(t, left_joints(), false);
  redundancy_.suspect_less();
}

/// Joints of the redundant rows that are violated most.
std::vector<int> Run::left_joints() const {
  const VectorXd& Phi = dynamics_.evaluation().Phi;
  std::vector<int> joints;
  for (const int row : dynamics_.dropped().rows()) {
    const int joint = dynamics_.system().model().joint_of_row(row);
    if (2.0 * std::abs(Phi[row]) > redundancy_.excess().Phi && (joints.empty() || joints.back() != joint))
      joints.push_back(joint);
  }
  return joints;
}

/// The state changes a little; the work takes up the energy.
void Run::take_up_rows(double t, RedundancyExamination found) {
  const System& system = dynamics_.system();
  const auto energy = [&] {
    return system.kinetic_energy(dynamics_.evaluation(), y_.segment(system.q_size(), system.v_size())) +
           dynamics_.evaluation().potential;
  };
  const double before = energy();
  const Model& model = system.model();
  std::vector<int> joints;
  for (const int row : dynamics_.dropped().rows())
    if (!std::binary_search(found.choice.begin(), found.choice.end(), row))
      if (const int joint = model.joint_of_row(row); joints.empty() || joints.back() != joint) joints.push_back(joint);
  y_.head(system.q_size()) = found.q;
  dynamics_.evaluate(t, y_);
  dynamics_.formulation().change_redundant_rows(std::move(found.choice), std::move(joints));
  left_out_ = dynamics_.dropped().rows();
  projection().positions(t, y_);
  projection().velocities(t, y_);
  dynamics_.evaluate(t, y_);
  y_[y_.size() - 1] += energy() - before;
  sampling_.strike();
  contradiction_ = {};  // so near to where they were redundant it could not be told from this
  forget();
}

void Run::note_contradiction(double t, std::vector<int> joints, bool certainly) {
  const RedundancyWatch::Excess& excess = redundancy_.excess();
  if (std::isnan(contradiction_.t)) contradiction_ = {t, 0.0, joints};
  contradiction_.largest = std::max(contradiction_.largest, excess.Phi);
  const bool fast = certainly && excess.velocity > unbearable_speed && excess.position > certain;
  const bool large = excess.position > unbearable || fast;
  if (!large && dynamics_.options().on_violation != "stop") return;
  const Model& model = dynamics_.system().model();
  ErrorDetails details;
  details.time = t;
  for (const int joint : joints) details.joints.push_back(model.joint_name(joint));
  if (!details.joints.empty()) details.residuals = {{details.joints.front(), excess.Phi}};
  char size[96];
  std::snprintf(size, sizeof size, "by %.2g (m or 1), and by %.2g of the speed", excess.Phi, excess.velocity);
  throw ViolationError("contradiction",
                       "joints or drivers " + quoted(details.joints, ", ", listed) + " contradict each other " + size +
                           ": no pose near satisfies them all; drive what is free once only, or by motions that "
                           "agree; where it is drift, use a smaller step or another stabilization",
                       details);
}

/// To the constraints.
void Run::take_back(double t) {
  const VectorXd y_before = y_;
  projection().positions(t, y_);
  projection().velocities(t, y_);
  sampling_.correct(y_before, y_);
  dynamics_.evaluate(t, y_);
  accept_history();
}

/// Beside a singular pose there may be no way back: the run goes on from where it is.
void Run::take_back_where_rows_changed(double t) {
  if (dynamics_.dropped().rows() == left_out_) return;
  left_out_ = dynamics_.dropped().rows();
  if (!keeps_drift(dynamics_)) return;
  const VectorXd y_before = y_;
  try {
    take_back(t);
  } catch (const NotConvergedError&) {
    y_ = y_before;
    dynamics_.evaluate(t, y_);
  }
}

void Run::monitor_violation(double t) {
  take_back_where_rows_changed(t);
  watch_redundant_rows(t);
  const std::int64_t before = violation_monitor_.count();
  const bool drifted = violation_monitor_.exceeded(t);
  const std::string& policy = dynamics_.options().on_violation;
  if (policy == "stop" && violation_monitor_.count() > before)
    throw_violation(dynamics_, violation_monitor_.excesses().back());
  if (policy != "project" || !drifted) return;
  take_back(t);
  projections_ += 1;
}

void Run::begin_at(double t, double t_end, const VectorXd& q_and_v) {
  if (!std::isfinite(t) || t > t_end) throw OptionError("start", "the start must not be after t_end");
  if (q_and_v.size() == 0) return;
  if (q_and_v.size() != y_.size() - 1 || !q_and_v.allFinite())
    throw OptionError("start", "the state at the start has " + std::to_string(q_and_v.size()) + " numbers, not " +
                                   std::to_string(y_.size() - 1) + ", or one that is not finite");
  y_.head(q_and_v.size()) = q_and_v;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    auto p = y_.segment<4>(7 * body + 3);
    const double off = std::abs(p.norm() - 1.0);
    if (!(off <= unit_tolerance))
      throw OptionError("start", "start: body '" + dynamics_.system().model().body_name(body) +
                                     "': its Euler parameters have norm " + std::to_string(p.norm()) +
                                     ", not 1: divide them by it");
    if (off > unit_roundoff) p.normalize();
  }
}

}  // namespace linkwork
