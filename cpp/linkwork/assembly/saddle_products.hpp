#pragma once

#include "linkwork/assembly/constraint_block.hpp"

/// Products with M and D block by block, and sizes of motions, of one mechanism or of one in each lane of a register:
/// in one order of operations, so that both have the same bits. `Access` says what a number is, and how number k of a
/// list is read and written: `Number`, `get(from, k)`, `put(to, k, x)`, `root(x)`.
namespace linkwork::saddle_products {

/// One mechanism.
struct Doubles {
  using Number = double;
  static double get(const double* from, std::ptrdiff_t k) { return from[k]; }
  static void put(double* to, std::ptrdiff_t k, double x) { to[k] = x; }
  static double root(double x) { return __builtin_sqrt(x); }
};

/// y = M x of one body; `mass`: 10 numbers a body, m and J row by row.
template <class Access>
inline void multiply_mass(int body, const double* mass, const double* x, double* y) {
  const std::ptrdiff_t M = 10 * std::ptrdiff_t{body}, first = 6 * std::ptrdiff_t{body};
  typename Access::Number in[6];
  for (int k = 0; k < 6; ++k) in[k] = Access::get(x, first + k);
  const auto m = Access::get(mass, M);
  for (int k = 0; k < 3; ++k) Access::put(y, first + k, m * in[k]);
  for (int k = 0; k < 3; ++k)
    Access::put(y, first + 3 + k,
                Access::get(mass, M + 1 + 3 * k) * in[3] + Access::get(mass, M + 2 + 3 * k) * in[4] +
                    Access::get(mass, M + 3 + 3 * k) * in[5]);
}

/// y += D_b x_b in the rows of a block.
template <class Access>
inline void add_D(const ConstraintBlock& block, const double* D, const double* x, double* y) {
  typename Access::Number in[6];
  for (int k = 0; k < 6; ++k) in[k] = Access::get(x, 6 * std::ptrdiff_t{block.body} + k);
  for (int r = 0; r < block.rows; ++r) {
    const auto term = [&](int k) { return Access::get(D, block.offset + 6 * r + k) * in[k]; };
    const auto translation = term(0) + term(1) + term(2), rotation = term(3) + term(4) + term(5);
    Access::put(y, block.row + r, Access::get(y, block.row + r) + (translation + rotation));
  }
}

/// y_b += D_b^T lambda of the rows of a block. These are added up by themselves: where they cancel each other, y_b
/// keeps its digits.
template <class Access>
inline void add_D_transposed(const ConstraintBlock& block, const double* D, const double* lambda, double* y) {
  typename Access::Number sum[6];
  for (int r = 0; r < block.rows; ++r) {
    const auto factor = Access::get(lambda, block.row + r);
    for (int k = 0; k < 6; ++k) {
      const auto term = Access::get(D, block.offset + 6 * r + k) * factor;
      sum[k] = r == 0 ? term : sum[k] + term;
    }
  }
  for (int k = 0; k < 6 && block.rows > 0; ++k) {
    const std::ptrdiff_t place = 6 * std::ptrdiff_t{block.body} + k;
    Access::put(y, place, Access::get(y, place) + sum[k]);
  }
}

template <class Access>
inline auto length(const double* x, std::ptrdiff_t first) {
  const auto a = Access::get(x, first), b = Access::get(x, first + 1), c = Access::get(x, first + 2);
  return Access::root(a * a + b * b + c * c);
}

/// Of a body's translation and rotation; `lengths`, one a body, make them comparable.
template <class Access>
inline auto size(int body, const double* lengths, const double* x) {
  const std::ptrdiff_t first = 6 * std::ptrdiff_t{body};
  return length<Access>(x, first) + Access::get(lengths, body) * length<Access>(x, first + 3);
}

/// Of the force and the torque on a body.
template <class Access>
inline auto size_of_forces(int body, const double* lengths, const double* a) {
  const std::ptrdiff_t first = 6 * std::ptrdiff_t{body};
  return length<Access>(a, first) + length<Access>(a, first + 3) / Access::get(lengths, body);
}

template <class Access>
inline auto mass_of(int body, const double* mass) {
  return Access::get(mass, 10 * std::ptrdiff_t{body});
}

}  // namespace linkwork::saddle_products
