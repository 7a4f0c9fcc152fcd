#include "linkwork/linear/sparse_lu.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <utility>

namespace linkwork {
namespace {

constexpr double smallest_pivot = 1e-13;  // of rows of length about 1
constexpr double largest_growth = 30.0;   // entries of L where pivots are kept

}  // namespace

SparseLu::SparseLu(int rows, std::vector<int> begin, std::vector<int> row)
    : m_(rows),
      n_(static_cast<int>(begin.size()) - 1),
      begin_(std::move(begin)),
      row_(std::move(row)),
      diagonal_(n_),
      work_(std::max(m_, n_), 0.0),
      place_(row_.size(), -1),
      mark_(m_, -1) {
  order_columns();
}

void SparseLu::order_columns() {
  using Pattern = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  const std::vector<double> ones(row_.size(), 1.0);
  const Pattern A =
      Eigen::Map<const Pattern>(m_, n_, static_cast<int>(row_.size()), begin_.data(), row_.data(), ones.data());
  Eigen::COLAMDOrdering<int>::PermutationType found;
  Eigen::COLAMDOrdering<int>()(A, found);
  order_.resize(n_);
  for (int column = 0; column < n_; ++column) order_[found.indices()[column]] = column;
}

// Rows that the column meets, through the columns of L that eliminate it: depth first, each after those it depends on.
void SparseLu::reach(int column, std::vector<int>& nodes) {
  std::vector<std::pair<int, int>> path;  // a row, and how far its column of L has been followed
  nodes.clear();
  const auto visit = [&](int row) {
    if (mark_[row] == column) return;
    mark_[row] = column;
    path.emplace_back(row, pivot_of_row_[row] < 0 ? 0 : L_.begin[pivot_of_row_[row]]);
  };
  for (int k = begin_[column]; k < begin_[column + 1]; ++k) {
    visit(row_[k]);
    while (!path.empty()) {
      auto& [row, next] = path.back();
      const int pivot = pivot_of_row_[row];
      if (pivot >= 0 && next < L_.begin[pivot + 1]) {
        visit(L_.row[next++]);
      } else {
        nodes.push_back(row);
        path.pop_back();
      }
    }
  }
  std::reverse(nodes.begin(), nodes.end());
}

int SparseLu::choose_pivot(const std::vector<int>& nodes) const {
  int best = -1;
  for (const int row : nodes)
    if (pivot_of_row_[row] < 0 && (best < 0 || std::abs(work_[row]) > std::abs(work_[best]))) best = row;
  return best >= 0 && std::abs(work_[best]) > smallest_pivot ? best : -1;
}

// Column k of L and U from the column of A in `work_`.
bool SparseLu::store_column(int k, const std::vector<int>& nodes) {
  for (const int row : nodes) {
    const int pivot = pivot_of_row_[row];
    if (pivot < 0) continue;
    U_.row.push_back(pivot);
    U_.value.push_back(work_[row]);
    for (int l = L_.begin[pivot]; l < L_.begin[pivot + 1]; ++l) work_[L_.row[l]] -= L_.value[l] * work_[row];
  }
  const int chosen = choose_pivot(nodes);
  if (chosen >= 0) {
    diagonal_[k] = work_[chosen];
    pivot_of_row_[chosen] = k;
    row_of_pivot_[k] = chosen;
    for (const int row : nodes)
      if (pivot_of_row_[row] < 0) {
        L_.row.push_back(row);
        L_.value.push_back(work_[row] / diagonal_[k]);
      }
  }
  for (const int row : nodes) work_[row] = 0.0;
  L_.begin.push_back(static_cast<int>(L_.row.size()));
  U_.begin.push_back(static_cast<int>(U_.row.size()));
  return chosen >= 0;
}

bool SparseLu::factorize(const std::vector<double>& values) {
  L_ = U_ = Columns();
  sign_ = 0;
  pivot_of_row_.assign(m_, -1);
  row_of_pivot_.assign(n_, -1);
  std::fill(mark_.begin(), mark_.end(), -1);
  std::vector<int> nodes;
  for (int k = 0; k < n_; ++k) {
    const int column = order_[k];
    reach(column, nodes);
    for (int a = begin_[column]; a < begin_[column + 1]; ++a) work_[row_[a]] += values[a];
    if (!store_column(k, nodes)) return false;
  }
  number_by_pivots();
  find_sign();
  return true;
}

// Rows of L become pivots; those that were never chosen are left out.
void SparseLu::number_by_pivots() {
  Columns kept;
  for (int k = 0; k < n_; ++k) {
    for (int l = L_.begin[k]; l < L_.begin[k + 1]; ++l)
      if (const int pivot = pivot_of_row_[L_.row[l]]; pivot >= 0) {
        kept.row.push_back(pivot);
        kept.value.push_back(L_.value[l]);
      }
    kept.begin.push_back(static_cast<int>(kept.row.size()));
  }
  L_ = std::move(kept);
  for (std::size_t a = 0; a < row_.size(); ++a) place_[a] = pivot_of_row_[row_[a]];
}

void SparseLu::find_sign() {
  sign_ = 1;
  for (const double pivot : diagonal_) sign_ = pivot < 0 ? -sign_ : sign_;
}

bool SparseLu::refactorize(const std::vector<double>& values) {
  if (sign_ == 0) return false;
  bool stable = true;
  double* const x = work_.data();
  for (int k = 0; k < n_; ++k) {
    for (int a = begin_[order_[k]]; a < begin_[order_[k] + 1]; ++a)
      if (place_[a] >= 0) x[place_[a]] += values[a];
    for (int u = U_.begin[k]; u < U_.begin[k + 1]; ++u) {
      const double factor = U_.value[u] = std::exchange(x[U_.row[u]], 0.0);
      for (int l = L_.begin[U_.row[u]]; l < L_.begin[U_.row[u] + 1]; ++l) x[L_.row[l]] -= L_.value[l] * factor;
    }
    diagonal_[k] = std::exchange(x[k], 0.0);
    const double inverse = 1.0 / diagonal_[k];
    stable = stable && std::abs(diagonal_[k]) > smallest_pivot;
    for (int l = L_.begin[k]; l < L_.begin[k + 1]; ++l) {
      L_.value[l] = std::exchange(x[L_.row[l]], 0.0) * inverse;
      stable = stable && std::abs(L_.value[l]) <= largest_growth;
    }
  }
  find_sign();
  if (!stable) sign_ = 0;
  return stable;
}

void SparseLu::solve(const ConstVector& b, MutableVector x) {
  double* const y = work_.data();
  for (int k = 0; k < n_; ++k) y[k] = b[row_of_pivot_[k]];
  for (int k = 0; k < n_; ++k)
    for (int l = L_.begin[k]; l < L_.begin[k + 1]; ++l) y[L_.row[l]] -= L_.value[l] * y[k];
  for (int k = n_ - 1; k >= 0; --k) {
    y[k] /= diagonal_[k];
    for (int u = U_.begin[k]; u < U_.begin[k + 1]; ++u) y[U_.row[u]] -= U_.value[u] * y[k];
  }
  for (int k = 0; k < n_; ++k) x[order_[k]] = std::exchange(y[k], 0.0);
}

void SparseLu::solve_transposed(const ConstVector& f, MutableVector y) {
  double* const w = work_.data();
  for (int k = 0; k < n_; ++k) {
    double sum = f[order_[k]];
    for (int u = U_.begin[k]; u < U_.begin[k + 1]; ++u) sum -= U_.value[u] * w[U_.row[u]];
    w[k] = sum / diagonal_[k];
  }
  y.setZero();
  for (int k = n_ - 1; k >= 0; --k) {
    for (int l = L_.begin[k]; l < L_.begin[k + 1]; ++l) w[k] -= L_.value[l] * w[L_.row[l]];
    y[row_of_pivot_[k]] = w[k];
  }
  std::fill_n(w, n_, 0.0);
}

}  // namespace linkwork
