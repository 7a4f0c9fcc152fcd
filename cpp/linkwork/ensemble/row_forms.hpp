#pragma once

#include <vector>

#include "linkwork/ensemble/lanes.hpp"

namespace linkwork {

/// The forms of D_i of the rows of a kind of joint, then those of D_j. They are found at two arbitrary states with
/// arbitrary numbers of a joint: what is 0, 1 or -1 at both is so in every state.
std::vector<RowForm> row_forms(int kind);

}  // namespace linkwork
