#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "linkwork/assembly/body_forces.hpp"
#include "linkwork/assembly/constraint_block.hpp"
#include "linkwork/assembly/element_coordinates.hpp"
#include "linkwork/assembly/inerters.hpp"
#include "linkwork/assembly/joint_reactions.hpp"
#include "linkwork/math/aligned.hpp"
#include "linkwork/math/kept.hpp"
#include "linkwork/math/thread_pool.hpp"
#include "linkwork/math/types.hpp"
#include "linkwork/model/model.hpp"

namespace linkwork {

/// To which element a history variable belongs: a place in the model's joints or forces.
struct HistoryOwner {
  HistoryKind kind;
  bool joint;
  int element;
};

/// The blocks that a joint or a body takes part in: places in System::blocks().
struct BlockRange {
  const int* first;
  const int* last;
  const int* begin() const { return first; }
  const int* end() const { return last; }
};

/// What an evaluation fills, allocated once by System::make_evaluation.
struct Evaluation {
  std::vector<BodyState<double>> bodies;   ///< for force elements that are evaluated one by one, if there are any
  std::vector<BodyState<double>> special;  ///< scratch: the bodies of a special joint
  std::vector<Signal<double>> signals;
  AlignedDoubles D;       ///< blocks of D, see ConstraintBlock
  VectorXd history;       ///< what it becomes where this state is accepted, see HistoryVariable
  VectorXd history_rate;  ///< of those that are angles
  VectorXd switches;      ///< of force elements whose law is not smooth, see Wrenches
  VectorXd Phi, Phi_t, Phi_dot, gamma;
  VectorXd coordinate_gamma;  ///< of coordinates of elements, those of inerters first
  VectorXd coordinates;       ///< of elements, see ElementCoordinates
  VectorXd coordinate_rates;
  VectorXd user;                   ///< scratch of the user's own forces
  std::vector<double> wrenches;    ///< scratch of force elements, where there are many, see ForceArrays
  std::vector<double> potentials;  ///< of gravity, of many bodies: in each chunk
  VectorXd g;                      ///< 6 per body (the ground's entries follow and are not used)
  double potential = 0.0;          ///< of gravity and springs [J]
  double power = 0.0;              ///< of the forces without a potential [W]
};

/// A Model compiled to flat arrays with a fixed sparsity: everything in
///   M v_dot - D^T lambda = g  (12.1),   D v_dot = gamma  (12.2),   Phi_dot = D v + Phi_t
/// at a state (t, q, v) with its history, see history.hpp. Constant after construction; the numbers live in an
/// Evaluation. What an evaluation finds is a function of its arguments, whatever was evaluated before.
class System {
 public:
  using ConstMat3 = Eigen::Map<const Mat3<double>>;
  /// Bodies, or joints, that a thread works on at a time. Sums over chunks are the same with one thread.
  static constexpr int chunk = 4096;

  explicit System(const Model& model, const InstructionSet& instructions = best_instruction_set());
  // Large, and never meant to be copied.
  System(const System&) = delete;
  System& operator=(const System&) = delete;

  int body_count() const { return static_cast<int>(mass_.size()); }
  int joint_count() const { return static_cast<int>(model_.joints().size()); }
  int row_count() const { return model_.row_count(); }
  int q_size() const { return position_size * body_count(); }
  int v_size() const { return velocity_size * body_count(); }
  const Model& model() const { return model_; }
  bool time_dependent_constraints() const { return !driven_rows_.empty(); }
  bool has_special_joints() const { return !special_joints_.empty(); }

  /// Sums over bodies, joints and forces are made by its threads from here on. No bit depends on how many these are.
  void use(std::shared_ptr<ThreadPool> threads) { threads_ = std::move(threads); }
  ThreadPool& threads() const { return *threads_; }
  const std::shared_ptr<ThreadPool>& shared_threads() const { return threads_; }

  /// Whether there is enough work in an evaluation for several threads.
  bool shares_work() const;

  /// What is found once about this system and used again.
  Kept& kept() const { return kept_; }

  Evaluation make_evaluation() const;

  /// Fills everything in `out`. p need not be a unit vector. `history` is that of the last accepted state. Does not
  /// allocate.
  void evaluate(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                Evaluation& out) const;
  /// Only the constraints: Phi, Phi_t, Phi_dot, gamma, D, and the history of the joints.
  void evaluate_constraints(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                            Evaluation& out) const;
  /// Only the coordinates that force elements lie along, and so what inerters add to M, and their gamma.
  void evaluate_coordinates(const ConstVector& q, const ConstVector& v, Evaluation& out) const;
  /// Only force elements: their history and their switches.
  void evaluate_switches(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                         Evaluation& out) const;

  // For ensembles, which evaluate bodies and joints of many mechanisms at once.
  /// Functions of time.
  void evaluate_signals(double t, Evaluation& out) const { evaluate_signals(t, out.signals); }
  void evaluate_signals(double t, std::vector<Signal<double>>& out) const;
  void evaluate_special_joints(const ConstVector& q, const ConstVector& v, const ConstVector& history,
                               Evaluation& out) const;
  /// Force elements by their kinds, but inerters.
  const std::vector<ForceBatch>& force_batches() const { return force_batches_; }
  /// Those of one kind, at the signals and bodies of `at`, from a multiple of their width on.
  void evaluate_elements_of(std::size_t kind, int first, int last, const ConstVector& q, const ConstVector& v,
                            const Evaluation& at, const ForceArrays& out) const;
  /// The user's own laws along coordinates, added to `out.g` and `out.power`.
  void evaluate_joint_forces(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                             Evaluation& out) const;
  /// What one force of the user's own, 6 per body, does to bodies of velocities v.
  void add_user_force(const VectorXd& force, const ConstVector& v, Evaluation& out) const;

  // History variables: those of special joints, then those of force elements.
  int history_size() const { return static_cast<int>(history_owners_.size()); }
  const std::vector<HistoryOwner>& history_owners() const { return history_owners_; }
  /// Of each switch the history variable of the contact that begins where it becomes positive, or -1.
  const std::vector<int>& switches() const { return switches_; }
  /// Whether one is under way after a step that was not before it.
  bool begins_contact(const ConstVector& history_before, const ConstVector& history_after) const;
  std::string history_element(int variable) const;  ///< the name of its joint, force element or law of a joint's force
  std::string history_name(int variable) const;     ///< such as "force 'mainspring'"
  /// That of the model, or of a motion that begins: angles within half a turn of zero, no contacts. Where a joint is
  /// placed is known, whether spheres touch is not: see Dynamics::initial_history.
  const VectorXd& initial_history() const { return initial_history_; }
  /// The same of a motion that begins at any state, contacts that are under way included.
  VectorXd beginning_history(double t, const ConstVector& q, const ConstVector& v) const;

  /// q_dot = N(q) v.
  void position_rates(const ConstVector& q, const ConstVector& v, MutableVector q_dot) const;
  /// Scales every p to unit length.
  void normalize(MutableVector q) const;

  /// What one of the user's own laws along coordinates applies.
  Wrenches<double> joint_force(std::size_t k, double t, const ConstVector& q, const ConstVector& v,
                               HistoryVariable<double>& history) const;

  // The mass matrix: blocks diag(m I, J), constant, and what inerters add to it.
  double mass(int body) const { return mass_[body].m; }
  double inverse_mass(int body) const { return mass(body) > 0.0 ? 1.0 / mass(body) : 0.0; }
  ConstMat3 inertia(int body) const { return ConstMat3(mass_[body].J); }
  Mat3<double> inverse_inertia(int body) const;
  const std::vector<MassBlock>& mass_blocks() const { return mass_; }
  std::ptrdiff_t row_of_zeros() const { return D_size_; }  ///< its place in D
  /// Bodies whose mass or inertia is singular; their inverses are zero in the singular directions.
  const std::vector<int>& massless_bodies() const { return massless_; }
  /// Basis of the kernel of a body's mass matrix (6 x its dimension).
  MatrixXd massless_directions(int body) const;
  const Inerters& inerters() const { return inerters_; }
  const ElementCoordinates& element_coordinates() const { return coordinates_; }
  void multiply_mass(const Evaluation& at, const ConstVector& x, MutableVector y) const;  ///< y = M x
  /// y = M^-1 x without inerters.
  void multiply_inverse_mass(const ConstVector& x, MutableVector y) const;
  /// Of velocities at the positions of an evaluation [J].
  double kinetic_energy(const Evaluation& at, const ConstVector& v) const;

  // The constraint matrix.
  const std::vector<ConstraintBlock>& blocks() const { return blocks_; }
  BlockRange joint_blocks(int joint) const { return range(joint_block_list_, joint_block_begin_, joint); }
  BlockRange body_blocks(int body) const { return range(body_block_list_, body_block_begin_, body); }
  void multiply_D(const Evaluation& at, const ConstVector& x, MutableVector y) const;             ///< y = D x
  void add_D_transposed(const Evaluation& at, const ConstVector& lambda, MutableVector y) const;  ///< y += D^T lambda
  /// What drivers take up, lambda . Phi_t [W].
  double power_of_drivers(const Evaluation& at, const ConstVector& lambda) const;
  const std::vector<int>& driven_rows() const { return driven_rows_; }  ///< no others have a Phi_t
  /// diag(D M^-1 D^T): how strongly each row accelerates under its own multiplier.
  VectorXd delassus_diagonal(const Evaluation& at) const;

  /// What joint k exerts on its second body, for all joints: force and torque about the joint's point on the second
  /// body, inertial axes (3 x joints each).
  void reactions(const Evaluation& at, const ConstVector& q, const ConstVector& lambda,
                 Eigen::Ref<Eigen::Matrix3Xd> force, Eigen::Ref<Eigen::Matrix3Xd> torque) const;

  /// Inertial axes (columns) of a joint's frame, fixed in its first body.
  Mat3<double> joint_frame(int joint, const ConstVector& q) const;

 private:
  struct CompiledJoints {
    EvaluateJoints evaluate;
    JointReactions reactions;
    int rows;  ///< of each
    bool holds_point;
    int width;  ///< so many at a time
    JointBatch batch;
  };
  struct JointChunk {
    const CompiledJoints* kind;  ///< of joints_
    JointArrays joints;
  };
  struct CompiledSpecialJoint {
    const SpecialJoint* special;
    int joint, row, rows;
    std::ptrdiff_t D, history;  ///< places
  };
  void compile_masses();
  void append_kind(int kind, int count);
  void compile_joints();
  void compile_special_joint(int joint, const SpecialJoint& special);
  void list_driven_rows();
  void compile_forces();
  void begin_force_batches();
  void append_force(int force);
  bool evaluated_one_by_one(std::size_t kind) const;
  void list_posed_bodies();
  void place_wrenches();
  void begin_history();
  VectorXd blank_history() const;
  void add_history(HistoryKind kind, bool joint, int element, int count);
  BodyState<double> pose(int body, const ConstVector& q) const;  ///< at rest
  BodyState<double> moving(int body, const ConstVector& q, const ConstVector& v) const;
  /// Force and torque on its second body.
  std::pair<Vec3<double>, Vec3<double>> special_reaction(const CompiledSpecialJoint& of, const Evaluation& at,
                                                         const ConstVector& q, const ConstVector& lambda) const;
  void check_limits(double t, const std::vector<Signal<double>>& signals) const;
  void evaluate_forces(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history,
                       Evaluation& out) const;
  void evaluate_user_forces(double t, const ConstVector& q, const ConstVector& v, Evaluation& out) const;
  void evaluate_special_joint(const CompiledSpecialJoint& joint, const ConstVector& q, const ConstVector& v,
                              const ConstVector& history, Evaluation& out) const;
  void evaluate_chunks(const ConstVector& q, const ConstVector& v, bool with_bodies, Evaluation& out) const;
  void evaluate_joints(const JointChunk& of, const ConstVector& q, const ConstVector& v, Evaluation& out) const;
  void evaluate_bodies(int part, const ConstVector& q, const ConstVector& v, Evaluation& out) const;
  void evaluate_other_constraints(const ConstVector& q, const ConstVector& v, const ConstVector& history,
                                  Evaluation& out) const;
  void pose_bodies(const ConstVector& q, const ConstVector& v, Evaluation& out) const;
  void evaluate_elements(const ConstVector& q, const ConstVector& v, const ConstVector& history, Evaluation& out) const;
  void evaluate_many_elements(const ConstVector& q, const ConstVector& v, const ForceArrays& arrays,
                              Evaluation& out) const;
  void add_wrenches(const ForceArrays& arrays, Evaluation& out) const;

  static BlockRange range(const std::vector<int>& list, const std::vector<int>& begin, int k) {
    return {list.data() + begin[k], list.data() + begin[k + 1]};
  }

  Model model_;
  InstructionSet instructions_;
  BodyForces body_forces_;
  std::vector<MassBlock> mass_;
  std::vector<int> massless_;                              ///< ascending
  std::vector<Mat3<double>> massless_inverses_;            ///< of their inertias
  std::vector<CompiledJoints> joints_;                     ///< one per kind in use
  std::vector<JointChunk> joint_chunks_;                   ///< of all of them
  std::vector<ForceBatch> force_batches_;                  ///< one per registered kind, none of inerters
  std::vector<std::size_t> force_kinds_in_use_;            ///< of which there are elements in these batches
  std::vector<int> force_levels_;                          ///< instruction sets by which they are evaluated
  std::vector<int> posed_bodies_;                          ///< of elements that are evaluated one by one, ascending
  std::vector<int> body_wrench_list_, body_wrench_begin_;  ///< of many elements: 2 x element + which body
  std::vector<char> called_alone_;                         ///< per kind: some call functions of the user's
  std::vector<int> joint_force_history_;                   ///< places, -1 where there is none
  std::vector<CompiledSpecialJoint> special_joints_;
  std::size_t most_bodies_ = 0;  ///< of a special joint
  std::vector<ConstraintBlock> blocks_;
  std::vector<int> joint_block_list_, joint_block_begin_;
  std::vector<int> body_block_list_, body_block_begin_;
  std::ptrdiff_t D_size_ = 0;
  Inerters inerters_;
  ElementCoordinates coordinates_;
  std::vector<HistoryOwner> history_owners_;
  std::vector<int> switches_;
  VectorXd initial_history_;
  std::vector<int> driven_rows_;  ///< of joints with a parameter that is a function of time, ascending
  std::shared_ptr<ThreadPool> threads_ = std::make_shared<ThreadPool>();
  mutable Kept kept_;
};

using BlockOfD = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, velocity_size, Eigen::RowMajor>>;

inline BlockOfD block_of(const Evaluation& at, const ConstraintBlock& block) {
  return BlockOfD(at.D.data() + block.offset, block.rows, velocity_size);
}

}  // namespace linkwork
