#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Violation of the position constraints relative to the size of the mechanism, whatever their units; of each of
/// ConnectedParts relative to its own.
class RelativeViolation {
 public:
  explicit RelativeViolation(const System& system);

  /// The largest at (t, y), y = (q, v, ...), with the history variables of special joints: by how much of its
  /// size bodies would have to be displaced, or turned [rad], to meet the equation alone.
  double largest(double t, const VectorXd& y, const VectorXd& history);
  /// There, of each part: by which speed of bodies at least the velocities miss an equation [m/s].
  const VectorXd& speeds() const { return speeds_; }
  const VectorXd& lengths() const { return lengths_; }
  /// Size of each connected part [m]: the longest way from a center of mass to a joint, or between two points that a
  /// joint keeps apart; without any its radius of gyration.
  static VectorXd lengths_of(const System& system);

 private:
  const System& system_;
  VectorXd lengths_;
  Evaluation at_;
  VectorXd squared_;  ///< of each row
  VectorXd speeds_;   ///< of each part
};

}  // namespace linkwork
