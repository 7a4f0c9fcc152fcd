#pragma once

#include "linkwork/linear/block/common_kernels.hpp"

namespace linkwork::block {
namespace {

/// Factors that are written past the caches: gathered here, and sent off two steps later, because what was only just
/// stored in parts is not read again at once.
class StreamedFactors {
 public:
  LINKWORK_INLINE explicit StreamedFactors(const Data& data) : data_(data) {}

  /// Where those of a step go.
  LINKWORK_INLINE double* begin(const TreeStep& step) {
    double* const place = data_.factors + step.storage;
    if (step.storage >= data_.streamed) return place;
    Gathered& next = gathered_[turn_];
    turn_ = 1 - turn_;
    send(next);
    next.place = place;
    next.count = static_cast<int>(step_storage(step.rows));
    return next.factors;
  }
  LINKWORK_INLINE void end() {
    if (data_.streamed == 0) return;
    for (Gathered& it : gathered_) send(it);
    end_stream();
  }

 private:
  struct Gathered {
    alignas(64) double factors[step_storage(6)];
    double* place = nullptr;
    int count = 0;
  };
  static LINKWORK_INLINE void send(const Gathered& it) {
    for (int k = 0; k < it.count; k += width) stream_native(it.place + k, load_native(it.factors + k));
  }

  const Data& data_;
  Gathered gathered_[2];
  int turn_ = 0;
};

}  // namespace
}  // namespace linkwork::block
