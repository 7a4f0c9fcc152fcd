#pragma once

#include <algorithm>
#include <cstddef>

#include "linkwork/math/thread_pool.hpp"

namespace linkwork {

/// Calls part(first, count) for pieces of a vector of so many numbers, of which several fit into a core's own cache.
template <class Part>
void in_pieces(ThreadPool& threads, std::ptrdiff_t size, const Part& part) {
  constexpr std::ptrdiff_t piece = 16384;
  if (size <= piece) return part(0, size);
  threads.run(static_cast<int>((size + piece - 1) / piece), [&](int k, int) {
    const std::ptrdiff_t first = k * piece;
    part(first, std::min(piece, size - first));
  });
}

}  // namespace linkwork
