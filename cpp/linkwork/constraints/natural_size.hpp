#pragma once

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Sizes of displacements, velocities and accelerations of a mechanism in its own length: no unit of length or mass
/// decides what is small. The largest of all bodies counts, or of those of each connected component: what moves beside
/// a mechanism, however fast, says nothing about it.
class NaturalSize {
 public:
  explicit NaturalSize(const System& system);

  /// Of x, 6 per body: the rotation, or the translation relative to the body's length.
  double of(const ConstVector& x) const;
  void of(const ConstVector& x, VectorXd& components) const;
  /// M^-1 a of the bodies alone, those without mass left out: what forces would do without joints [1/s^2].
  double of_free_motion(const ConstVector& a) const;
  void of_free_motion(const ConstVector& a, VectorXd& components) const;
  /// What they would do to a body as heavy as the heaviest one.
  void of_heaviest(const ConstVector& a, VectorXd& components) const;
  /// |x| / size, which may both be nothing.
  static double ratio(double x, double size) { return x > 0.0 ? x / size : 0.0; }
  /// The largest of all components.
  static double largest_ratio(const VectorXd& x, const VectorXd& sizes);

  double length(int body) const { return lengths_[body]; }

 private:
  double square(const ConstVector& x, int body) const;
  double of_free_body(const ConstVector& a, int body) const;
  double of_forces(const ConstVector& a, int body) const;  ///< torques over its length [N]

  const System* system_;
  const ConnectedComponents* components_;
  VectorXd lengths_;
  VectorXd heaviest_;  ///< mass of each component [kg]
};

}  // namespace linkwork
