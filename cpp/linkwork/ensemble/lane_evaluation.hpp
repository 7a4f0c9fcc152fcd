#pragma once

#include <utility>
#include <vector>

#include "linkwork/ensemble/lane_layout.hpp"
#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/ensemble/lane_user_forces.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {

/// What an Evaluation has, of mechanisms in lanes.
struct LaneValues {
  AlignedDoubles D, Phi, Phi_t, Phi_dot, gamma;
  AlignedDoubles g;  ///< of the ground, which nobody uses, behind the bodies
  AlignedDoubles potential, power;
};

/// System::evaluate for mechanisms in lanes: bodies, joints, coordinates and force elements without functions of the
/// state all at once. Lane by lane: functions of time, special joints, and forces that are the user's own in whole or in
/// part.
class LaneEvaluation {
 public:
  LaneEvaluation(const LaneStructure& structure, const InstructionSet& instructions,
                 const std::vector<Dynamics*>& mechanisms);
  // It holds places in its own numbers.
  LaneEvaluation(const LaneEvaluation&) = delete;
  LaneEvaluation& operator=(const LaneEvaluation&) = delete;

  /// Another mechanism in a lane.
  void replace(int l, Dynamics& mechanism);

  /// At the time of each lane and states y = (q, v, work).
  void evaluate(const AlignedDoubles& t, const AlignedDoubles& y, LaneGuard& guard);
  /// Without forces.
  void evaluate_constraints(const AlignedDoubles& t, const AlignedDoubles& y, LaneGuard& guard);

  const LaneValues& at() const { return at_; }
  /// Room for D, with what is constant in it.
  void size_D(AlignedDoubles& D) const;
  /// D changes places with another one that was sized so, until the next evaluation.
  void exchange_D(AlignedDoubles& other) { std::swap(at_.D, other); }
  const AlignedDoubles& mass() const { return mass_; }
  const AlignedDoubles& inertance() const { return inertance_; }
  /// Whether there is power of force elements or drivers.
  bool has_power() const { return !forces_.empty() || apart_ || structure_.time_dependent; }
  /// What a run by itself would find of its inerters.
  void take_inerters(int l, Evaluation& out) const;
  /// Of the force elements of one lane, until the next call.
  const VectorXd& switches(int l);

 private:
  using Numbers = AlignedDoubles;
  /// Of the elements of one kind, as their kernels read them; which elements these are says the structure.
  struct Elements {
    Numbers attachments, parameters;
    int parameter_count = 0;
  };
  /// A parameter that is a function of time, and where its value, rate and acceleration go.
  struct Driven {
    int signal;
    double* to;
  };

  const Dynamics& mechanism(int l) const;
  void list_posed_bodies();
  void allocate();
  void allocate(Elements& elements, std::ptrdiff_t count, std::size_t parameter_count) const;
  void load(int l, const Dynamics& mechanism);
  void load_joints(int l, const Model& model);
  void load_coordinates(int l, const System& system);
  void load_forces(int l, const System& system);
  void load_parameter(int l, const Parameter& parameter, Elements& to, std::ptrdiff_t place);
  bool needs_lane_by_lane(const System& system) const;
  template <class Action>
  void each_lane(const LaneGuard& guard, Action action);
  template <class Action>
  void apart(int l, LaneGuard& guard, Action action);

  void begin_apart(const Numbers& t, const Numbers& y, LaneGuard& guard);
  void evaluate_signals(const Numbers& t, LaneGuard& guard);
  void give_signals(int l, const std::vector<Signal<double>>& signals);
  void give_special_joints(int l, const Evaluation& at);
  void pose_bodies(int l, Evaluation& at) const;
  void evaluate_rows();
  void evaluate_forces(LaneGuard& guard);
  void evaluate_lane_by_lane(int kind, LaneGuard& guard);
  void take_history(int l, Evaluation& at) const;
  void evaluate_other_forces(LaneGuard& guard);
  void take_forces(int l, Evaluation& at) const;
  void give_forces(int l, const Evaluation& at);

  const LaneStructure& structure_;
  const LaneKernels& kernels_;
  LaneLayout layout_;
  int level_;
  std::vector<Dynamics*> mechanisms_;
  LaneUserForces user_forces_;  ///< with the state and the evaluation of each lane
  bool apart_ = false;          ///< there is something that is done lane by lane, at its state
  std::vector<int> posed_;      ///< bodies of force elements that are evaluated so

  LaneValues at_;
  Numbers mass_, gravity_, states_, inertance_;
  std::vector<Elements> joints_, coordinates_, forces_;  ///< as in the structure
  std::vector<EvaluateJointLanes> coordinate_rows_;      ///< of the same kinds
  Numbers coordinate_values_, coordinate_Phi_t_, coordinate_rates_, coordinate_gamma_;
  Numbers switches_;  ///< see Wrenches
  VectorXd switches_of_lane_;
  Numbers last_, next_, rate_;  ///< history variables
  // Of each lane.
  std::vector<std::vector<Driven>> driven_;
  std::vector<std::vector<Signal<double>>> signals_;
  bool driven_at_all_ = false;  ///< there are any
};

}  // namespace linkwork
