#pragma once

#include "linkwork/linear/block/common_kernels.hpp"
#include "linkwork/linear/block/hinge_elimination.hpp"

/// Hinges of deterministic runs, and those that hold bodies of closed loops on the ground, which go number by number as
/// those of ensembles do.
namespace linkwork::block {
namespace {

template <int rows, bool scattered>
constexpr bool by_numbers = width == 2 && rows == 5 && !scattered;

constexpr int by_numbers_mark = step_storage(5) - 1;  // in the factors: 1, or 0 where they are those of TreeStep

struct Doubles {
  using Number = double;
  static LINKWORK_INLINE double get(const double* from, std::ptrdiff_t k) { return from[k]; }
  static LINKWORK_INLINE void put(double* to, std::ptrdiff_t k, double x) { to[k] = x; }
};

LINKWORK_INLINE const double* articulated_inertia_at(int slot, const Data& data) {
  return slot < 0 ? nullptr : data.articulated_inertias + slot * articulated_inertia_size;
}

template <bool grounded>
LINKWORK_INLINE HingeElimination<Doubles, grounded> hinge_of(const TreeStep& step, const Data& data, const double* a) {
  return HingeElimination<Doubles, grounded>({.D_body = data.D + step.D_body,
                                              .D_parent = data.D + step.D_parent,
                                              .articulated_inertia = articulated_inertia_at(step.slot, data),
                                              .mass = &data.mass[step.body].m,
                                              .a = a + 6 * step.body,
                                              .factors = data.factors + step.storage});
}

/// Both triangles, as other kernels have them.
LINKWORK_INLINE void add_to_parent(const TreeStep& step, const Data& data, const double* a,
                                   const HingeElimination<Doubles, false>& hinge) {
  double* to = data.articulated_inertias + step.parent_slot * articulated_inertia_size;
  if (step.parent_begins) LINKWORK_UNROLL
    for (int c = 0; c < 6; ++c) store(to + c * lanes, mass_column(data.mass[step.parent], c, a[6 * step.parent + c]));
  LINKWORK_UNROLL for (int c = 0; c < 6; ++c) LINKWORK_UNROLL
    for (int r = c; r < 7; ++r) {
      const double sum = to[lanes * c + r] + hinge.parent(c, r);
      to[lanes * c + r] = sum;
      if (r < 6) to[lanes * r + c] = sum;
    }
}

template <bool grounded>
LINKWORK_INLINE bool factor_hinge_of(const TreeStep& step, const Data& data, const double* a, const double* b,
                                     SmallestPivot& smallest) {
  auto hinge = hinge_of<grounded>(step, data, a);
  if (!(hinge.read(b + step.row) > least_size)) return false;
  const double pivot = hinge.release();
  if (!(pivot > 0.0)) smallest = {pivot == pivot ? 0.0 : not_a_number, step.row};
  if constexpr (!grounded) add_to_parent(step, data, a, hinge);
  hinge.store_way_back();
  return true;
}

/// False where the joint is of another kind, or yields; then nothing is done.
LINKWORK_INLINE bool factor_hinge(const TreeStep& step, const Data& data, const double* a, const double* b,
                                  SmallestPivot& smallest) {
  bool done = step.turning;
  for (int k = 0; data.e && k < step.rows; ++k) done = done && data.e[step.row + k] == 0.0;
  if (done) {
    if (step.parent < 0) done = factor_hinge_of<true>(step, data, a, b, smallest);
    else done = factor_hinge_of<false>(step, data, a, b, smallest);
  }
  data.factors[step.storage + by_numbers_mark] = done ? 1.0 : 0.0;
  return done;
}

/// False where the factors are those of another kind.
LINKWORK_INLINE bool hinge_back(const TreeStep& step, const Data& data, double* x, double* lambda) {
  if (data.factors[step.storage + by_numbers_mark] == 0.0) return false;
  double* x_body = x + 6 * step.body;
  if (step.parent < 0) hinge_of<true>(step, data, x).go_back(nullptr, x_body, lambda + step.row);
  else hinge_of<false>(step, data, x).go_back(x + 6 * step.parent, x_body, lambda + step.row);
  if (step.slot >= 0) leave_for_children(load_first<6>(x_body), step.slot, data);
  return true;
}

}  // namespace
}  // namespace linkwork::block
