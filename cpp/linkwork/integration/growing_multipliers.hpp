#pragma once

#include <optional>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Toward a singular pose multipliers grow like 1 / s, s the way to it, where forces push along the other branch, too:
///   lambda = a(t) + sum_j b_j / (t - t_j)   with a smooth a and the poses t_j.
/// Whether they do the first one tells, by the others.
///
/// Multipliers at the place `at`, from those at other places; none where they do not grow. Nearer to a pose than
/// `nearest` nobody knows on which side of it a state is. Places and poses: times, in one unit.
std::optional<VectorXd> growing_multipliers(const std::vector<double>& places, const std::vector<VectorXd>& multipliers,
                                            const std::vector<double>& poses, double nearest, double at);

}  // namespace linkwork
