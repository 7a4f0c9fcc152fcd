#include "linkwork/constraints/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

double largest(const VectorXd& residual, const VectorXd& lengths, double rate) {
  double most = 0.0;
  for (Eigen::Index row = 0; row < residual.size(); ++row)
    if (const double size = std::abs(residual[row]); size > 0.0) most = std::max(most, size / (lengths[row] * rate));
  return most;
}

}  // namespace

double Residuals::largest_position() const { return largest(Phi, lengths, 1.0); }
double Residuals::largest_velocity() const { return largest(Phi_dot, lengths, rate); }

Residuals residuals_at(const System& system, double t, const ConstVector& q, const ConstVector& v,
                       const ConstVector& history) {
  Evaluation at = system.make_evaluation();
  look_for_interruption();
  system.evaluate(t, q, v, history, at);
  look_for_interruption();
  VectorXd lengths = row_lengths(system, at);
  look_for_interruption();
  const double rate = characteristic_rate(system, at, v);
  look_for_interruption();
  const double roundoff = roundoff_of_positions(system, q);
  return {std::move(at.Phi), std::move(at.Phi_dot), std::move(lengths), rate, roundoff};
}

}  // namespace linkwork
