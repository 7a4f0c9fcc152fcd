#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Violation of the position constraints relative to the size of the mechanism, whatever their units.
class RelativeViolation {
 public:
  explicit RelativeViolation(const System& system);

  /// The largest at (t, y), y = (q, v, ...), with the history variables of special joints: by how much of its
  /// size bodies would have to be displaced, or turned [rad], to meet the equation alone.
  double largest(double t, const VectorXd& y, const VectorXd& history);
  /// Size of the mechanism [m]: the longest way from a center of mass to a joint, or between two points that a joint
  /// keeps apart; without any its radius of gyration.
  double length() const { return length_; }
  static double length_of(const System& system);

 private:
  const System& system_;
  double length_;
  Evaluation at_;
  VectorXd squared_;  ///< of each row
};

}  // namespace linkwork
