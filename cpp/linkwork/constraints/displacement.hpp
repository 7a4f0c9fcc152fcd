#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Displaces the bodies of q, the first 7 entries per body of a state, by x, 6 per body: r += x_r, p = p exp(x_omega).
void displace(const System& system, const VectorXd& x, VectorXd& q);

}  // namespace linkwork
