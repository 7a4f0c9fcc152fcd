#include "linkwork/formulation/rank.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/linear/column_rank.hpp"

namespace linkwork {
namespace {

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

}  // namespace

RankReport rank_of_constraints(const System& system, const Evaluation& at, double tolerance) {
  const VectorXd scale = velocity_scale(system);
  std::vector<Entry> entries;  // of D^T
  VectorXd norms = VectorXd::Zero(system.row_count());
  for (const ConstraintBlock& block : system.blocks())
    for (int k = 0; k < block.rows; ++k)
      for (int c = 0; c < 6; ++c) {
        const double value = at.D[static_cast<std::size_t>(block.offset + 6 * k + c)] * scale[6 * block.body + c];
        if (value != 0.0) entries.push_back({6 * block.body + c, block.row + k, value});
        norms[block.row + k] += value * value;
      }
  for (Entry& entry : entries) entry.value /= std::sqrt(norms[entry.column]);
  RankReport report;
  report.rows = system.row_count();
  report.dependent_rows = dependent_columns(system.v_size(), system.row_count(), std::move(entries), tolerance);
  report.rank = report.rows - static_cast<int>(report.dependent_rows.size());
  report.degrees_of_freedom = system.v_size() - report.rank;
  return report;
}

// ker M and ker D meet iff D K has dependent columns, K a basis of ker M: per massless body the directions without inertia.
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
          const double value =
              Eigen::Map<const Eigen::Matrix<double, 1, 6>>(at.D.data() + block.offset + 6 * k).dot(kernel.col(c).transpose());
          if (value != 0.0) entries.push_back({block.row + k, column, value});
        }
      }
    }
  }
  std::vector<int> bodies;
  for (const int column : dependent_columns(system.row_count(), static_cast<int>(owner.size()), std::move(entries), tolerance))
    bodies.push_back(owner[static_cast<std::size_t>(column)]);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

}  // namespace linkwork
