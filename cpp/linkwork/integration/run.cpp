#include "linkwork/integration/run.hpp"

#include <chrono>
#include <cstdio>

namespace linkwork {
namespace {

constexpr std::size_t listed = 8;  // joints in a message

[[noreturn]] void throw_violation(const Dynamics& dynamics, const Excess& excess) {
  constexpr const char* levels[] = {"position", "velocity", "acceleration"};
  const Model& model = dynamics.system().model();
  char values[64];
  std::snprintf(values, sizeof values, "%.2g, limit %.2g", excess.largest,
                dynamics.options().violation_limit[static_cast<std::size_t>(excess.level)]);
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

Frames Run::advance(std::int64_t max_frames, double max_seconds) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  while (!finished_ && static_cast<std::int64_t>(recorder_.count()) < max_frames) {
    work();
    stop_at_singular_pose();
    if (std::chrono::duration<double>(Clock::now() - start).count() > max_seconds) break;
  }
  return recorder_.take();
}

void Run::stop_at_singular_pose() const {
  if (!stops_ || dynamics_.watch().singular_poses() == singular_poses_) return;
  const SingularPassage& passage = dynamics_.watch().passages().back();
  ErrorDetails details;
  details.time = passage.t;
  std::string names;
  for (const int joint : passage.joints) {
    details.joints.push_back(dynamics_.system().model().joint_name(joint));
    if (details.joints.size() <= listed) names += (names.empty() ? "'" : ", '") + details.joints.back() + "'";
  }
  if (passage.joints.size() > listed) names += " and " + std::to_string(passage.joints.size() - listed) + " more";
  throw SingularSystemError("singular_pose",
                            "singular pose: the equations of " + names +
                                " depend on each other for a moment, where the motion may go on in several ways; "
                                "on_singular 'pass' or 'warn' goes on",
                            details);
}

void Run::keep_to_budget(double t) {
  const std::int64_t before = budget_.count();
  const bool drifted = budget_.exceeded(t);
  const std::string& policy = dynamics_.options().on_violation;
  if (policy == "stop" && budget_.count() > before) throw_violation(dynamics_, budget_.excesses().back());
  if (policy != "project" || !drifted) return;
  projection().positions(t, y_);
  projection().velocities(t, y_);
  projections_ += 1;
  dynamics_.evaluate(t, y_);
  accept_history();
}

void Run::begin_at(double t, double t_end, const VectorXd& q_and_v) {
  if (!std::isfinite(t) || t > t_end) throw OptionError("start", "the start must not be after t_end");
  if (q_and_v.size() == 0) return;
  if (q_and_v.size() != y_.size() - 1 || !q_and_v.allFinite())
    throw OptionError("start", "the state at the start has " + std::to_string(q_and_v.size()) + " numbers, not " +
                                   std::to_string(y_.size() - 1) + ", or one that is not finite");
  y_.head(q_and_v.size()) = q_and_v;
}

}  // namespace linkwork
