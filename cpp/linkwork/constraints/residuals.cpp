#include "linkwork/constraints/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

/// By sizes of rows; without arrays of their own, as large as the model.
template <class Size>
double largest_beyond(const VectorXd& residual, const Size& size, const VectorXd& roundoff) {
  double most = 0.0;
  for (Eigen::Index row = 0; row < residual.size(); ++row)
    if (const double amount = std::abs(residual[row]); amount > 0.0)
      most = std::max(most, amount / size(row) - roundoff[row]);
  return most;
}

}  // namespace

double Residuals::largest() const {
  const auto speed = [this](Eigen::Index row) { return lengths[row] * rates[row]; };
  return std::max(largest_beyond(Phi, lengths, roundoff), largest_beyond(Phi_dot, speed, roundoff));
}

Residuals residuals_at(const System& system, double t, const ConstVector& q, const ConstVector& v,
                       const ConstVector& history) {
  Evaluation at = system.make_evaluation();
  look_for_interruption();
  system.evaluate(t, q, v, history, at);
  look_for_interruption();
  VectorXd lengths = row_lengths(system, at);
  look_for_interruption();
  const VectorXd rates_of_parts = characteristic_rates(system, at, v);
  const VectorXd roundoffs = roundoff_of_parts(system, q);
  VectorXd rates(lengths.size()), roundoff(lengths.size());
  for (Eigen::Index row = 0; row < rates.size(); ++row) {
    const int part = ConnectedParts::of(system).of_row(row);
    rates[row] = rates_of_parts[part];
    roundoff[row] = roundoffs[part];
  }
  look_for_interruption();
  return {std::move(at.Phi), std::move(at.Phi_dot), std::move(lengths), std::move(rates), std::move(roundoff)};
}

}  // namespace linkwork
