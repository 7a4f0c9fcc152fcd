#include "linkwork/constraints/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

double largest(const VectorXd& residual, const VectorXd& sizes) {
  double most = 0.0;
  for (Eigen::Index row = 0; row < residual.size(); ++row)
    if (const double amount = std::abs(residual[row]); amount > 0.0) most = std::max(most, amount / sizes[row]);
  return most;
}

}  // namespace

double Residuals::largest_position() const { return largest(Phi, lengths); }
double Residuals::largest_velocity() const { return largest(Phi_dot, lengths.cwiseProduct(rates)); }

Residuals residuals_at(const System& system, double t, const ConstVector& q, const ConstVector& v,
                       const ConstVector& history) {
  Evaluation at = system.make_evaluation();
  look_for_interruption();
  system.evaluate(t, q, v, history, at);
  look_for_interruption();
  VectorXd lengths = row_lengths(system, at);
  look_for_interruption();
  const VectorXd of_parts = characteristic_rates(system, at, v);
  VectorXd rates(lengths.size());
  for (Eigen::Index row = 0; row < rates.size(); ++row) rates[row] = of_parts[ConnectedParts::of(system).of_row(row)];
  look_for_interruption();
  const double roundoff = roundoff_of_positions(system, q);
  return {std::move(at.Phi), std::move(at.Phi_dot), std::move(lengths), std::move(rates), roundoff};
}

}  // namespace linkwork
