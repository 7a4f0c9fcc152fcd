#pragma once

#include <vector>

#include "linkwork/constraints/natural_size.hpp"
#include "linkwork/ensemble/lane_stepper.hpp"
#include "linkwork/formulation/projection.hpp"

namespace linkwork {

/// Takes states of several mechanisms back to the constraints, each in as many iterations as Projection by itself. Those
/// that do not come there, or are in a singular pose, leave.
class LaneProjection {
 public:
  /// Of the mechanisms of the stepper.
  LaneProjection(LaneStepper& stepper, const std::vector<Dynamics*>& mechanisms);

  /// What the stabilization of the runs asks for, if anything: of the states of the stepper, at t of each lane.
  void stabilize(const AlignedDoubles& t, LaneGuard& guard);

 private:
  struct Lane {
    const Dynamics* mechanism;
    NaturalSize size;
    ProjectionProgress progress;
    double scale = 1.0;  ///< of changes: the reach of the mechanism, or the largest rate
    double by_forces = 0.0;
    bool going_on = false;
  };

  int count() const { return static_cast<int>(lanes_.size()); }
  void measure_forces(const LaneGuard& guard);
  void begin(LaneStepper::Violation of, const LaneGuard& guard);
  void iterate(LaneStepper::Violation of, const AlignedDoubles& t, LaneGuard& guard);
  void judge(int l, LaneStepper::Violation of, double t, LaneGuard& guard);
  double move(int l);
  double accelerate(int l);

  LaneStepper& stepper_;
  StabilizationKind kind_;
  std::vector<Lane> lanes_;
  bool here_ = false, factorized_ = false;  ///< the states are where they were evaluated; were factorized
  VectorXd y_, x_;
};

}  // namespace linkwork
