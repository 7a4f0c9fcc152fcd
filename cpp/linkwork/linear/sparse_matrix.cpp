#include "linkwork/linear/sparse_matrix.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "linkwork/math/error.hpp"

namespace linkwork {

std::int64_t triangle_nonzeros(const SparseMatrix& A) {
  std::int64_t count = 0;
  for (int column = 0; column < A.size; ++column)
    for (int k = A.column_begin[column]; k < A.column_begin[column + 1]; ++k) count += A.row[k] <= column ? 1 : 0;
  return count;
}

BlockMatrix::BlockMatrix(const std::vector<int>& sizes, std::vector<BlockIndex> blocks, Storage storage) {
  first_.assign(sizes.size() + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), first_.begin() + 1);
  matrix_.size = first_.back();
  matrix_.storage = storage;
  const auto before = [](const BlockIndex& a, const BlockIndex& b) {
    return a.column != b.column ? a.column < b.column : a.row < b.row;
  };
  const auto same = [](const BlockIndex& a, const BlockIndex& b) { return a.row == b.row && a.column == b.column; };
  if (storage == Storage::upper) std::erase_if(blocks, [](const BlockIndex& b) { return b.row > b.column; });
  std::sort(blocks.begin(), blocks.end(), before);
  blocks.erase(std::unique(blocks.begin(), blocks.end(), same), blocks.end());
  build_columns(blocks);
  if (storage == Storage::full) build_mirror(blocks);
}

void BlockMatrix::build_columns(const std::vector<BlockIndex>& blocks) {
  const std::size_t columns = first_.size() - 1;
  block_column_begin_.assign(columns + 1, 0);
  for (const BlockIndex& block : blocks) block_column_begin_[block.column + 1] += 1;
  std::partial_sum(block_column_begin_.begin(), block_column_begin_.end(), block_column_begin_.begin());

  std::size_t nonzeros = 0;
  matrix_.column_begin = {0};
  for (std::size_t column = 0; column < columns; ++column) {
    const int begin = block_column_begin_[column], end = block_column_begin_[column + 1];
    std::vector<int> rows;
    for (int b = begin; b < end; ++b)
      for (int r = first_[blocks[b].row]; r < first_[blocks[b].row + 1]; ++r) rows.push_back(r);
    const int stride = static_cast<int>(rows.size()), width = first_[column + 1] - first_[column];
    int above = 0;
    for (int b = begin; b < end; ++b) {
      const int row = blocks[b].row, height = first_[row + 1] - first_[row];
      block_row_.push_back(row);
      places_.push_back(
          {.offset = nonzeros + static_cast<std::size_t>(above), .rows = height, .columns = width, .stride = stride});
      above += height;
    }
    for (int c = 0; c < width; ++c) {
      matrix_.row.insert(matrix_.row.end(), rows.begin(), rows.end());
      nonzeros += rows.size();
      if (nonzeros > std::size_t{std::numeric_limits<int>::max()})
        throw ModelError("too_large", "a sparse matrix of this model has more than 2^31 - 1 entries");
      matrix_.column_begin.push_back(static_cast<int>(nonzeros));
    }
  }
  matrix_.value.assign(nonzeros, 0.0);
}

void BlockMatrix::build_mirror(const std::vector<BlockIndex>& blocks) {
  for (const BlockIndex& block : blocks)
    if (block.row < block.column) mirror_.emplace_back(find(block.row, block.column), find(block.column, block.row));
}

int BlockMatrix::find(int row, int column) const {
  const auto begin = block_row_.begin() + block_column_begin_[column];
  const auto end = block_row_.begin() + block_column_begin_[column + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - block_row_.begin());
}

BlockMatrix::Block BlockMatrix::block(int place) {
  const Place& at = places_[place];
  return Block(matrix_.value.data() + at.offset, at.rows, at.columns, Eigen::OuterStride<>(at.stride));
}

void BlockMatrix::set_zero() { std::fill(matrix_.value.begin(), matrix_.value.end(), 0.0); }

void BlockMatrix::mirror() {
  for (const auto& [upper, lower] : mirror_) block(lower) = block(upper).transpose();
}

}  // namespace linkwork
