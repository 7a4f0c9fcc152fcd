#include "linkwork/constraints/closed_loops.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "linkwork/assembly/leaf_pruning.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double zero_row = 1e-9;

/// A row of rotations alone has natural size 1 and may vanish in a pose, such as that of axes at right angles where
/// they are parallel. Translations have a size of their own, and so have the factors of special joints.
bool vanishes(const Model& model, int row, double translation, double rotation) {
  if (!(translation > 0.0 || rotation > 0.0)) return true;
  return translation == 0.0 && rotation <= zero_row && !model.special_joint(model.joint_of_row(row));
}

/// True where the rows of a block are independent on its body alone.
bool independent(const Model& model, const Evaluation& at, const VectorXd& scale, const ConstraintBlock& block,
                 double tolerance) {
  if (block.rows > 6) return false;
  const BlockOfD D = block_of(at, block);
  using Rows = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;  // without memory of its own
  Rows rows = scale.segment<6>(6 * block.body).asDiagonal() * D.transpose();
  for (int k = 0; k < block.rows; ++k)
    rows.col(k) *= vanishes(model, block.row + k, D.row(k).head<3>().cwiseAbs().maxCoeff(),
                            D.row(k).tail<3>().cwiseAbs().maxCoeff())
                       ? 0.0
                       : 1.0 / rows.col(k).norm();
  Eigen::ColPivHouseholderQR<Rows> qr(rows);
  qr.setThreshold(tolerance);
  return qr.rank() == block.rows;
}

/// Such a joint is no edge of a tree: it counts as one that closes a loop.
bool joins_many(const Model& model, int joint) {
  const SpecialJoint* special = model.special_joint(joint);
  return special && special->bodies().size() > 2;
}

/// The rows of the joint of a leaf are independent of all that remain, because only they touch that body, where they
/// are independent on it.
std::vector<char> prune_open_branches(const System& system, const VectorXd& scale, const Evaluation& at,
                                      double tolerance) {
  const std::vector<char> none(system.joint_count(), 0);
  InterruptionMeter meter;
  const auto prunable = [&](const ConstraintBlock& block) {
    meter.add(1);
    return independent(system.model(), at, scale, block, tolerance);
  };
  return prune_leaves(system, none, prunable).joints;
}

}  // namespace

ClosedLoops::ClosedLoops(const System& system, const Evaluation& at, double tolerance)
    : system_(&system), scale_(velocity_scale(system)), pruned_(prune_open_branches(system, scale_, at, tolerance)) {
  const auto& first = system.model().joint_rows();
  for (std::size_t joint = 0; joint + 1 < first.size(); ++joint)
    if (!pruned_[joint])
      for (int row = first[joint]; row < first[joint + 1]; ++row) {
        rows_.push_back(row);
        row_joint_.push_back(static_cast<int>(joint));
      }
  find_components();
  find_tree();
}

/// Bodies joined by a joint in a loop are in one component (union-find).
void ClosedLoops::find_components() {
  std::vector<int> parent(system_->body_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int body) {
    while (parent[body] != body) {
      int& up = parent[body];
      body = up = parent[up];
    }
    return body;
  };
  std::vector<int> body_of_joint(pruned_.size(), -1);
  for (const ConstraintBlock& block : system_->blocks()) {
    if (pruned_[block.joint]) continue;
    int& first = body_of_joint[block.joint];
    if (first < 0) first = block.body;
    parent[root(block.body)] = root(first);
  }
  std::vector<int> number(parent.size(), -1);
  body_component_.assign(parent.size(), -1);
  const auto component = [&](int body) {
    int& found = number[root(body)];
    if (found < 0) found = component_count_++;
    return body_component_[body] = found;
  };
  for (const ConstraintBlock& block : system_->blocks())
    if (!pruned_[block.joint]) component(block.body);
  for (const int joint : row_joint_) row_component_.push_back(component(body_of_joint[joint]));
}

/// Breadth first from the ground, then from the first body of every component without a joint to it: node 0 is the
/// ground, node b + 1 a body.
void ClosedLoops::find_tree() {
  const Model& model = system_->model();
  const int nodes = system_->body_count() + 1;
  closing_.assign(pruned_.size(), 0);
  parent_joint_.assign(nodes, -1);
  depth_.assign(nodes, -1);
  std::vector<int> grounded, queue;
  for (std::size_t joint = 0; joint < pruned_.size(); ++joint) {
    const Element& element = model.joints()[joint];
    if (!pruned_[joint] && (element.i == ground || element.j == ground)) grounded.push_back(static_cast<int>(joint));
  }
  const auto visit = [&](int joint, int from) {
    if (joins_many(model, joint)) {
      closing_[joint] = !pruned_[joint];
      return;
    }
    const Element& element = model.joints()[joint];
    const int to = element.i == from ? element.j : element.i;
    const int node = to + 1;
    if (pruned_[joint] || parent_joint_[from + 1] == joint) return;
    if (depth_[node] >= 0) {
      closing_[joint] = 1;
      return;
    }
    depth_[node] = depth_[from + 1] + 1;
    parent_joint_[node] = joint;
    queue.push_back(to);
  };
  depth_[0] = 0;
  for (const int joint : grounded) visit(joint, ground);
  for (int first = 0; first <= system_->body_count(); ++first) {
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (const int index : system_->body_blocks(queue[next])) visit(system_->blocks()[index].joint, queue[next]);
    queue.clear();
    if (first == system_->body_count() || component_of_body(first) < 0 || depth_[first + 1] >= 0) continue;
    depth_[first + 1] = 0;
    queue.push_back(first);
  }
}

std::vector<int> ClosedLoops::loop_of(int joint, std::size_t most) const {
  const Model& model = system_->model();
  if (joins_many(model, joint)) return {};
  std::vector<int> loop = {joint};
  int ends[2] = {model.joints()[joint].i, model.joints()[joint].j};
  while (ends[0] != ends[1]) {
    const auto depth = [&](int end) { return depth_[end + 1]; };
    int& lower = depth(ends[0]) > depth(ends[1]) ? ends[0] : ends[1];
    const int up = parent_joint_[lower + 1];
    if (up < 0 || loop.size() >= most) return {};
    const Element& element = model.joints()[up];
    lower = element.i == lower ? element.j : element.i;
    loop.push_back(up);
  }
  return loop;
}

SparseRows ClosedLoops::scaled_D(const Evaluation& at, VectorXd* lengths) const {
  SparseRows D(row_count(), system_->v_size());
  D.reserve(std::ptrdiff_t{2} * velocity_size * row_count());
  if (lengths) lengths->setOnes(row_count());
  std::vector<std::pair<int, double>> row;
  for (int place = 0; place < row_count(); ++place) {
    D.startVec(place);
    const int number = rows_[place];
    double squares = 0.0, largest[2] = {0.0, 0.0};  // of translations and rotations
    row.clear();
    for (const int index : system_->joint_blocks(row_joint_[place])) {
      const ConstraintBlock& block = system_->blocks()[index];
      for (int c = 0; c < 6; ++c) {
        const double value = at.D[block.offset + 6 * (number - block.row) + c];
        const int velocity = 6 * block.body + c;
        largest[c / 3] = std::max(largest[c / 3], std::abs(value));
        row.emplace_back(velocity, value * scale_[velocity]);
        squares += row.back().second * row.back().second;
      }
    }
    if (vanishes(system_->model(), number, largest[0], largest[1])) continue;
    const double length = std::sqrt(squares);
    if (lengths) (*lengths)[place] = length;
    if (!std::is_sorted(row.begin(), row.end())) std::sort(row.begin(), row.end());
    for (const auto& [velocity, value] : row)
      if (value != 0.0) D.insertBack(place, velocity) = value / length;
  }
  D.finalize();
  return D;
}

SparseRows select_rows(const SparseRows& A, const std::vector<int>& rows) {
  SparseRows out(static_cast<Eigen::Index>(rows.size()), A.cols());
  Eigen::Index entries = 0;
  for (const int row : rows) entries += A.outerIndexPtr()[row + 1] - A.outerIndexPtr()[row];
  out.reserve(entries);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    out.startVec(static_cast<Eigen::Index>(k));
    for (SparseRows::InnerIterator it(A, rows[k]); it; ++it)
      out.insertBack(static_cast<Eigen::Index>(k), it.col()) = it.value();
  }
  out.finalize();
  return out;
}

}  // namespace linkwork
