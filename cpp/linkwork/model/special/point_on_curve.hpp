#pragma once

#include <array>

#include "linkwork/model/batch.hpp"
#include "linkwork/model/special_joint.hpp"

namespace linkwork {

/// A cubic spline through points of space with a direction across it: on each piece from knot k on,
/// c(s) = sum_m coefficient_m (s - knot_k)^m, and the direction likewise.
struct Curve {
  std::vector<double> knots;                   ///< ascending, one more than pieces
  std::vector<std::array<Vec3<double>, 4>> c;  ///< of each piece
  std::vector<std::array<Vec3<double>, 4>> e;  ///< nowhere along the curve
  bool closed = false;                         ///< else it goes on straight beyond its ends
};

/// A point of j stays on a curve of i (2 equations).
class PointOnCurve final : public SpecialJoint {
 public:
  /// The curve lies in the frame of the attachment on i. ModelError: no pieces, or knots that do not ascend.
  PointOnCurve(int i, int j, const Attachment<double>& at, Curve curve);
  const std::vector<int>& bodies() const override { return bodies_; }
  HistoryKind history_kind() const override { return HistoryKind::place; }
  int history_size() const override { return 1; }
  void evaluate(const BodyState<double>* bodies, const Signal<double>* parameters, const SpecialHistory& history,
                const SpecialRows& out) const override;
  SpecialJointPtr seen_from(const Vec3<double>& origin) const override;

 private:
  struct Point;
  Point at(double s) const;
  double nearest(const Vec3<double>& d, double s) const;
  double nearest_of_all(const Vec3<double>& d) const;

  std::vector<int> bodies_;
  Attachment<double> at_;
  Curve curve_;
};

}  // namespace linkwork
