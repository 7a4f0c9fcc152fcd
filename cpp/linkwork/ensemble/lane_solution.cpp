// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/ensemble/lane_loops.hpp"
#include "linkwork/ensemble/lane_trees.hpp"

namespace linkwork {
namespace {

/// The memory of `scratch` behind that of bodies, which need none while joints are eliminated.
EliminationScratch elimination_scratch(const LaneData& data) {
  std::ptrdiff_t highest = 0;
  for (std::ptrdiff_t f = 0; f < data.front_count; ++f)
    if (data.fronts[f].stride() > highest) highest = data.fronts[f].stride();
  return {data.scratch, data.scratch + at_once * highest * width};
}

void factor(const LaneData& data, const double* a, const double* b, double* smallest) {
  SmallestPivots pivots{.breakdown = data.breakdown};
  factor_branches(data, a, b, pivots);
  factor_loops(data, a, b, elimination_scratch(data), pivots);
  put(smallest, 0, pivots.ratio);
}

void forward(const LaneData& data, const double* a, const double* b) {
  SmallestPivots unchanged;
  factor_branches(data, a, b, unchanged);
  forward_loops(data, a, b);
}

void backward(const LaneData& data, const double* a, double* x, double* lambda) {
  backward_loops(data, a, x, lambda);
  backward_branches(data, x, lambda);
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(lane_elimination_, ISA)

extern const LaneElimination LINKWORK_NAME(LINKWORK_ISA);
const LaneElimination LINKWORK_NAME(LINKWORK_ISA) = {&factor, &forward, &backward};

}  // namespace linkwork
