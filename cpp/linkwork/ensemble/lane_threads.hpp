#pragma once

#include <functional>
#include <vector>

namespace linkwork {

/// Calls what it is given now and then; what that throws ends the task.
using LaneTask = std::function<void(const std::function<void()>& look)>;

/// Runs tasks on some threads, by the arithmetic that is the same on every processor. The first error of one ends all
/// others and is thrown; so does an interruption.
void run_on_threads(const std::vector<LaneTask>& tasks, int threads);

}  // namespace linkwork
