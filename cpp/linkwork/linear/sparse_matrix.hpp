#pragma once

#include <cstdint>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Which entries of a symmetric matrix are stored.
enum class Storage { upper, full };

/// A square matrix in compressed columns, rows ascending.
struct SparseMatrix {
  int size = 0;
  Storage storage = Storage::full;
  std::vector<int> column_begin, row;
  std::vector<double> value;
};

/// Entries on and below the diagonal, or on and above it where only that triangle is stored.
std::int64_t triangle_nonzeros(const SparseMatrix& A);

/// Row and column of a dense block.
struct BlockIndex {
  int row, column;
};

/// A square sparse matrix made of dense blocks on a fixed pattern. The columns of a block column have equal patterns,
/// so each block is a dense matrix with a stride: assembly writes blocks and never searches an index.
class BlockMatrix {
 public:
  using Block = Eigen::Map<MatrixXd, 0, Eigen::OuterStride<>>;

  /// `sizes` of the block rows (= block columns). Duplicate blocks count once; Storage::upper keeps row <= column.
  BlockMatrix(const std::vector<int>& sizes, std::vector<BlockIndex> blocks, Storage storage);

  /// Place of a block, for use with `block`; the block must be there.
  int find(int row, int column) const;
  Block block(int place);
  int block_count() const { return static_cast<int>(places_.size()); }

  void set_zero();
  /// Copies the strictly upper blocks into the lower ones (Storage::full).
  void mirror();
  const SparseMatrix& matrix() const { return matrix_; }

 private:
  struct Place {
    std::size_t offset;  ///< of the first entry
    int rows, columns, stride;
  };
  void build_columns(const std::vector<BlockIndex>& blocks);
  void build_mirror(const std::vector<BlockIndex>& blocks);

  SparseMatrix matrix_;
  std::vector<int> first_;  ///< first scalar row of each block row, and the total
  std::vector<int> block_row_, block_column_begin_;
  std::vector<Place> places_;
  std::vector<std::pair<int, int>> mirror_;  ///< (upper place, lower place)
};

}  // namespace linkwork
