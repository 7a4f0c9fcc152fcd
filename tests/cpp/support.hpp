#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/formulation/options.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/rotation.hpp"
#include "linkwork/model/model.hpp"

/// A failing comparison of vectors shows their entries.
template <class T>
struct doctest::StringMaker<std::vector<T>> {
  static String convert(const std::vector<T>& values) {
    std::ostringstream out;
    for (const T& value : values) out << (&value == values.data() ? "" : ", ") << value;
    return ("{" + out.str() + "}").c_str();
  }
};

/// What several tests need: random mechanisms, and the matrices of a System written out densely.
namespace support {

using namespace linkwork;

/// Sanitizers make programs ten times as slow, or more: what they look for is found by fewer of the same.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// The same numbers on every machine and with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double number(double low = -1.0, double high = 1.0) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  VectorXd vector(Eigen::Index size, double scale = 1.0) {
    return VectorXd::NullaryExpr(size, [&](Eigen::Index) { return scale * number(); });
  }
  MatrixXd matrix(Eigen::Index rows, Eigen::Index columns) {
    return MatrixXd::NullaryExpr(rows, columns, [&](Eigen::Index, Eigen::Index) { return number(); });
  }
  Vec3<double> vec3(double scale = 1.0) { return vector(3, scale); }
  Vec4<double> unit_quaternion() { return exponential(vec3(1.8)); }
  Mat3<double> frame() { return rotation_matrix<double>(unit_quaternion()); }

 private:
  std::mt19937_64 engine_;
};

/// A random pose and velocity; an inertia that a body can have.
inline Body random_body(Random& random) {
  const Vec3<double> extent = (random.vec3(0.2).array() + 0.4).matrix();
  const Vec3<double> squares = extent.cwiseProduct(extent);
  const Mat3<double> axes = random.frame();
  Body body;
  body.mass = random.number(0.5, 3.0);
  body.inertia = body.mass * axes * (Vec3<double>::Constant(squares.sum()) - squares).asDiagonal() * axes.transpose();
  body.inertia = (0.5 * (body.inertia + body.inertia.transpose())).eval();
  body.position = random.vec3();
  body.orientation = random.unit_quaternion();
  body.velocity = random.vec3();
  body.omega = random.vec3();
  return body;
}

/// The axes of body j seen in body i may be anything.
inline Attachment<double> random_attachment(Random& random) {
  return {random.vec3(), random.vec3(), random.frame(), random.frame()};
}

/// The place of a joint, in body coordinates, that holds at the initial pose of the bodies: points P_i and P_j and the
/// axes F_i and F_j in space.
inline Attachment<double> place(const Model& model, int i, int j, const Vec3<double>& P_i, const Vec3<double>& P_j,
                                const Mat3<double>& F_i, const Mat3<double>& F_j) {
  const auto pose = [&](int body) { return body == ground ? Body{} : model.bodies()[body]; };
  const Mat3<double> A_i = rotation_matrix<double>(pose(i).orientation);
  const Mat3<double> A_j = rotation_matrix<double>(pose(j).orientation);
  return {A_i.transpose() * (P_i - pose(i).position), A_j.transpose() * (P_j - pose(j).position), A_i.transpose() * F_i,
          A_j.transpose() * F_j};
}

/// Adds a joint of any kind that the initial pose satisfies.
inline int add_joint(Model& model, Random& random, const std::string& kind, const std::string& name, int i, int j) {
  const KindInfo& info = joint_kinds()[joint_kind_index(kind)].info;
  const auto named = [&](const std::string& name) { return info.placement == name; };
  Mat3<double> F_i = random.frame();
  Vec3<double> P_i = random.vec3(), apart = Vec3<double>::Zero();
  if (named("two_points")) apart = random.vec3();
  if (named("centers")) apart = random.number(0.3, 1.0) * F_i.col(0);
  const Vec3<double> P_j = P_i + apart;
  Mat3<double> F_j = F_i;
  if (named("two_axes") || named("two_directions")) F_j << F_i.col(0), -F_i.col(2), F_i.col(1);  // z_j normal to z_i
  if (named("centers")) F_j << -F_i.col(0), -F_i.col(1), F_i.col(2);  // each x toward the other center
  const auto turned = [&](double a) {
    return Mat3<double>(rotation_matrix<double>(exponential(a * F_i.col(0))) * F_i);
  };
  if (named("shafts")) F_j = turned(0.7);
  if (named("disc")) {
    F_j = turned(0.9);
    const Vec3<double> down = F_i.col(2).dot(F_j.col(2)) * F_j.col(2) - F_i.col(2);
    P_i += info.parameters.front().value.example * down.normalized();
  }
  std::vector<Parameter> parameters;
  for (const ParameterInfo& it : info.parameters)
    parameters.push_back({it.value.initial_distance ? apart.norm() : it.value.example, -1});
  return model.add_joint(kind, name, i, j, place(model, i, j, P_i, P_j, F_i, F_j), parameters);
}

/// Parameters of a force element of any kind, which vary in time where they can.
inline std::vector<Parameter> force_parameters(Model& model, Random& random, const KindInfo& info) {
  std::vector<Parameter> out;
  for (const ParameterInfo& it : info.parameters) {
    const std::string& name = it.name;
    const TimeFunctionPtr function = harmonic(random.number(), random.number(1, 3), random.number(), 1.0);
    if (it.constant()) out.push_back({name.starts_with("radius") ? 1.5 : random.number(1.2, 2.0), -1});
    else if (name == "lower" || name == "upper")
      out.push_back({0.0, model.add_signal(harmonic(0.1, 2.0, 0.0, name == "lower" ? -0.2 : 0.2))});
    else
      out.push_back(
          {0.0, model.add_signal(it.takes == Takes::characteristic ? characteristic(function, it.name) : function)});
  }
  return out;
}

/// A tree of `bodies` random bodies, each held by a joint of a random kind to the ground or an earlier body.
inline Model random_tree(Random& random, int bodies) {
  Model model(random.vec3(9.81));
  for (int body = 0; body < bodies; ++body) {
    const std::string kind = joint_kinds()[random.integer(0, static_cast<int>(joint_kinds().size()) - 1)].info.name;
    model.add_body("body" + std::to_string(body), random_body(random));
    add_joint(model, random, kind, "joint" + std::to_string(body), random.integer(ground, body - 1), body);
  }
  return model;
}

/// A chain from the ground of random bodies with joints of one kind.
inline Model random_chain(Random& random, int bodies, const std::string& kind) {
  Model model;
  for (int body = 0; body < bodies; ++body) {
    model.add_body("link" + std::to_string(body), random_body(random));
    add_joint(model, random, kind, kind + std::to_string(body), body - 1, body);
  }
  return model;
}

inline Evaluation evaluate_initially(const System& system) {
  Evaluation at = system.make_evaluation();
  system.evaluate(0.0, system.model().initial_q(), system.model().initial_v(), system.initial_history(), at);
  return at;
}

/// Two copies of a model whose elements are between bodies: with positions rounded to 2^-20 m, and with the same about
/// 2^20 m away. Not a digit is lost, so that what bodies do to each other is the same to the last bit.
struct HereAndAway {
  explicit HereAndAway(const Model& model) : here(model), away(model) {
    VectorXd q = model.initial_q(), q_away = q;
    for (Eigen::Index body = 0; position_size * body < q.size(); ++body) {
      for (double& x : q.segment<3>(position_size * body)) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
      q_away.segment<3>(position_size * body) =
          q.segment<3>(position_size * body) + Vec3<double>(0x1p20, -0x1p19, 0x1p20);
    }
    here = model.with_initial_state(q, model.initial_v());
    away = model.with_initial_state(q_away, model.initial_v());
  }
  Model here, away;
};

/// D, rows x 6n, from its blocks.
inline MatrixXd dense_D(const System& system, const Evaluation& at) {
  MatrixXd D = MatrixXd::Zero(system.row_count(), system.v_size());
  for (const ConstraintBlock& block : system.blocks())
    for (int row = 0; row < block.rows; ++row)
      for (int column = 0; column < 6; ++column)
        D(block.row + row, 6 * block.body + column) = at.D[block.offset + 6 * row + column];
  return D;
}

/// M, 6n x 6n, from the model.
inline MatrixXd dense_M(const Model& model) {
  const auto n = static_cast<Eigen::Index>(model.bodies().size());
  MatrixXd M = MatrixXd::Zero(6 * n, 6 * n);
  for (Eigen::Index body = 0; body < n; ++body) {
    const Body& b = model.bodies()[body];
    M.block<3, 3>(6 * body, 6 * body).diagonal().setConstant(b.mass);
    M.block<3, 3>(6 * body + 3, 6 * body + 3) = b.inertia;
  }
  return M;
}

/// Largest difference relative to the largest entry of the reference.
template <class A, class B>
double relative_error(const A& value, const B& reference) {
  if (value.rows() != reference.rows() || value.cols() != reference.cols()) return INFINITY;
  if (reference.size() == 0) return 0.0;
  const double scale = reference.cwiseAbs().maxCoeff();
  const double error = (value - reference).cwiseAbs().maxCoeff() / (scale > 0.0 ? scale : 1.0);
  return std::isfinite(error) ? error : INFINITY;
}

/// Bodies that move smoothly through their initial pose, with v and v_dot at s = 0 as given:
/// r = r_0 + r_dot s + r_ddot s^2/2, p = p_0 exp(omega s + omega_dot s^2/2).
inline VectorXd moved(const VectorXd& q, const VectorXd& v, const VectorXd& v_dot, double s) {
  VectorXd out(q.size());
  for (Eigen::Index body = 0; 7 * body < q.size(); ++body) {
    const Eigen::Matrix<double, 6, 1> step = s * v.segment<6>(6 * body) + 0.5 * s * s * v_dot.segment<6>(6 * body);
    out.segment<3>(7 * body) = q.segment<3>(7 * body) + step.head<3>();
    out.segment<4>(7 * body + 3) = quaternion_product<double>(q.segment<4>(7 * body + 3), exponential(step.tail<3>()));
  }
  return out;
}

/// f'(0), error O(h^4).
template <class F>
auto first_difference(F f, double h) {
  return ((8.0 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12.0 * h)).eval();
}

/// f''(0), error O(h^4).
template <class F>
auto second_difference(F f, double h) {
  return ((16.0 * (f(h) + f(-h)) - (f(2 * h) + f(-2 * h)) - 30.0 * f(0.0)) / (12.0 * h * h)).eval();
}

inline Options options_of(const std::string& formulation, const std::string& form = "auto",
                          const std::string& solver = "auto") {
  Options options;
  options.formulation = formulation;
  options.matrix_form = form;
  options.linear_solver = solver;
  return options;
}

/// Code of the OptionError that a call throws, or "none".
template <class Call>
std::string error_code(Call call) {
  try {
    call();
  } catch (const OptionError& error) {
    return error.code();
  }
  return "none";
}

}  // namespace support
