#include "linkwork/formulation/rank.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "linkwork/linear/column_rank.hpp"

namespace linkwork {
namespace {

constexpr double zero_row = 1e-9;

/// M^-1/2 as a scale per velocity; massless directions take the mean of the others.
VectorXd velocity_scale(const System& system) {
  const int n = system.body_count();
  VectorXd mass(system.v_size());
  for (int body = 0; body < n; ++body) {
    mass.segment<3>(6 * body).setConstant(system.mass(body));
    mass.segment<3>(6 * body + 3).setConstant(system.inertia(body).trace() / 3.0);
  }
  double sums[2] = {0.0, 0.0};
  for (int body = 0; body < n; ++body) {
    sums[0] += mass[6 * body];
    sums[1] += mass[6 * body + 3];
  }
  for (Eigen::Index k = 0; k < mass.size(); ++k) {
    const double mean = sums[k % 6 / 3] / n;
    if (mass[k] <= 0.0) mass[k] = mean > 0.0 ? mean : 1.0;
  }
  return mass.cwiseSqrt().cwiseInverse();
}

/// The blocks of D M^-1/2 with every row of D scaled to unit length; a row that is roundoff of zero becomes zero (the
/// equations of joints have natural size 1).
std::vector<double> scaled_D(const System& system, const Evaluation& at) {
  const VectorXd scale = velocity_scale(system);
  VectorXd norms = VectorXd::Zero(system.row_count()), largest = norms;
  std::vector<double> D = at.D;
  const auto for_each_entry = [&](auto visit) {
    for (const ConstraintBlock& block : system.blocks())
      for (int k = 0; k < block.rows; ++k)
        for (int c = 0; c < 6; ++c)
          visit(D[static_cast<std::size_t>(block.offset + 6 * k + c)], block.row + k, 6 * block.body + c);
  };
  for_each_entry([&](double& value, int row, int velocity) {
    largest[row] = std::max(largest[row], std::abs(value));
    value *= scale[velocity];
    norms[row] += value * value;
  });
  for_each_entry(
      [&](double& value, int row, int) { value = largest[row] > zero_row ? value / std::sqrt(norms[row]) : 0.0; });
  return D;
}

/// True where the rows of a block are independent on its body alone.
bool independent(const std::vector<double>& D, const ConstraintBlock& block, double tolerance) {
  using Block = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;
  Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 6, Eigen::Dynamic>> qr(
      Eigen::Map<const Block>(D.data() + block.offset, block.rows, 6).transpose());
  qr.setThreshold(tolerance);
  return block.rows <= 6 && qr.rank() == block.rows;
}

/// Marks the joints that hold a body nothing else holds, again and again: the rows of such a joint are independent of
/// all that remain, because only they touch that body.
std::vector<char> peel_open_branches(const System& system, const std::vector<double>& D, double tolerance) {
  std::vector<char> removed(static_cast<std::size_t>(system.joint_count()), 0);
  std::vector<int> joints_left(static_cast<std::size_t>(system.body_count())), leaves;
  for (int body = 0; body < system.body_count(); ++body) {
    const BlockRange blocks = system.body_blocks(body);
    joints_left[static_cast<std::size_t>(body)] = static_cast<int>(blocks.end() - blocks.begin());
    if (joints_left[static_cast<std::size_t>(body)] == 1) leaves.push_back(body);
  }
  while (!leaves.empty()) {
    const int body = leaves.back();
    leaves.pop_back();
    for (const int index : system.body_blocks(body)) {
      const ConstraintBlock& block = system.blocks()[static_cast<std::size_t>(index)];
      if (removed[static_cast<std::size_t>(block.joint)] || !independent(D, block, tolerance)) continue;
      removed[static_cast<std::size_t>(block.joint)] = 1;
      for (const int other : system.joint_blocks(block.joint)) {
        const int neighbor = system.blocks()[static_cast<std::size_t>(other)].body;
        if (--joints_left[static_cast<std::size_t>(neighbor)] == 1 && neighbor != body) leaves.push_back(neighbor);
      }
    }
  }
  return removed;
}

}  // namespace

RankReport rank_of_constraints(const System& system, const Evaluation& at, double tolerance) {
  const std::vector<double> D = scaled_D(system, at);
  std::vector<int> column(static_cast<std::size_t>(system.row_count()), -1);  // of the core, for each row
  std::vector<int> rows_of_core;
  const std::vector<char> removed = peel_open_branches(system, D, tolerance);
  std::vector<Entry> entries;  // of D^T, restricted to the core
  for (const ConstraintBlock& block : system.blocks()) {
    if (removed[static_cast<std::size_t>(block.joint)]) continue;
    for (int k = 0; k < block.rows; ++k) {
      int& place = column[static_cast<std::size_t>(block.row + k)];
      if (place < 0) {
        place = static_cast<int>(rows_of_core.size());
        rows_of_core.push_back(block.row + k);
      }
      for (int c = 0; c < 6; ++c) {
        const double value = D[static_cast<std::size_t>(block.offset + 6 * k + c)];
        if (value != 0.0) entries.push_back({6 * block.body + c, place, value});
      }
    }
  }
  RankReport report;
  report.rows = system.row_count();
  for (const int dependent :
       dependent_columns(system.v_size(), static_cast<int>(rows_of_core.size()), std::move(entries), tolerance))
    report.dependent_rows.push_back(rows_of_core[static_cast<std::size_t>(dependent)]);
  std::sort(report.dependent_rows.begin(), report.dependent_rows.end());
  report.rank = report.rows - static_cast<int>(report.dependent_rows.size());
  report.degrees_of_freedom = system.v_size() - report.rank;
  return report;
}

// ker M and ker D meet iff D K has dependent columns, K a basis of ker M: per massless body the directions without
// inertia.
std::vector<int> free_massless_bodies(const System& system, const Evaluation& at, double tolerance) {
  std::vector<int> owner;
  std::vector<Entry> entries;
  for (const int body : system.massless_bodies()) {
    const MatrixXd kernel = system.massless_directions(body);
    for (Eigen::Index c = 0; c < kernel.cols(); ++c) {
      const int column = static_cast<int>(owner.size());
      owner.push_back(body);
      for (const int index : system.body_blocks(body)) {
        const ConstraintBlock& block = system.blocks()[static_cast<std::size_t>(index)];
        for (int k = 0; k < block.rows; ++k) {
          const double value = Eigen::Map<const Eigen::Matrix<double, 1, 6>>(at.D.data() + block.offset + 6 * k)
                                   .dot(kernel.col(c).transpose());
          if (value != 0.0) entries.push_back({block.row + k, column, value});
        }
      }
    }
  }
  std::vector<int> bodies;
  for (const int column :
       dependent_columns(system.row_count(), static_cast<int>(owner.size()), std::move(entries), tolerance))
    bodies.push_back(owner[static_cast<std::size_t>(column)]);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

}  // namespace linkwork
