#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// By how much a state violates the constraints, and what that is relative to.
struct Residuals {
  VectorXd Phi, Phi_dot;
  VectorXd lengths;   ///< what divides a residual, see row_lengths
  VectorXd rates;     ///< of each row that of its part, and with it one of Phi_dot; see characteristic_rates
  VectorXd roundoff;  ///< of each row that of its part, see roundoff_of_positions

  /// The largest of all rows, relative to the size or the speed of its part, above what roundoff may make of it; what is
  /// no number is passed over.
  double largest() const;
};

Residuals residuals_at(const System& system, double t, const ConstVector& q, const ConstVector& v,
                       const ConstVector& history);

}  // namespace linkwork
