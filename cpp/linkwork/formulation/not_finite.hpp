#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// The error for y = (q, v, work) that is not finite, or from which nothing finite follows. It names what comes first:
/// a body whose state is not finite, a joint whose equations or a force that are not, else the fastest body.
[[noreturn]] void throw_not_finite(const System& system, const VectorXd& y, double t, int stage = 0);

}  // namespace linkwork
