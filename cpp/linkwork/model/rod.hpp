#pragma once

#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {

/// What massless rods have in common: two points keep a distance, constant or a function of time (1 equation).
struct Rod {
  static constexpr int rows = 1;

  static ParameterInfo length() {
    return {"length",
            "m",
            "of the rod",
            Takes::differentiable,
            {.initial_distance = true, .example = 1.0, .bounds = positive}};
  }

  template <class Real>
  static void evaluate(const Attachment<Real>& at, const Signal<Real>* parameters, const BodyState<Real>& i,
                       const BodyState<Real>& j, Rows<Real, rows> out) {
    separation<Real>(i, j, at.s_i, at.s_j, parameters[0], out);
  }
};

}  // namespace linkwork
