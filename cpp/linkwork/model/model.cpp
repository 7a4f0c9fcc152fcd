#include "linkwork/model/model.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <utility>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

const KindInfo& force_info(int kind) { return force_kinds()[kind].info; }

constexpr double tolerance = 1e-9;       // relative, of inertia and of joint frames
constexpr double unit_tolerance = 1e-6;  // of |p| - 1

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

template <class Derived>
std::string text(const Eigen::MatrixBase<Derived>& values) {
  std::string out = "(";
  for (int k = 0; k < values.size(); ++k) out += (k ? ", " : "") + text(values.derived().coeff(k));
  return out + ")";
}

/// Made where a message wants it: most of a million bodies are as they should be.
using NameWhereWanted = std::function<std::string()>;

/// The body's field is wrong.
[[noreturn]] void refuse(const char* code, const char* field, const std::string& why, const NameWhereWanted& body) {
  ErrorDetails details;
  details.bodies = {body()};
  details.subject = "body '" + details.bodies.front() + "'";
  details.field = field;
  throw ModelError(code, details.subject + ": " + why, details);
}

template <class Derived>
void check_finite(const Eigen::MatrixBase<Derived>& values, const char* quantity, const NameWhereWanted& name) {
  if (!values.allFinite())
    refuse("not_finite", quantity, std::string(quantity) + " " + text(values) + " is not finite", name);
}

/// Principal moments of a real body satisfy J_1 + J_2 >= J_3 for every order, and none is negative. `as_is`: only the
/// latter is asked for.
void check_inertia(const Mat3<double>& J, bool as_is, const NameWhereWanted& name) {
  const double scale = J.cwiseAbs().maxCoeff();
  if (const double gap = (J - J.transpose()).cwiseAbs().maxCoeff(); gap > tolerance * scale)
    refuse("inertia_not_symmetric", "inertia",
           "the inertia is not symmetric: entries across the diagonal differ by " + text(gap) + " kg m^2", name);
  Vec3<double> moments = J.diagonal();
  if (!J.isDiagonal(0.0))
    moments = Eigen::SelfAdjointEigenSolver<Mat3<double>>(J, Eigen::EigenvaluesOnly).eigenvalues();
  std::sort(moments.data(), moments.data() + 3);
  if (moments[0] < -tolerance * scale)
    refuse("inertia_negative", "inertia", "principal moment of inertia " + text(moments[0]) + " kg m^2 is negative",
           name);
  if (!as_is && moments[2] > (moments[0] + moments[1]) * (1.0 + tolerance) + tolerance * scale)
    refuse("inertia_triangle", "inertia",
           "principal moments of inertia " + text(moments) +
               " violate the triangle inequality: the largest exceeds the sum of the others by " +
               text(moments[2] - moments[0] - moments[1]) + " kg m^2, which it must not",
           name);
}

void check_body(const Body& body, const NameWhereWanted& name) {
  if (!std::isfinite(body.mass) || body.mass < 0)
    refuse("mass", "mass", "mass " + text(body.mass) + " kg must be finite and not negative", name);
  check_finite(body.inertia, "inertia", name);
  check_finite(body.position, "position", name);
  check_finite(body.orientation, "orientation", name);
  check_finite(body.velocity, "velocity", name);
  check_finite(body.omega, "omega", name);
  check_inertia(body.inertia, body.inertia_as_is, name);
  const double norm = body.orientation.norm();
  if (std::abs(norm - 1.0) > unit_tolerance)
    refuse("orientation", "orientation",
           "orientation " + text(body.orientation) + " has norm " + text(norm) +
               " and must be unit Euler parameters (e0, e1, e2, e3)",
           name);
}

void check_gravity(const Vec3<double>& gravity) {
  if (!gravity.allFinite()) throw ModelError("not_finite", "gravity " + text(gravity) + " is not finite");
}

bool orthonormal(const Mat3<double>& C) {
  return (C.transpose() * C - Mat3<double>::Identity()).cwiseAbs().maxCoeff() < tolerance && C.determinant() > 0;
}

std::string wanted(const Bounds& bounds) {
  if (bounds.least == 0.0) return bounds.above ? "must be positive" : "must not be negative";
  return std::string(bounds.above ? "must be above " : "must be at least ") + text(bounds.least);
}

const Parameter& value_of(const KindInfo& info, const std::string& name, const Parameter* parameters) {
  const auto same = [&](const ParameterInfo& parameter) { return parameter.name == name; };
  return parameters[std::find_if(info.parameters.begin(), info.parameters.end(), same) - info.parameters.begin()];
}

/// A code, and why a parameter is not as it has to be; "" where it is.
using Fault = std::pair<const char*, std::string>;

Fault fault_of_number(const KindInfo& info, const ParameterInfo& it, double value, const Parameter* parameters) {
  const Bounds& bounds = it.value.bounds;
  const auto shown = [&] { return " = " + text(value); };
  if (!std::isfinite(value)) return {"not_finite", shown() + " is not finite"};
  if (it.constant() && value == 0.0 && !bounds.any()) return {"zero_parameter", " is zero, and must not be"};
  if (it.takes == Takes::whole_number && value != std::round(value))
    return {"not_whole", shown() + " must be a whole number"};
  if (!bounds.hold(value)) return {"out_of_bounds", shown() + " " + wanted(bounds)};
  if (it.value.not_above.empty()) return {};
  const Parameter& most = value_of(info, it.value.not_above, parameters);
  if (most.signal >= 0 || value <= most.constant) return {};
  return {"out_of_bounds", shown() + " must not be above " + it.value.not_above + " = " + text(most.constant)};
}

Fault fault_of_function(const ParameterInfo& it, const TimeFunction& function) {
  if (it.constant()) return {"not_constant", " is a function of time, and must be a number"};
  const bool characteristic = it.takes == Takes::characteristic;
  if (function.of_time() == characteristic)
    return {"function", characteristic ? " takes a characteristic, not a function of time"
                                       : " takes a function of time, not a characteristic"};
  if (it.takes == Takes::differentiable && !function.has_derivatives())
    return {"derivatives", " is a function of time without derivatives; give the first and second derivative too"};
  return {};
}

/// Many at once are taken as they are.
template <class T>
void append(std::vector<T>&& added, std::vector<T>& list) {
  if (list.empty()) list = std::move(added);
  else list.insert(list.end(), added.begin(), added.end());
}

}  // namespace

Model::Model(const Vec3<double>& gravity) : gravity_(gravity) { check_gravity(gravity); }

int Model::add_body(const std::string& name, const Body& body) { return add_bodies(std::vector{name}, {body}); }

int Model::add_bodies(const Names& names, std::vector<Body> bodies) {
  if (!names.are(bodies.size())) throw ModelError("names", "as many names as bodies are needed");
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    check_body(bodies[k], [&] { return names[k]; });
    if (!names.group() && names[k] == "ground")
      throw ModelError("duplicate_name", "body 'ground': the name belongs to the ground; choose another");
  }
  body_names_.own().add(names, static_cast<int>(bodies.size()));
  for (Body& body : bodies) body.orientation.normalize();
  std::vector<Body>& list = bodies_.own();
  const int first = static_cast<int>(list.size());
  append(std::move(bodies), list);
  return first;
}

void Model::check_element(Role role, const KindInfo& info, const Names& names, std::size_t k, const Element& element,
                          const Parameter* parameters) const {
  const auto refuse_element = [&](const char* code, const std::string& why, const std::string& field = "") {
    ErrorDetails details;
    details.joints = {names[k]};
    details.subject = info.name + " '" + details.joints.front() + "'";
    details.field = field;
    throw ModelError(code, details.subject + ": " + why, details);
  };
  const int count = static_cast<int>(bodies_->size());
  for (const int body : {element.i, element.j})
    if (body < ground || body >= count)
      refuse_element("unknown_body", "body index " + std::to_string(body) + " does not exist; there are " +
                                         std::to_string(count) + " bodies and the ground (-1)");
  if (role == Role::joint && element.i == element.j)
    refuse_element("self_joint", "joins body '" + body_name(element.i) + "' to itself");
  const Attachment<double>& at = element.at;
  if (!at.s_i.allFinite() || !at.s_j.allFinite() || !at.C_i.allFinite() || !at.C_j.allFinite())
    refuse_element("not_finite", "its place on the bodies is not finite");
  if (!orthonormal(at.C_i) || !orthonormal(at.C_j))
    refuse_element("frame", "its axes are not orthonormal and right-handed");
  for (std::size_t p = 0; p < info.parameters.size(); ++p) {
    const ParameterInfo& parameter = info.parameters[p];
    const int signal = parameters[p].signal;
    if (signal >= static_cast<int>(signals_.size()))
      refuse_element("unknown_signal",
                     parameter.name + ": function of time " + std::to_string(signal) + " does not exist",
                     parameter.name);
    const auto [code, why] = signal < 0 ? fault_of_number(info, parameter, parameters[p].constant, parameters)
                                        : fault_of_function(parameter, *signals_[signal]);
    if (!why.empty()) refuse_element(code, parameter.name + why, parameter.name);
  }
  if (!info.contradiction) return;
  if (const std::string why = info.contradiction(parameters); !why.empty()) {
    std::string given;
    for (std::size_t p = 0; p < info.parameters.size(); ++p)
      given += (p ? ", " : "") + info.parameters[p].name + " = " + text(parameters[p].constant);
    refuse_element("contradiction", given + ": " + why);
  }
}

/// Notes functions of time that are not to pass a bound.
void Model::limit(const KindInfo& info, const std::string& name, const Parameter* parameters) {
  const auto what = [&](const std::string& parameter) { return info.name + " '" + name + "': " + parameter; };
  for (std::size_t p = 0; p < info.parameters.size(); ++p) {
    const ParameterInfo& parameter = info.parameters[p];
    if (parameter.value.bounds.any() && parameters[p].signal >= 0)
      limited_.own().push_back({parameters[p], {parameter.value.bounds.least, -1}, what(parameter.name), ""});
    if (parameter.value.not_above.empty()) continue;
    const Parameter& most = value_of(info, parameter.value.not_above, parameters);
    if (most.signal >= 0 || parameters[p].signal >= 0)
      limited_.own().push_back({most, parameters[p], what(parameter.value.not_above), parameter.name});
  }
}

int Model::add_elements(Role role, int index, const KindInfo& info, const Names& names, std::vector<Element> elements,
                        const std::vector<Parameter>& parameters) {
  const bool joint = role == Role::joint;
  const std::size_t count = info.parameters.size();
  if (parameters.size() != count * elements.size())
    throw ModelError("parameters", info.name + " '" + names.text() + "': takes " + std::to_string(count) +
                                       " parameters, not " +
                                       std::to_string(parameters.size() / std::max<std::size_t>(1, elements.size())));
  if (!names.are(elements.size())) throw ModelError("names", info.name + ": as many names as elements are needed");
  for (std::size_t k = 0; k < elements.size(); ++k)
    check_element(role, info, names, k, elements[k], parameters.data() + k * count);
  if (static_cast<double>(row_count()) + static_cast<double>(info.rows) * static_cast<double>(elements.size()) >
      std::numeric_limits<int>::max())
    throw ModelError("too_large", "the model would have more constraint rows than 2^31 - 1");

  (joint ? joint_names_ : force_names_).own().add(names, static_cast<int>(elements.size()));
  std::vector<Element>& list = joint ? joints_.own() : forces_.own();
  std::vector<Parameter>& all_parameters = joint ? joint_parameters_.own() : force_parameters_.own();
  std::vector<int>& rows = joint_rows_.own();
  const int first = static_cast<int>(list.size());
  const bool bounded = std::any_of(info.parameters.begin(), info.parameters.end(), [](const ParameterInfo& it) {
    return it.value.bounds.any() || !it.value.not_above.empty();
  });
  for (std::size_t k = 0; k < elements.size(); ++k) {
    elements[k].kind = index;
    elements[k].first_parameter = all_parameters.size() + k * count;
    if (bounded) limit(info, names[k], parameters.data() + k * count);
    if (joint) rows.push_back(rows.back() + info.rows);
  }
  append(std::move(elements), list);
  all_parameters.insert(all_parameters.end(), parameters.begin(), parameters.end());
  return first;
}

int Model::add_joint(const std::string& kind, const std::string& name, int i, int j, const Attachment<double>& at,
                     const std::vector<Parameter>& parameters) {
  const int index = joint_kind_index(kind);
  return add_elements(Role::joint, index, joint_info(index), std::vector{name}, {Element{0, i, j, at, 0}}, parameters);
}

int Model::add_force(const std::string& kind, const std::string& name, int i, int j, const Attachment<double>& at,
                     const std::vector<Parameter>& parameters) {
  const int index = force_kind_index(kind);
  return add_elements(Role::force, index, force_info(index), std::vector{name}, {Element{0, i, j, at, 0}}, parameters);
}

int Model::add_joints(const std::string& kind, const Names& names, std::vector<Element> elements,
                      const std::vector<Parameter>& parameters) {
  const int index = joint_kind_index(kind);
  return add_elements(Role::joint, index, joint_info(index), names, std::move(elements), parameters);
}

int Model::add_forces(const std::string& kind, const Names& names, std::vector<Element> elements,
                      const std::vector<Parameter>& parameters) {
  const int index = force_kind_index(kind);
  return add_elements(Role::force, index, force_info(index), names, std::move(elements), parameters);
}

int Model::add_special_joint(const std::string& kind, const std::string& name, int i, int j,
                             const Attachment<double>& at, SpecialJointPtr joint,
                             const std::vector<Parameter>& parameters) {
  const int index = special_joint_kind_index(kind);
  const int added =
      add_elements(Role::joint, index, joint_info(index), std::vector{name}, {Element{0, i, j, at, 0}}, parameters);
  special_joints_.emplace_back(added, std::move(joint));
  return added;
}

const SpecialJoint* Model::special_joint(int joint) const {
  const auto found = std::lower_bound(special_joints_.begin(), special_joints_.end(), joint,
                                      [](const auto& special, int wanted) { return special.first < wanted; });
  return found != special_joints_.end() && found->first == joint ? found->second.get() : nullptr;
}

int Model::add_signal(TimeFunctionPtr function) {
  signals_.push_back(std::move(function));
  return static_cast<int>(signals_.size()) - 1;
}

void Model::add_user_force(const std::string& name, std::shared_ptr<const UserForce> force) {
  own_force_names_.own().add(name);
  user_forces_.push_back(std::move(force));
  user_force_names_.push_back(name);
}

void Model::add_breaks(const std::vector<double>& times) {
  for (const double t : times)
    if (!std::isfinite(t)) throw ModelError("breaks", "breaks must be finite times [s]");
  breaks_.insert(breaks_.end(), times.begin(), times.end());
}

void Model::add_joint_force(const std::string& name, int joint, const std::string& coordinate, CoordinateLawPtr law) {
  if (joint < 0 || joint >= static_cast<int>(joints_->size()))
    throw ModelError("unknown_joint", "joint force '" + name + "': joint index " + std::to_string(joint) +
                                          " does not exist; there are " + std::to_string(joints_->size()));
  const Element& element = joints()[joint];
  const FreeCoordinate* found = find_coordinate(joint_info(element.kind), coordinate);
  if (!found)
    throw ModelError("coordinate", "joint force '" + name + "': joint '" + joint_name(joint) + "' has no coordinate '" +
                                       coordinate + "'");
  own_force_names_.own().add(name);
  joint_forces_.own().push_back({name, element.i, element.j, element.at, found, std::move(law)});
}

bool Model::autonomous() const {
  const bool in_time = std::any_of(signals_.begin(), signals_.end(), [](const auto& s) { return s->of_time(); });
  return !in_time && user_forces_.empty() && joint_forces_->empty();
}

int Model::joint_of_row(int row) const {
  return static_cast<int>(std::upper_bound(joint_rows_->begin(), joint_rows_->end(), row) - joint_rows_->begin()) - 1;
}

double Model::longest_arm() const {
  double most = 0.0;  // of the squares, summed in this order on every processor
  for (const Element& joint : joints())
    for (const auto& [body, s] : {std::pair{joint.i, joint.at.s_i}, std::pair{joint.j, joint.at.s_j}})
      if (body != ground) most = std::max(most, (s.x() * s.x() + s.y() * s.y()) + s.z() * s.z());
  return std::sqrt(most);
}

std::string Model::describe_row(int row) const {
  const int joint = joint_of_row(row);
  const KindInfo& info = joint_info(joints()[joint].kind);
  const int equation = row - joint_rows()[joint];
  return info.name + " '" + joint_name(joint) + "', " + info.equations[equation].name;
}

VectorXd Model::initial_q() const {
  VectorXd q(position_size * static_cast<int>(bodies_->size()));
  for (std::size_t b = 0; b < bodies_->size(); ++b)
    q.segment<position_size>(position_size * static_cast<Eigen::Index>(b)) << bodies()[b].position,
        bodies()[b].orientation;
  return q;
}

VectorXd Model::initial_v() const {
  VectorXd v(velocity_size * static_cast<int>(bodies_->size()));
  for (std::size_t b = 0; b < bodies_->size(); ++b)
    v.segment<velocity_size>(velocity_size * static_cast<Eigen::Index>(b)) << bodies()[b].velocity, bodies()[b].omega;
  return v;
}

Model Model::with_initial_state(const ConstVector& q, const ConstVector& v, std::vector<double> history) const {
  const auto count = static_cast<Eigen::Index>(bodies_->size());
  if (q.size() != position_size * count || v.size() != velocity_size * count)
    throw ModelError("shape", "a state of " + std::to_string(count) + " bodies has 7 and 6 numbers for each");
  if (!std::all_of(history.begin(), history.end(), [](double x) { return std::isfinite(x); }))
    throw ModelError("history", "history variables must be finite");
  Model out = *this;
  out.initial_history_ = std::move(history);
  std::vector<Body>& list = out.bodies_.own();
  for (Eigen::Index b = 0; b < count; ++b) {
    Body& body = list[b];
    body.position = q.segment<3>(position_size * b);
    body.orientation = q.segment<4>(position_size * b + 3);
    body.velocity = v.segment<3>(velocity_size * b);
    body.omega = v.segment<3>(velocity_size * b + 3);
    check_body(body, [&] { return body_name(static_cast<int>(b)); });
    body.orientation.normalize();
  }
  return out;
}

Model Model::without_forces() const {
  Model out = *this;
  out.forces_ = Shared<std::vector<Element>>{};
  out.force_parameters_ = Shared<std::vector<Parameter>>{};
  out.force_names_ = Shared<NameTable>{"force"};
  out.own_force_names_ = Shared<NameTable>{"force"};
  out.joint_forces_ = Shared<std::vector<JointForce>>{};
  out.limited_ = Shared<std::vector<Limited>>{};
  out.user_forces_.clear();
  out.user_force_names_.clear();
  out.initial_history_.clear();
  return out;
}

bool Model::is_driven(int joint) const {
  const auto first = joint_parameters().begin() + static_cast<std::ptrdiff_t>(joints()[joint].first_parameter);
  const auto last = first + std::ssize(joint_info(joints()[joint].kind).parameters);
  return std::any_of(first, last, [](const Parameter& it) { return it.signal >= 0; });
}

Model Model::without_drivers() const {
  Model out = without_forces();
  out.joints_ = Shared<std::vector<Element>>{};
  out.joint_parameters_ = Shared<std::vector<Parameter>>{};
  out.joint_names_ = Shared<NameTable>{"joint"};
  out.joint_rows_ = Shared<std::vector<int>>{std::size_t{1}, 0};
  out.special_joints_.clear();
  for (int joint = 0; joint < static_cast<int>(joints().size()); ++joint) {
    if (is_driven(joint)) continue;
    const Element& it = joints()[joint];
    const KindInfo& info = joint_info(it.kind);
    const auto first = joint_parameters().begin() + static_cast<std::ptrdiff_t>(it.first_parameter);
    const int added = out.add_elements(Role::joint, it.kind, info, std::vector{joint_name(joint)}, {it},
                                       {first, first + std::ssize(info.parameters)});
    const auto special = std::ranges::find(special_joints_, joint, [](const auto& listed) { return listed.first; });
    if (special != special_joints_.end()) out.special_joints_.emplace_back(added, special->second);
  }
  return out;
}

Model Model::without_inertances() const {
  Model out = *this;
  for (const Element& force : forces())
    if (force_kinds()[force.kind].inertia) out.force_parameters_.own()[force.first_parameter].constant = 0.0;
  return out;
}

Model Model::seen_from(const VectorXd& origins) const {
  Model out = *this;
  std::vector<Body>& list = out.bodies_.own();
  const auto origin = [&](int body) { return Vec3<double>(origins.segment<3>(3 * std::ptrdiff_t{body})); };
  for (std::size_t b = 0; b < list.size(); ++b) list[b].position -= origin(static_cast<int>(b));
  for (Element& joint : out.joints_.own())
    if (joint.i == ground || joint.j == ground)
      joint.at = linkwork::seen_from(origin(std::max(joint.i, joint.j)), joint.at, joint.i, joint.j);
  for (auto& [joint, special] : out.special_joints_)
    special = special->seen_from(origin(*std::ranges::max_element(special->bodies())));
  return out;
}

Model Model::with_weights(const Vec3<double>& gravity, const std::vector<int>& bodies,
                          const std::vector<double>& masses, const std::vector<Mat3<double>>& inertias) const {
  check_gravity(gravity);
  Model out = *this;
  out.gravity_ = gravity;
  if (bodies.empty()) return out;
  std::vector<Body>& list = out.bodies_.own();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    Body& body = list.at(static_cast<std::size_t>(bodies[k]));
    body.mass = masses.at(k);
    body.inertia = inertias.at(k);
    check_body(body, [&] { return body_name(bodies[k]); });
  }
  return out;
}

Model Model::with_masses(const std::vector<Body>& bodies) const {
  Model out = *this;
  std::vector<Body>& list = out.bodies_.own();
  for (std::size_t b = 0; b < list.size(); ++b) {
    list[b].mass = bodies[b].mass;
    list[b].inertia = bodies[b].inertia;
  }
  return out;
}

}  // namespace linkwork
