#pragma once

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Of the last evaluation.
struct Instant {
  double t = 0.0;
  VectorXd y;
  VectorXd history;
  int stage = 1;
};

}  // namespace linkwork
