#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "linkwork/model/batch.hpp"
#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/joint_force.hpp"
#include "linkwork/model/joint_kind.hpp"
#include "linkwork/model/name_table.hpp"
#include "linkwork/model/shared.hpp"
#include "linkwork/model/special_joint.hpp"
#include "linkwork/model/time_function.hpp"

namespace linkwork {

constexpr int ground = -1;  ///< index of the ground, at rest

/// A rigid body at the initial time.
struct Body {
  double mass = 1.0;                                ///< [kg], >= 0
  Mat3<double> inertia = Mat3<double>::Identity();  ///< about the centre of mass, body axes [kg m^2]
  Vec3<double> position = Vec3<double>::Zero();     ///< centre of mass, inertial [m]
  Vec4<double> orientation = {1.0, 0.0, 0.0, 0.0};  ///< Euler parameters, scalar first, unit
  Vec3<double> velocity = Vec3<double>::Zero();     ///< inertial [m/s]
  Vec3<double> omega = Vec3<double>::Zero();        ///< body-fixed [rad/s]
  /// Take principal moments that violate the triangle inequality, which no real body has.
  bool inertia_as_is = false;
};

/// A joint or force element between bodies i and j (ground = -1).
struct Element {
  int kind = 0;  ///< as joint_info takes it, or index into force_kinds()
  int i = ground, j = ground;
  Attachment<double> at;
  std::size_t first_parameter = 0;  ///< place in the model's list of parameters
};

/// A function of time at a place where not every value makes sense: `value` is not below `least`.
struct Limited {
  Parameter value, least;
  std::string what, than;  ///< such as "rotational_stop 'end': upper" and "lower"; no name where `least` is a number
};

/// A force of the user's own on any bodies, such as a field or a control.
class UserForce {
 public:
  virtual ~UserForce() = default;
  /// Adds to g (6 per body: force inertial, torque about the center of mass in body axes) at q (7 per body; Euler
  /// parameters may be off unit length within a step) and v (6 per body).
  virtual void add(double t, int bodies, const double* q, const double* v, double* g) const = 0;

  /// For ensembles: whether this and that of another mechanism may be asked for together.
  virtual bool goes_with(const UserForce&) const { return false; }
  /// Of `count` such mechanisms at once, at times t, one after the other in q, v and g.
  virtual void add_to_all(int count, const double* t, int bodies, const double* q, const double* v, double* g) const {
    for (std::ptrdiff_t k = 0; k < count; ++k)
      add(t[k], bodies, q + k * position_size * bodies, v + k * velocity_size * bodies, g + k * velocity_size * bodies);
  }
  /// Asked for together it was found to be another one than by itself: no mechanism that has it may be in an ensemble.
  void distrust() const { trusted_ = false; }
  bool trusted() const { return trusted_; }

 private:
  mutable std::atomic<bool> trusted_ = true;  // lanes are on several threads
};

/// The constant description of a mechanism, cheap to copy. Everything is checked when it is added: bad input is a
/// ModelError that names the object and the value, and leaves the model as it was.
class Model {
 public:
  explicit Model(const Vec3<double>& gravity = {0.0, 0.0, -9.81});

  /// Each returns the index of what was added.
  int add_body(const std::string& name, const Body& body);
  int add_joint(const std::string& kind, const std::string& name, int i, int j, const Attachment<double>& at,
                const std::vector<Parameter>& parameters = {});
  int add_force(const std::string& kind, const std::string& name, int i, int j, const Attachment<double>& at,
                const std::vector<Parameter>& parameters);
  /// `at` tells where it is shown and where on j its reaction acts.
  int add_special_joint(const std::string& kind, const std::string& name, int i, int j, const Attachment<double>& at,
                        SpecialJointPtr joint, const std::vector<Parameter>& parameters = {});
  int add_signal(TimeFunctionPtr function);
  void add_user_force(const std::string& name, std::shared_ptr<const UserForce> force);
  /// Times [s] at which users' forces are not smooth.
  void add_breaks(const std::vector<double>& times);
  /// Along the coordinate of a joint that is there, by the coordinate's name in the KindInfo.
  void add_joint_force(const std::string& name, int joint, const std::string& coordinate, CoordinateLawPtr law);

  /// Many at once under one prefix; linear in time and memory. `parameters` holds the kind's number for each element.
  int add_bodies(const Names& names, std::vector<Body> bodies);
  int add_joints(const std::string& kind, const Names& names, std::vector<Element> elements,
                 const std::vector<Parameter>& parameters);
  int add_forces(const std::string& kind, const Names& names, std::vector<Element> elements,
                 const std::vector<Parameter>& parameters);

  const Vec3<double>& gravity() const { return gravity_; }
  const std::vector<Body>& bodies() const { return *bodies_; }
  const std::vector<Element>& joints() const { return *joints_; }
  /// Nothing where the joint is of a kind that is placed on two bodies.
  const SpecialJoint* special_joint(int joint) const;
  const std::vector<Element>& forces() const { return *forces_; }
  const std::vector<Parameter>& joint_parameters() const { return *joint_parameters_; }
  const std::vector<Parameter>& force_parameters() const { return *force_parameters_; }
  const std::vector<TimeFunctionPtr>& signals() const { return signals_; }
  const std::vector<double>& breaks() const { return breaks_; }
  const std::vector<std::shared_ptr<const UserForce>>& user_forces() const { return user_forces_; }
  const std::string& user_force_name(std::size_t k) const { return user_force_names_[k]; }
  const std::vector<JointForce>& joint_forces() const { return *joint_forces_; }
  /// Nothing that acts or drives depends on time, nor is it computed by functions of the user's own.
  bool autonomous() const;
  const std::vector<Limited>& limited() const { return *limited_; }
  const std::vector<int>& joint_rows() const { return *joint_rows_; }  ///< first row of each joint, and the total
  int row_count() const { return joint_rows_->back(); }

  const NameTable& body_names() const { return *body_names_; }
  const NameTable& joint_names() const { return *joint_names_; }
  const NameTable& force_names() const { return *force_names_; }
  const NameTable& own_force_names() const { return *own_force_names_; }  ///< of the user's own forces and laws
  std::string body_name(int body) const { return body == ground ? "ground" : body_names_->name(body); }
  std::string joint_name(int joint) const { return joint_names_->name(joint); }
  int joint_of_row(int row) const;
  double longest_arm() const;  ///< from a center of mass to a joint [m]; 0 where there is none
  /// Such as "revolute 'pin', rotation about joint x".
  std::string describe_row(int row) const;

  VectorXd initial_q() const;  ///< 7 per body
  VectorXd initial_v() const;  ///< 6 per body
  /// History variables at the initial time, see history.hpp; none: the motion begins there.
  const std::vector<double>& initial_history() const { return initial_history_; }
  /// A copy whose bodies are elsewhere at the initial time; joints stay where they are on the bodies.
  Model with_initial_state(const ConstVector& q, const ConstVector& v, std::vector<double> history = {}) const;
  /// A copy without whatever acts on bodies but gravity and joints, from a motion that begins.
  Model without_forces() const;
  /// The same without joints that have functions of time, either: the indices of the others are others.
  Model without_drivers() const;
  /// Whether a parameter of the joint is a function of time.
  bool is_driven(int joint) const;
  /// A copy whose inerters have none, and are then nothing.
  Model without_inertances() const;
  /// A copy with other masses and inertias of all bodies; nothing else of `bodies` counts.
  Model with_masses(const std::vector<Body>& bodies) const;
  /// A copy in which the bodies are at their places less `origins` (3 per body, the same for all that joints connect),
  /// with the joints' points on the ground: joints say the same of it. Forces stay where they are.
  Model seen_from(const VectorXd& origins) const;
  /// A copy with another gravity, and with other masses and inertias of some bodies. ModelError: no body has them.
  Model with_weights(const Vec3<double>& gravity, const std::vector<int>& bodies, const std::vector<double>& masses,
                     const std::vector<Mat3<double>>& inertias) const;

 private:
  enum class Role { joint, force };
  int add_elements(Role role, int index, const KindInfo& info, const Names& names, std::vector<Element> elements,
                   const std::vector<Parameter>& parameters);
  void check_element(Role role, const KindInfo& info, const Names& names, std::size_t k, const Element& element,
                     const Parameter* parameters) const;
  void limit(const KindInfo& info, const std::string& name, const Parameter* parameters);

  Vec3<double> gravity_;
  Shared<std::vector<Body>> bodies_;
  Shared<std::vector<Element>> joints_, forces_;
  Shared<std::vector<Parameter>> joint_parameters_, force_parameters_;
  std::vector<std::pair<int, SpecialJointPtr>> special_joints_;  ///< by ascending joints
  std::vector<TimeFunctionPtr> signals_;
  std::vector<std::shared_ptr<const UserForce>> user_forces_;
  std::vector<std::string> user_force_names_;
  std::vector<double> breaks_;
  Shared<std::vector<JointForce>> joint_forces_;
  Shared<std::vector<Limited>> limited_;
  std::vector<double> initial_history_;
  Shared<std::vector<int>> joint_rows_{std::size_t{1}, 0};
  Shared<NameTable> body_names_{"body"}, joint_names_{"joint"}, force_names_{"force"}, own_force_names_{"force"};
};

}  // namespace linkwork
