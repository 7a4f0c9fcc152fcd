#pragma once

#include <vector>

#include "linkwork/model/row_form.hpp"

namespace linkwork {

/// D of a kind of joint in every state.
struct RowForms {
  std::vector<RowForm> rows;  ///< of D_i, then those of D_j
  bool holds_point;           ///< by the first three rows, D_i = [s I, K_i] and D_j = [-s I, K_j] with s = 1 or -1;
                              ///< the others are of rotation
};

/// They are found at two arbitrary states with arbitrary numbers of a joint: what is 0, 1 or -1 at both is so in every
/// state.
const RowForms& row_forms(int kind);

}  // namespace linkwork
