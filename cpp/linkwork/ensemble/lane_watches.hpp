#pragma once

#include <vector>

#include "linkwork/ensemble/lane.hpp"
#include "linkwork/ensemble/lane_speeds.hpp"
#include "linkwork/ensemble/lane_stepper.hpp"

namespace linkwork {

/// What the watches of lanes look at in every step, found for all lanes of a pack at once; and the states of single
/// lanes, taken out once a step.
class LaneWatches {
 public:
  /// Refers to the stepper, whose lanes these are.
  LaneWatches(const LaneStructure& structure, const InstructionSet& instructions, const LaneStepper& stepper,
              const std::vector<Lane*>& lanes);

  bool watched() const { return watched_; }  ///< whether any lane looks out for singular poses
  bool judged() const { return judged_; }    ///< whether any is to have a verdict

  // At the start of a step, where the stepper has evaluated.
  void begin_step();
  Speeds speeds(int l) const;
  double kinetic_energy(int l, const Evaluation& at, const VectorXd& y) const;  ///< inerters included [J]
  /// After it.
  void end_step(double h);
  /// Of a lane, see StepSampling.
  Rates rates(int l) const { return {found_[layout_.index(0, l)], found_[layout_.index(1, l)]}; }

  /// Rates over the last step of a lane that comes from another pack, or goes to one.
  void take_up(int l, Lane& lane);
  void hand_on(int l, Lane& lane) const;

  const VectorXd& state(int l);         ///< y of a lane
  const VectorXd& state_before(int l);  ///< where the step began
  void set_state(int l, const VectorXd& y);

 private:
  const LaneStructure& structure_;
  const LaneSpeeds& kernels_;
  const LaneStepper& stepper_;
  LaneLayout layout_;
  bool watched_ = false, judged_ = false;
  int every_body_ = 1;
  AlignedDoubles in_loops_, rotors_, squared_length_, speeds_, kinetic_, rates_, found_;
  std::vector<VectorXd> states_, before_;
  std::vector<char> known_, known_before_;
};

}  // namespace linkwork
