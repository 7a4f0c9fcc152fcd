#include "linkwork/integration/run.hpp"

#include <chrono>

namespace linkwork {
namespace {

constexpr std::size_t listed = 8;  // joints in a message

}  // namespace

Frames Run::advance(std::int64_t max_frames, double max_seconds) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  while (!finished_ && static_cast<std::int64_t>(recorder_.count()) < max_frames) {
    work();
    stop_at_singular_pose();
    if (std::chrono::duration<double>(Clock::now() - start).count() > max_seconds) break;
  }
  return take_frames();
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

}  // namespace linkwork
