#include "linkwork/linear/qr/sparse_qr.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "linkwork/linear/qr/front.hpp"
#include "linkwork/math/aligned.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::qr {
namespace {

using Numbers = std::vector<int>;

constexpr Eigen::Index spare_rows = 1000;  // at most so many more become dense,
constexpr Eigen::Index spare = 40000000;   // with at most so many numbers
constexpr std::size_t small = 1000;        // numbers whose memory is worth keeping

/// Groups of columns coupled by a row.
block::JointGraph group_graph(const RowMatrix& A, const Numbers& groups) {
  block::JointGraph graph;
  const int count = groups.empty() ? 0 : groups.back() + 1;
  graph.weight.assign(count, 0);
  graph.hub.assign(count, -1);
  for (const int group : groups) ++graph.weight[group];
  Numbers clique;
  for (int row = 0; row < A.rows(); ++row) {
    clique.clear();
    for (RowMatrix::InnerIterator it(A, row); it; ++it)
      if (const int group = groups[it.col()]; clique.empty() || clique.back() != group) clique.push_back(group);
    if (clique.size() > 1 && (graph.cliques.size() == 0 || !std::ranges::equal(graph.cliques.back(), clique)))
      graph.cliques.add(clique);
  }
  return graph;
}

/// What a front leaves to its parent: rows of R on the columns that are not its own.
struct Contribution {
  Numbers columns;  ///< positions in the order of elimination
  Numbers lead;     ///< per row: place of its first entry in `columns`, ascending
  AlignedDoubles entries;
  double& operator()(int row, int column) { return entries[column * lead.size() + row]; }
};

class Elimination {
 public:
  Elimination(const RowMatrix& A, const Numbers& groups, Pivots pivots, MatrixXd& dense, block::KeptOrders& orders)
      : A_(A),
        tolerance_(pivots.none),
        weak_(pivots.weak),
        dense_(dense),
        dense_rows_(dense.rows()),
        most_rows_(dense.rows() + std::min(spare_rows, spare / (A.cols() + 1))),
        order_(orders.order(group_graph(A, groups))),
        tree_(*order_) {
    look_for_interruption();
    order_columns(groups);
    sort_rows();
    look_for_interruption();
    child_.assign(tree_.supernodes.size(), -1);
    sibling_.assign(tree_.supernodes.size(), -1);
    for (auto s = static_cast<int>(tree_.supernodes.size()); s-- > 0;)
      if (const int parent = tree_.supernodes[s].parent; parent >= 0) sibling_[s] = std::exchange(child_[parent], s);
    contributions_.resize(tree_.supernodes.size());
    local_.resize(A.cols());
  }

  Numbers run() {
    for (std::size_t s = 0; s < tree_.supernodes.size(); ++s) {
      look_for_interruption();
      list_columns(tree_.supernodes[s]);
      assemble(static_cast<int>(s));
      factor_(front_);
      contribute(contributions_[s]);
      delay_weak_pivots();
      if (dense_rows_ > 0) reduce_dense_rows();
      for (int k = 0; k < front_.pivots; ++k)
        if (row_[k] < 0) dead_.push_back(column_[columns_[k]]);
    }
    dense_.conservativeResize(dense_rows_, Eigen::NoChange);
    return std::move(dead_);
  }

 private:
  /// Columns of a group stand together, in their order.
  void order_columns(const Numbers& groups) {
    Numbers begin(tree_.order.size() + 1, 0);
    for (const int group : groups) ++begin[group + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    position_.resize(groups.size());
    for (const int group : tree_.order) {
      first_.push_back(static_cast<int>(column_.size()));
      for (int column = begin[group]; column < begin[group + 1]; ++column) {
        position_[column] = static_cast<int>(column_.size());
        column_.push_back(column);
        supernode_.push_back(tree_.supernode_of[static_cast<int>(first_.size()) - 1]);
      }
    }
    first_.push_back(static_cast<int>(column_.size()));
  }

  /// By their first column, in which a row enters a front.
  void sort_rows() {
    const int none = static_cast<int>(A_.cols());
    lead_.assign(A_.rows(), none);
    for (int row = 0; row < A_.rows(); ++row)
      for (RowMatrix::InnerIterator it(A_, row); it; ++it) lead_[row] = std::min(lead_[row], position_[it.col()]);
    row_begin_.assign(tree_.supernodes.size() + 1, 0);
    for (const int lead : lead_)
      if (lead < none) ++row_begin_[supernode_[lead] + 1];
    std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
    rows_.resize(row_begin_.back());
    next_.assign(row_begin_.begin(), row_begin_.end());
    for (int row = 0; row < A_.rows(); ++row)
      if (lead_[row] < none) rows_[next_[supernode_[lead_[row]]]++] = row;
  }

  std::span<const int> rows_of(int s) const { return {rows_.data() + row_begin_[s], rows_.data() + row_begin_[s + 1]}; }

  void list_columns(const block::Supernode& node) {
    columns_.clear();
    const auto add = [&](int place) {
      for (int position = first_[place]; position < first_[place + 1]; ++position) {
        local_[position] = static_cast<int>(columns_.size());
        columns_.push_back(position);
      }
    };
    for (int place = node.first; place < node.last; ++place) add(place);
    front_.pivots = static_cast<int>(columns_.size());
    for (const int place : node.below) add(place);
    front_.columns = static_cast<int>(columns_.size());
  }

  void assemble(int s) {
    stair_.assign(columns_.size(), 0);
    for (const int row : rows_of(s)) ++stair_[local_[lead_[row]]];
    for (int child = child_[s]; child >= 0; child = sibling_[child]) {
      const Contribution& part = contributions_[child];
      for (const int lead : part.lead) ++stair_[local_[part.columns[lead]]];
    }
    next_.resize(columns_.size());
    int rows = 0;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      next_[k] = rows;
      stair_[k] = rows += stair_[k];
    }
    entries_.assign(rows * columns_.size(), 0.0);
    row_.resize(columns_.size());
    workspace_.resize(workspace_size(static_cast<std::size_t>(rows), columns_.size()));
    front_.entries = entries_.data();
    front_.stride = rows;
    front_.stair = stair_.data();
    front_.tolerance = tolerance_;
    front_.row = row_.data();
    front_.workspace = workspace_.data();
    add_rows(rows_of(s));
    for (int child = child_[s]; child >= 0; child = sibling_[child]) {
      add(contributions_[child]);
      Contribution used = std::move(contributions_[child]);
      if (used.entries.capacity() <= small) spare_.push_back(std::move(used));
    }
  }

  void add_rows(std::span<const int> rows) {
    for (const int row : rows) {
      const int place = next_[local_[lead_[row]]]++;
      for (RowMatrix::InnerIterator it(A_, row); it; ++it)
        front_.entries[place + front_.stride * local_[position_[it.col()]]] = it.value();
    }
  }

  void add(Contribution& part) {
    places_.clear();
    for (const int lead : part.lead) places_.push_back(next_[local_[part.columns[lead]]]++);
    int rows = 0;
    for (int k = 0; k < static_cast<int>(part.columns.size()); ++k) {
      while (rows < static_cast<int>(part.lead.size()) && part.lead[rows] <= k) ++rows;
      double* column = front_.entries + front_.stride * local_[part.columns[k]];
      for (int row = 0; row < rows; ++row) column[places_[row]] = part(row, k);
    }
  }

  /// Columns that are barely independent of those before are delayed: what follows would be told from roundoff by their
  /// rows of R only, and taken from dense rows many times over. These become dense rows.
  void delay_weak_pivots() {
    for (int j = 0; j < front_.pivots; ++j) {
      if (row_[j] < 0 || dense_rows_ >= most_rows_) continue;
      const double* R = front_.entries + row_[j];
      if (std::abs(R[front_.stride * j]) > weak_) continue;
      if (dense_rows_ == dense_.rows()) {
        dense_.conservativeResize(std::min(2 * dense_rows_ + 8, most_rows_), Eigen::NoChange);
        dense_.bottomRows(dense_.rows() - dense_rows_).setZero();
      }
      for (int k = j; k < front_.columns; ++k) dense_(dense_rows_, column_[columns_[k]]) = R[front_.stride * k];
      dense_rows_ += 1;
      row_[j] = -1;
    }
  }

  /// F_k -= (F_j / R_jj) R_jk for the columns k after each pivot j.
  void reduce_dense_rows() {
    for (int j = 0; j < front_.pivots; ++j) {
      if (row_[j] < 0) continue;
      const double* R = front_.entries + row_[j];
      auto own = dense_.col(column_[columns_[j]]).head(dense_rows_);
      own /= R[front_.stride * j];
      for (int k = j + 1; k < front_.columns; ++k)
        dense_.col(column_[columns_[k]]).head(dense_rows_) -= R[front_.stride * k] * own;
      own.setZero();
    }
  }

  void contribute(Contribution& out) {
    int first = 0;
    for (int k = 0; k < front_.pivots; ++k) first = std::max(first, row_[k] + 1);
    if (!spare_.empty()) {
      out = std::move(spare_.back());
      spare_.pop_back();
      out.lead.clear();
      out.columns.clear();
    }
    for (int k = front_.pivots; k < front_.columns; ++k)
      if (row_[k] >= 0) out.lead.push_back(k - front_.pivots);
    if (out.lead.empty()) return;
    out.columns.assign(columns_.begin() + front_.pivots, columns_.end());
    out.entries.resize(out.columns.size() * out.lead.size());
    int rows = 0;
    for (int k = 0; k < static_cast<int>(out.columns.size()); ++k) {
      while (rows < static_cast<int>(out.lead.size()) && out.lead[rows] <= k) ++rows;
      const double* column = front_.entries + front_.stride * (front_.pivots + k) + first;
      for (int row = 0; row < rows; ++row) out(row, k) = column[row];
    }
  }

  const RowMatrix& A_;
  const double tolerance_, weak_;
  MatrixXd& dense_;
  Eigen::Index dense_rows_;  ///< those that are used
  const Eigen::Index most_rows_;
  const std::shared_ptr<const block::Elimination> order_;
  const block::Elimination& tree_;
  const FactorFront factor_ = front_factorization();
  Numbers first_;                            ///< position of the first column at each place of the order
  Numbers column_, supernode_;               ///< at each position
  Numbers position_;                         ///< of each column
  Numbers lead_;                             ///< first position in each row of A
  Numbers row_begin_, rows_;                 ///< of each supernode
  Numbers child_, sibling_;                  ///< its first child, its next sibling; -1: none
  std::vector<Contribution> contributions_;  ///< of each supernode, from when it is there until it is used
  std::vector<Contribution> spare_;          ///< memory of those that were used
  Numbers dead_;

  // the front at hand
  Front front_{};
  Numbers columns_, stair_, row_;  ///< position, rows that reach it, and row of R of each column
  Numbers next_;                   ///< per column: where the next row goes that begins in it
  Numbers local_;                  ///< of positions: the column
  Numbers places_;
  AlignedDoubles entries_, workspace_;
};

}  // namespace

std::vector<int> dependent_columns(const RowMatrix& A, const std::vector<int>& groups, Pivots pivots, MatrixXd& dense,
                                   block::KeptOrders& orders) {
  return Elimination(A, groups, pivots, dense, orders).run();
}

extern const FactorFront factor_front_v2;
#if LINKWORK_X86
extern const FactorFront factor_front_v3, factor_front_v4;
#endif

FactorFront front_factorization() {
#if LINKWORK_X86
  const int level = best_instruction_set().level;
  if (level == 2) return factor_front_v4;
  if (level == 1) return factor_front_v3;
#endif
  return factor_front_v2;
}

}  // namespace linkwork::qr
