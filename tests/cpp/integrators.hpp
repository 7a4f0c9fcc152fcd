#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "linkwork/integration/embedded_pair.hpp"
#include "linkwork/integration/simulation.hpp"
#include "mechanisms.hpp"

/// Some methods, mechanisms to run them on, and the order that three runs show.
namespace support {

inline ButcherTableau tableau(const std::string& name, int order, const std::vector<std::vector<double>>& A,
                              const std::vector<double>& b, const std::vector<double>& c) {
  const auto s = static_cast<Eigen::Index>(b.size());
  ButcherTableau out{name, order, MatrixXd::Zero(s, s), Eigen::Map<const VectorXd>(b.data(), s),
                     Eigen::Map<const VectorXd>(c.data(), s)};
  for (std::size_t row = 0; row < A.size(); ++row)
    for (std::size_t column = 0; column < A[row].size(); ++column)
      out.A(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) = A[row][column];
  return out;
}

inline ButcherTableau euler() { return tableau("euler", 1, {}, {1}, {0}); }
inline ButcherTableau heun() { return tableau("heun", 2, {{}, {1}}, {0.5, 0.5}, {0, 1}); }
inline ButcherTableau rk4() {
  return tableau("rk4", 4, {{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1 / 6., 1 / 3., 1 / 3., 1 / 6.}, {0, 0.5, 0.5, 1});
}

inline MultistepCoefficients multistep(const std::string& name, int order, std::vector<double> predictor,
                                       std::vector<double> corrector) {
  const auto vector = [](const std::vector<double>& x) {
    return VectorXd(Eigen::Map<const VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
  };
  return {name, order, vector(predictor), vector(corrector), rk4()};
}

inline MultistepCoefficients ab2() { return multistep("ab2", 2, {1.5, -0.5}, {}); }
inline MultistepCoefficients ab4() { return multistep("ab4", 4, {55 / 24., -59 / 24., 37 / 24., -9 / 24.}, {}); }
inline MultistepCoefficients abm4() {
  return multistep("abm4", 4, {55 / 24., -59 / 24., 37 / 24., -9 / 24.}, {9 / 24., 19 / 24., -5 / 24., 1 / 24.});
}

struct Method {
  std::string name;
  int order;
  std::unique_ptr<Integrator> (*make)();
};

inline const std::vector<Method> one_step_methods = {
    {"euler", 1, [] { return make_runge_kutta(euler()); }},
    {"heun", 2, [] { return make_runge_kutta(heun()); }},
    {"rk4", 4, [] { return make_runge_kutta(rk4()); }},
    {"semi-implicit euler", 1, [] { return make_semi_implicit_euler(); }},
};

inline std::vector<Method> all_methods() {
  std::vector<Method> all = one_step_methods;
  all.push_back({"ab2", 2, [] { return make_multistep(ab2()); }});
  all.push_back({"ab4", 4, [] { return make_multistep(ab4()); }});
  all.push_back({"abm4", 4, [] { return make_multistep(abm4()); }});
  return all;
}

/// With principal axes along its own.
inline Body rigid_body(double mass, const Vec3<double>& moments) {
  Body body;
  body.mass = mass;
  body.inertia = moments.asDiagonal();
  return body;
}

/// An asymmetric body that nothing holds and no torque acts on.
inline Model free_body() {
  Model model(Vec3<double>::Zero());
  Body body = rigid_body(2.0, {1.0, 2.0, 2.5});
  body.velocity = {0.3, -0.2, 0.1};
  body.omega = {1.0, 2.0, -0.5};
  model.add_body("brick", body);
  return model;
}

/// A rod on a hinge, let go from the horizontal.
inline Model pendulum() {
  Model model;
  Body body = rigid_body(2.0, {0.10, 0.20, 0.20});
  body.position = {0.5, 0.0, 0.0};
  model.add_body("rod", body);
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j = {-0.5, 0.0, 0.0};
  at.C_i = at.C_j = (Mat3<double>() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();  // z along -y
  model.add_joint("revolute", "hinge", ground, 0, at);
  return model;
}

/// An asymmetric body on a ball joint at the origin, moving consistently.
inline Model spherical_pendulum() {
  Model model;
  Body body = rigid_body(2.0, {0.10, 0.20, 0.25});
  body.position = {0.8, 0.0, -0.3};
  body.omega = {0.5, -0.4, 1.5};
  body.velocity = body.omega.cross(body.position);
  model.add_body("bob", body);
  join(model, "spherical", "hook", ground, 0, {0, 0, 0});
  return model;
}

inline Options unstabilized() {
  Options options;
  options.stabilization = "none";
  return options;
}

inline Frames run(const Model& model, std::unique_ptr<Integrator> integrator, const Schedule& schedule,
                  const Options& options = {}) {
  Dynamics dynamics(model, options);
  Simulation simulation(dynamics, std::move(integrator), schedule);
  return simulation.advance(1 << 30, 1e9);
}

inline VectorXd last(const std::vector<double>& frames, Eigen::Index size) {
  return Eigen::Map<const VectorXd>(frames.data() + frames.size() - size, size);
}

/// (q, v, work) of a one-body model at the end.
inline VectorXd final_state(const Model& model, const Method& method, double t_end, int steps,
                            const Options& options = {}) {
  const Frames frames = run(model, method.make(), {t_end, t_end / steps, steps}, options);
  VectorXd y(14);
  y << last(frames.q, 7), last(frames.v, 6), frames.work.back();
  return y;
}

/// From three runs, without a reference: log2 |y_h - y_h/2| / |y_h/2 - y_h/4|.
inline double observed_order(const Model& model, const Method& method, double t_end, int steps,
                             const Options& options = {}) {
  const VectorXd coarse = final_state(model, method, t_end, steps, options);
  const VectorXd middle = final_state(model, method, t_end, 2 * steps, options);
  const VectorXd fine = final_state(model, method, t_end, 4 * steps, options);
  return std::log2((coarse - middle).norm() / (middle - fine).norm());
}

/// A body that slides along the ground's z axis, begun off the axis and moving off it: linear constraints.
inline Model displaced_slider() {
  Model model;
  Body body;
  body.position = {1e-2, -2e-2, 0.3};
  body.velocity = {0.5, 0.2, -1.0};
  model.add_body("slider", body);
  const Mat3<double> I = Mat3<double>::Identity();
  const Vec3<double> none = Vec3<double>::Zero();
  model.add_joint("translational", "rail", ground, 0, {none, none, I, I});
  return model;
}

/// The cubic that has the values and slopes of both ends of a step of Bogacki and Shampine (1989).
inline EmbeddedPair bs32() {
  EmbeddedPair pair;
  pair.method = {"bs32", 3, MatrixXd::Zero(3, 3), VectorXd(3), VectorXd(3)};
  pair.method.A(1, 0) = 0.5;
  pair.method.A(2, 1) = 0.75;
  pair.method.b << 2 / 9., 1 / 3., 4 / 9.;
  pair.method.c << 0, 0.5, 0.75;
  pair.error_order = 2;
  pair.error.resize(4);
  pair.error << -5 / 72., 1 / 12., 1 / 9., -1 / 8.;
  pair.extra_A.resize(0, 4);
  pair.interpolant.resize(4, 3);
  pair.interpolant << 1, -4 / 3., 5 / 9., 0, 1, -2 / 3., 0, 4 / 3., -8 / 9., 0, -1, 1;
  return pair;
}

/// Heun's method as a half-explicit one: each stage meets the constraints where the next begins.
inline HalfExplicitTableau half_explicit_heun() {
  HalfExplicitTableau tableau{"heun", 2, MatrixXd::Zero(2, 2), MatrixXd::Zero(2, 2)};
  tableau.A(1, 0) = 1.0;
  tableau.A_bar << 1.0, 0.0, 0.5, 0.5;
  return tableau;
}

}  // namespace support
