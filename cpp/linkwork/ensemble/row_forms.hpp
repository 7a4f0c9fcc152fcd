#pragma once

#include <vector>

#include "linkwork/ensemble/lane_layout.hpp"
#include "linkwork/ensemble/lanes.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {

/// The forms of D_i of the rows of a kind of joint, then those of D_j. They are found at two arbitrary states with
/// arbitrary numbers of a joint: what is 0, 1 or -1 at both is so in every state.
std::vector<RowForm> row_forms(int kind);

/// What is constant in D_i, from number `first` on, and in D_j behind it; evaluations leave it as it is, and so they do
/// with zeros of rotations.
void put_constant_D(const JointKind& kind, const LaneLayout& layout, AlignedDoubles& D, std::ptrdiff_t first);

}  // namespace linkwork
