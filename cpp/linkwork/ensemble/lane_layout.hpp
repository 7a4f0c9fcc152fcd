#pragma once

#include <algorithm>
#include <cstddef>

#include "linkwork/math/aligned.hpp"
#include "linkwork/math/types.hpp"

namespace linkwork {

/// How numbers of mechanisms in lanes stand in memory: `width` of each side by side, one of each mechanism.
struct LaneLayout {
  int width;

  void size(AlignedDoubles& numbers, std::ptrdiff_t count) const { numbers.assign(count * width, 0.0); }
  std::ptrdiff_t index(std::ptrdiff_t k, int l) const { return k * width + l; }
  double* place(AlignedDoubles& numbers, std::ptrdiff_t k, int l) const { return numbers.data() + index(k, l); }
  /// Numbers of lane l from the `first` on.
  void take(const AlignedDoubles& numbers, int l, std::ptrdiff_t first, MutableVector out) const {
    const double* from = numbers.data() + first * width + l;
    for (Eigen::Index k = 0; k < out.size(); ++k) out[k] = from[k * width];
  }
  void give(const double* from, std::ptrdiff_t count, int l, AlignedDoubles& to, std::ptrdiff_t first) const {
    double* place = to.data() + first * width + l;
    for (std::ptrdiff_t k = 0; k < count; ++k) place[k * width] = from[k];
  }
  void clear(AlignedDoubles& numbers, std::ptrdiff_t first, std::ptrdiff_t count) const {
    std::fill_n(numbers.begin() + first * width, count * width, 0.0);
  }
};

}  // namespace linkwork
