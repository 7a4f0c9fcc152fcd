#include "linkwork/constraints/dropped_rows.hpp"

#include <algorithm>

namespace linkwork {

DroppedRows::DroppedRows(const System& system, std::vector<int> rows) : rows_(std::move(rows)) {
  std::sort(rows_.begin(), rows_.end());
  pieces_.reserve(2 * rows_.size());
  for (int place = 0; place < count(); ++place) {
    const int row = rows_[place];
    for (const int index : system.joint_blocks(system.model().joint_of_row(row))) {
      const ConstraintBlock& block = system.blocks()[index];
      pieces_.push_back({place, block.body, block.offset + 6 * (row - block.row), Row::Zero()});
    }
  }
}

std::vector<char> DroppedRows::translating() const {
  std::vector<char> out(rows_.size(), 0);
  for (const Piece& piece : pieces_)
    if (piece.entries.head<3>().cwiseAbs().maxCoeff() > 0.0) out[piece.place] = 1;
  return out;
}

void DroppedRows::take_out(Evaluation& at) {
  for (Piece& piece : pieces_) {
    Eigen::Map<Row> entries(at.D.data() + piece.offset);
    piece.entries = entries;
    entries.setZero();
  }
}

void DroppedRows::put_back(Evaluation& at) const {
  for (const Piece& piece : pieces_) Eigen::Map<Row>(at.D.data() + piece.offset) = piece.entries;
}

void DroppedRows::multiply(const ConstVector& x, MutableVector omega) const {
  omega.setZero();
  for (const Piece& piece : pieces_) omega[piece.place] += piece.entries.dot(x.segment<6>(6 * piece.body));
}

void DroppedRows::add_transposed(const ConstVector& omega, MutableVector y) const {
  for (const Piece& piece : pieces_) y.segment<6>(6 * piece.body) += omega[piece.place] * piece.entries;
}

void DroppedRows::take_from(MutableVector b) const {
  for (const int row : rows_) b[row] = 0.0;
}

void DroppedRows::scatter(const ConstVector& omega, MutableVector lambda) const {
  for (int place = 0; place < count(); ++place) lambda[rows_[place]] = omega[place];
}

void DroppedRows::gather(const ConstVector& lambda, MutableVector omega) const {
  for (int place = 0; place < count(); ++place) omega[place] = lambda[rows_[place]];
}

}  // namespace linkwork
