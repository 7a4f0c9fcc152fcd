#pragma once

#include "linkwork/ensemble/lane_elimination.hpp"

/// Fronts of closed loops of all lanes: where their numbers stand.
namespace linkwork {
namespace {

using block::Front;

/// Where the numbers of a front stand.
struct FrontPlace {
  const Front& front;
  double* panel;
  double* contribution;

  LINKWORK_INLINE FrontPlace(const Front& f, const LaneData& data)
      : front(f), panel(data.panels + f.panel * width), contribution(data.contributions + f.contribution * width) {}
  /// The column at a position, such that its entry at position p is number p.
  LINKWORK_INLINE double* column(int position) const {
    if (position < front.top) return panel + static_cast<std::ptrdiff_t>(position) * front.stride() * width;
    return contribution +
           (static_cast<std::ptrdiff_t>(position - front.top) * front.contribution_rows - front.top) * width;
  }
  LINKWORK_INLINE double* right() const {
    return panel + static_cast<std::ptrdiff_t>(front.width) * front.stride() * width;
  }
  LINKWORK_INLINE double* diagonal() const { return right() + static_cast<std::ptrdiff_t>(front.stride()) * width; }
  LINKWORK_INLINE int last() const { return front.top + front.size - front.width; }  ///< behind the kept ones
  /// The next position that is in use.
  LINKWORK_INLINE int next(int position) const { return position + 1 == front.width ? front.top : position + 1; }
};

LINKWORK_INLINE void clear_range(double* list, int begin, int end) {
  for (int p = begin; p < end; ++p) {
    put(list, p, Native{});
    asm volatile("" ::: "memory");  // ranges are too short for a call of memset, which this would become
  }
}

void clear_list(double* list, const FrontPlace& at) {
  clear_range(list, 0, at.front.width);
  clear_range(list, at.front.top, at.last());
}

void clear(const Front& front, const LaneData& data) {
  const FrontPlace at(front, data);
  const int own = front.width, top = front.top, last = at.last();
  for (int c = 0; c < own; ++c) {
    double* column = at.column(c);
    clear_range(column, c, own);
    clear_range(column, top, last);
  }
  for (int c = top; c < last; ++c) clear_range(at.column(c), c, last);
  clear_list(at.right(), at);
  clear_list(at.diagonal(), at);
}

}  // namespace
}  // namespace linkwork
