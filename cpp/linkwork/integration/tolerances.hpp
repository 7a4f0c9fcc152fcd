#pragma once

#include "linkwork/assembly/connected_components.hpp"

namespace linkwork {

/// Bounds of the error of a step: relative + absolute, the latter in m, rad, m/s and rad/s.
struct Tolerances {
  double relative = 1e-6;
  double absolute = 1e-9;
};

/// A number and the body that it comes from.
struct BodyMaximum {
  double value = 0.0;
  int body = -1;
};

/// Measures states and their changes in units of the tolerances. Each body counts by four lengths of vectors, which no
/// choice of axes changes: its position, the angle of its rotation, its velocity, its angular velocity. The largest of
/// all bodies is the result: what moves little in a large model does not hide what moves much.
///
/// An angle has no natural size: its bound is (relative + absolute) rad. The work in y counts nowhere.
class ErrorMeasure {
 public:
  ErrorMeasure(const System& system, const Tolerances& tolerances) : system_(system), tolerances_(tolerances) {}

  /// Bounds follow from the larger of the states y and y_new; dy is a difference of states or, for `rates`, y_dot.
  BodyMaximum of_change(const ConstVector& y, const ConstVector& y_new, const ConstVector& dy) const;
  /// The same of each of ConnectedParts.
  VectorXd of_parts(const ConstVector& y, const ConstVector& y_new, const ConstVector& dy) const;
  /// Size of the state itself; a rotation counts as 1 rad.
  double of_state(const ConstVector& y) const;
  /// The bound of a position's error, of the body that has the largest, or of a rotation's.
  double of_length(const ConstVector& y) const;

 private:
  double of_body(int body, const ConstVector& y, const ConstVector& y_new, const ConstVector& dy) const;
  double bound(double size) const { return tolerances_.absolute + tolerances_.relative * size; }

  const System& system_;
  Tolerances tolerances_;
};

}  // namespace linkwork
