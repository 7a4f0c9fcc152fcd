#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "linkwork/linear/saddle_solver.hpp"

namespace linkwork::detail {

/// A SaddleSolver that assembles its matrix by blocks and leaves it to a LinearSolver.
class AssembledSolver : public SaddleSolver {
 public:
  AssembledSolver(std::unique_ptr<LinearSolver> solver, Storage storage)
      : solver_(std::move(solver)), storage_(storage) {}

  void keep(Archive& archive) override { solver_->keep(archive); }
  std::int64_t factor_nonzeros() const override { return solver_->factor_nonzeros(); }
  std::optional<double> flops() const override { return solver_->flops(); }
  std::optional<std::int64_t> factor_bytes() const override { return solver_->factor_bytes(); }
  std::optional<std::int64_t> matrix_nonzeros() const override { return triangle_nonzeros(matrix_->matrix()); }

 protected:
  /// A product of the blocks k and l of D that is added to a block of the matrix.
  struct Product {
    int k, l, place;
    bool new_l;  ///< l differs from that of the product before
  };

  /// The matrix that is a sum of products of blocks of D, with diagonal blocks of these sizes: of the pairs in each
  /// group of `blocks_of`, such as those on a body or of a joint, the ones with index_of(k) <= index_of(l), block rows
  /// and columns of the matrix.
  template <class BlocksOf, class IndexOf>
  void build_pattern(const std::vector<int>& sizes, int groups, BlocksOf blocks_of, IndexOf index_of) {
    std::vector<BlockIndex> blocks;
    for (int k = 0; k < static_cast<int>(sizes.size()); ++k) blocks.push_back({k, k});
    products_.clear();
    for (int group = 0; group < groups; ++group)
      for (const int l : blocks_of(group)) {
        bool new_l = true;
        for (const int k : blocks_of(group)) {
          const int row = index_of(system_->blocks()[k]), column = index_of(system_->blocks()[l]);
          if (row > column) continue;
          products_.push_back({.k = k, .l = l, .place = -1, .new_l = std::exchange(new_l, false)});
          blocks.push_back({row, column});
          if (storage_ == Storage::full) blocks.push_back({column, row});
        }
      }
    matrix_ = std::make_unique<BlockMatrix>(sizes, std::move(blocks), storage_);
    for (Product& it : products_)
      it.place = matrix_->find(index_of(system_->blocks()[it.k]), index_of(system_->blocks()[it.l]));
    diagonal_.clear();
    for (int k = 0; k < static_cast<int>(sizes.size()); ++k) diagonal_.push_back(matrix_->find(k, k));
  }

  const System* system_ = nullptr;
  const Evaluation* at_ = nullptr;
  std::unique_ptr<LinearSolver> solver_;
  Storage storage_;
  std::unique_ptr<BlockMatrix> matrix_;
  std::vector<Product> products_;
  std::vector<int> diagonal_;  ///< places of the diagonal blocks
  MatrixXd right_hand_side_;   ///< one column
};

}  // namespace linkwork::detail
