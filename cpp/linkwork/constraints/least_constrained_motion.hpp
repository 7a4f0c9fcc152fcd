#pragma once

#include <string>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// The motion without inertia of a body that its joints resist least, in words: "its rotation about (1, 0, 0) in body
/// axes" or "its translation along (0, 0, 1)".
std::string describe_least_constrained_motion(const System& system, const Evaluation& at, int body);

}  // namespace linkwork
