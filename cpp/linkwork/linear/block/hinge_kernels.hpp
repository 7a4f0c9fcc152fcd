#pragma once

#include "linkwork/linear/block/common_kernels.hpp"
#include "linkwork/linear/block/hinge_elimination.hpp"

/// Hinges of deterministic runs, and bodies on hinges and sliders on the ground, which go number by number as those of
/// ensembles do.
namespace linkwork::block {
namespace {

template <int rows, bool scattered>
constexpr bool by_numbers = rows == 5 && !scattered;

constexpr int by_numbers_mark = step_storage(5) - 1;  // in the factors: 1, or 0 where they are those of TreeStep

struct Doubles {
  using Number = double;
  static constexpr std::ptrdiff_t stride = 1;
  static LINKWORK_INLINE double get(const double* from, std::ptrdiff_t k) { return from[k]; }
  static LINKWORK_INLINE void put(double* to, std::ptrdiff_t k, double x) { to[k] = x; }
};

LINKWORK_INLINE const double* articulated_inertia_at(int slot, const Data& data) {
  return slot < 0 ? nullptr : data.articulated_inertias + slot * articulated_inertia_size;
}

/// Of a body or a step, its joint on the ground at D.
template <class Body>
LINKWORK_INLINE GroundPlaces ground_places(const Body& body, std::ptrdiff_t D, std::ptrdiff_t factors, const Data& data,
                                           const double* a) {
  return {.D = data.D + D,
          .articulated_inertia = articulated_inertia_at(body.slot, data),
          .mass = &data.mass[body.body].m,
          .a = a + 6 * body.body,
          .factors = data.factors + factors};
}

/// Calls f with the elimination on a hinge or on a slider.
template <class Function>
LINKWORK_INLINE auto with_ground_joint(bool slides, const GroundPlaces& places, const Function& f) {
  if (slides) return f(GroundElimination<Doubles, SliderOnGround>(places));
  return f(GroundElimination<Doubles, HingeOnGround>(places));
}

LINKWORK_INLINE HingeElimination<Doubles> hinge_of(const TreeStep& step, const Data& data, const double* a) {
  return HingeElimination<Doubles>({.D_body = data.D + step.D_body,
                                    .D_parent = data.D + step.D_parent,
                                    .articulated_inertia = articulated_inertia_at(step.slot, data),
                                    .mass = &data.mass[step.body].m,
                                    .a = a + 6 * step.body,
                                    .factors = data.factors + step.storage});
}

/// Both triangles, as other kernels have them.
LINKWORK_INLINE void add_to_parent(const TreeStep& step, const Data& data, const double* a,
                                   const HingeElimination<Doubles>& hinge) {
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

/// The smallest mass or moment that counts as a pivot.
LINKWORK_INLINE double least_pivot(bool mass, const TreeStep& step, const Data& data) {
  if (!data.ballast) return 0.0;
  return mass ? data.ballast[step.body].least_mass : data.ballast[step.body].least_moment;
}

/// Keeps in mind that there is no such inertia.
LINKWORK_INLINE void note_inertia(SmallestPivot& smallest, double pivot, double least, int row) {
  if (!(pivot > least)) smallest = {pivot == pivot ? 0.0 : not_a_number, row};
}

/// False where the joint is violated by far; then nothing is done.
template <class Elimination>
LINKWORK_INLINE bool eliminate_joint(Elimination& joint, const TreeStep& step, const Data& data, const double* b,
                                     SmallestPivot& smallest) {
  if (!(joint.read(b + step.row) > least_size)) return false;
  note_inertia(smallest, joint.release(), least_pivot(step.slides, step, data), step.row);
  return true;
}

LINKWORK_INLINE bool factor_on_body(const TreeStep& step, const Data& data, const double* a, const double* b,
                                    SmallestPivot& smallest) {
  auto hinge = hinge_of(step, data, a);
  if (!eliminate_joint(hinge, step, data, b, smallest)) return false;
  add_to_parent(step, data, a, hinge);
  hinge.store_way_back();
  return true;
}

bool factor_on_ground(const TreeStep& step, const Data& data, const double* a, const double* b,
                      SmallestPivot& smallest) {
  return with_ground_joint(step.slides, ground_places(step, step.D_body, step.storage, data, a), [&](auto joint) {
    if (!eliminate_joint(joint, step, data, b, smallest)) return false;
    joint.store_way_back();
    return true;
  });
}

/// Steps that have the form; those of hinges have another one in wide registers.
LINKWORK_INLINE bool goes_by_numbers(const TreeStep& step) {
  return (step.slides && step.parent < 0) || (width == 2 && step.turning);
}

/// False where the joint is of another kind, or yields; then nothing is done.
LINKWORK_INLINE bool factor_by_numbers(const TreeStep& step, const Data& data, const double* a, const double* b,
                                       SmallestPivot& smallest) {
  bool done = goes_by_numbers(step);
  for (int k = 0; data.e && k < step.rows; ++k) done = done && data.e[step.row + k] == 0.0;
  if (done) {
    if (step.parent < 0) done = factor_on_ground(step, data, a, b, smallest);
    else if constexpr (width == 2) done = factor_on_body(step, data, a, b, smallest);
  }
  data.factors[step.storage + by_numbers_mark] = done ? 1.0 : 0.0;
  return done;
}

/// False where the factors are those of another kind.
LINKWORK_INLINE bool back_by_numbers(const TreeStep& step, const Data& data, double* x, double* lambda) {
  if (data.factors[step.storage + by_numbers_mark] == 0.0) return false;
  double* x_body = x + 6 * step.body;
  if (step.parent < 0) {
    const double none[6]{};
    with_ground_joint(step.slides, ground_places(step, step.D_body, step.storage, data, x),
                      [&](auto joint) { joint.go_back(none, x_body, lambda + step.row); });
  } else if constexpr (width == 2) {
    hinge_of(step, data, x).go_back(x + 6 * step.parent, x_body, lambda + step.row);
  }
  if (step.slot >= 0) leave_for_children(load_first<6>(x_body), step.slot, data);
  return true;
}

}  // namespace
}  // namespace linkwork::block
