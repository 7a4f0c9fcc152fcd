#pragma once

#include <memory>
#include <string>

#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/joint_coordinates.hpp"

namespace linkwork {

/// A law of the user's own: the force [N] or torque [N m] Q along a coordinate that does the work Q dx.
class CoordinateLaw {
 public:
  virtual ~CoordinateLaw() = default;
  virtual double effort(double t, double x, double x_dot) const = 0;
  virtual bool of_time() const { return false; }  ///< alone
};

using CoordinateLawPtr = std::shared_ptr<const CoordinateLaw>;

/// The law that is a function of time alone.
CoordinateLawPtr law_of_time(TimeFunctionPtr function);

/// A law along a free coordinate of a joint between bodies i and j (ground = -1).
struct JointForce {
  std::string name;
  int i, j;
  Attachment<double> at;
  const FreeCoordinate* coordinate;
  CoordinateLawPtr law;

  /// An angle goes on over full turns.
  HistoryKind history_kind() const { return coordinate->angle() ? HistoryKind::angle : HistoryKind::none; }
  void evaluate(double t, const BodyState<double>& body_i, const BodyState<double>& body_j,
                HistoryVariable<double>& history, Wrenches<double>& out) const;
};

}  // namespace linkwork
