#pragma once

namespace linkwork {

/// What is known of D of a row and body in every state: the numbers of its translation are zero, or one of them is 1 or
/// -1. What is multiplied by them need not be.
enum class RowForm : unsigned char { general, rotation, x, y, z };

}  // namespace linkwork
