// Compiled once per instruction set with LINKWORK_ISA = v2, v3, v4; see CMakeLists.txt.
#include "linkwork/linear/qr/front.hpp"

#include <Eigen/Core>

#include "linkwork/math/inline.hpp"

namespace linkwork::qr {
namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using Column = Eigen::Map<Eigen::VectorXd>;

constexpr int few_columns = 8, few_rows = 24;  // to which a panel is not worth its products
constexpr double nothing = 1e-100;             // length of a column whose reciprocal would be no number

Column column(const Front& f, int k, int first, int last) {
  return Column(f.entries + k * f.stride + first, last - first);
}

/// The transformations of a panel, H_1 H_2 ... = 1 - V T V^T with unit lower trapezoidal V and upper triangular T
/// (R. Schreiber, C. Van Loan, A storage-efficient WY representation for products of Householder transformations,
/// SIAM J. Sci. Stat. Comput. 10, 1989).
struct Panel {
  Matrix V, T, W;
  int first;  ///< row
  int count = 0;

  Panel(const Front& f, int first_row, int last_row)
      : V(f.workspace, last_row - first_row, panel, Eigen::OuterStride<>(last_row - first_row)),
        T(f.workspace + std::ptrdiff_t{panel} * (last_row - first_row), panel, panel, Eigen::OuterStride<>(panel)),
        W(T.data() + panel * panel, panel, f.columns, Eigen::OuterStride<>(panel)),
        first(first_row) {}

  void add(const Column& v, double tau, int row) {
    const Eigen::Index above = row - first;
    auto own = V.col(count);
    own.head(above).setZero();
    own[above] = 1.0;
    own.segment(above + 1, v.size() - 1) = v.tail(v.size() - 1);
    own.tail(own.size() - above - v.size()).setZero();
    auto t = T.col(count).head(count);
    t.noalias() = V.block(above, 0, v.size(), count).transpose() * own.segment(above, v.size());
    t = -tau * (T.topLeftCorner(count, count).triangularView<Eigen::Upper>() * t).eval();
    T(count, count) = tau;
    ++count;
  }

  /// C -= V T^T V^T C
  void apply(Matrix C) {
    if (count == 0) return;
    const auto Vk = V.leftCols(count);
    auto Wk = W.topLeftCorner(count, C.cols());
    Wk.noalias() = Vk.transpose() * C;
    Matrix U(W.data() + panel * W.cols(), count, C.cols(), Eigen::OuterStride<>(panel));
    U.noalias() = T.topLeftCorner(count, count).triangularView<Eigen::Upper>().transpose() * Wk;
    C.noalias() -= Vk * U;
  }
};

/// x becomes (beta, v_2, v_3, ...) with (1 - tau v v^T) x = beta e_1, v_1 = 1; returns tau.
double reflect(Column x, double norm) {
  const double beta = x[0] > 0.0 ? -norm : norm, tau = (beta - x[0]) / beta;
  x.tail(x.size() - 1) *= 1.0 / (x[0] - beta);
  x[0] = beta;
  return tau;
}

void apply(const Front& f, const Column& v, double tau, int row, int first, int last) {
  const Eigen::Index rest = v.size() - 1;
  const auto tail = v.tail(rest);
  for (int c = first; c < last; ++c) {
    double* x = f.entries + c * f.stride + row;
    Column below(x + 1, rest);
    const double w = tau * (x[0] + tail.dot(below));
    x[0] -= w;
    below -= w * tail;
  }
}

/// Columns first .. last, the transformations going into `gathered` where there is one, and to the columns up to `to`.
/// Returns the next row of R.
int factor_columns(const Front& f, int first, int last, int to, int row, Panel* gathered) {
  for (int k = first; k < last; ++k) {
    f.row[k] = -1;
    if (f.stair[k] <= row) continue;
    Column x = column(f, k, row, f.stair[k]);
    const double norm = x.norm();
    if (!(norm > (k < f.pivots ? f.tolerance : nothing))) {
      x.setZero();
      continue;
    }
    const double tau = reflect(x, norm);
    apply(f, x, tau, row, k + 1, to);
    if (gathered) gathered->add(x, tau, row);
    f.row[k] = row++;
  }
  return row;
}

void factor(const Front& f) {
  int row = 0;
  for (int first = 0, last; first < f.columns; first = last) {
    last = first + panel < f.columns ? first + panel : f.columns;
    const int end = f.stair[last - 1], others = f.columns - last;
    if (others < few_columns || end - row < few_rows) {
      row = factor_columns(f, first, last, f.columns, row, nullptr);
      continue;
    }
    Panel gathered(f, row, end);
    row = factor_columns(f, first, last, last, row, &gathered);
    gathered.apply(Matrix(f.entries + last * f.stride + gathered.first, end - gathered.first, others,
                          Eigen::OuterStride<>(f.stride)));
  }
}

}  // namespace

#define LINKWORK_JOIN(A, B) A##B
#define LINKWORK_NAME(ISA) LINKWORK_JOIN(factor_front_, ISA)

extern const FactorFront LINKWORK_NAME(LINKWORK_ISA);
const FactorFront LINKWORK_NAME(LINKWORK_ISA) = &factor;

}  // namespace linkwork::qr
