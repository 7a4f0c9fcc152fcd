#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>

#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

constexpr double pi = std::numbers::pi;

/// One force element at random places of moving bodies; all its parameters vary in time. Gravity acts too.
Model random_force(const std::string& kind, int i, int j, Random& random) {
  Model model(random.vec3(9.81));
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  const KindInfo& info = force_kinds()[force_kind_index(kind)].info;
  const std::vector<Parameter> parameters = force_parameters(model, random, info);
  model.add_force(kind, "force", i, j, random_attachment(random), parameters);
  return model;
}

template <class Check>
void for_every_force(Check check) {
  Random random(20);
  for (const ForceKind& kind : force_kinds())
    for (const auto& [i, j] : std::vector<std::pair<int, int>>{{0, 1}, {1, 0}, {ground, 0}, {0, ground}, {1, 1}})
      for (int repetition = 0; repetition < 3; ++repetition) {
        if (i == j && kind.info.placement != "frame" && kind.info.placement != "two_points")
          continue;  // a body against itself
        INFO(kind.info.name, " between ", i, " and ", j);
        check(random_force(kind.info.name, i, j, random));
      }
}

/// A body on the ground's z axis, turned by `angle` and spinning at `rate`, with a rotational spring about z.
struct TorsionSpring {
  static constexpr double k = 3.0, c = 0.5, theta_0 = 0.2, n = 0.7;
  TorsionSpring() : model(Vec3<double>::Zero()) {
    model.add_body("wheel", Body{});
    const Mat3<double> I = Mat3<double>::Identity();
    model.add_force("rotational_spring_damper", "spring", ground, 0, {none, none, I, I},
                    {{k, -1}, {c, -1}, {theta_0, -1}, {n, -1}});
  }
  const Vec3<double> none = Vec3<double>::Zero();
  Model model;
};

/// Evaluates a one-body model with the body turned about z by `angle` and spinning about z at `rate`, as the end of a
/// step from the state of the last evaluation.
void turn(const System& system, double angle, double rate, Evaluation& at) {
  VectorXd q = system.model().initial_q(), v = VectorXd::Zero(6);
  q.tail<4>() << std::cos(angle / 2), 0, 0, std::sin(angle / 2);
  v[5] = rate;
  system.evaluate(0.0, q, v, VectorXd(at.history), at);
}

}  // namespace

TEST_CASE("power balance of every force: g . v = -dV/dt + power") {
  for_every_force([](const Model& model) {
    const System system(model);
    Evaluation at = system.make_evaluation();
    const VectorXd q = model.initial_q(), v = model.initial_v(), still = VectorXd::Zero(v.size());
    const VectorXd history = system.beginning_history(0.3, q, v);
    const auto potential = [&](double s) {
      system.evaluate(0.3 + s, moved(q, v, still, s), v, history, at);
      return Eigen::Matrix<double, 1, 1>(at.potential);
    };
    const double V_dot = first_difference(potential, 1e-3)[0];
    system.evaluate(0.3, q, v, history, at);
    double power = at.g.head(v.size()).dot(v);  // but for what inerters take for their own energy
    for (std::size_t k = 0; k < system.inerters().count(); ++k)
      power -= system.inerters().inertance(k) * at.coordinate_gamma[static_cast<Eigen::Index>(k)] *
               system.inerters().rate(k, at.D.data(), v.data());
    const double scale = at.g.head(v.size()).norm() * v.norm();
    INFO("g . v = ", power, ", -dV/dt = ", -V_dot, ", power = ", at.power);
    CHECK(std::abs(power + V_dot - at.power) < 1e-9 * scale);
  });
}

TEST_CASE("force elements act with equal and opposite forces and moments on their bodies") {
  Random random(22);
  for (const ForceKind& any : force_kinds()) {
    const std::string& kind = any.info.name;
    if (kind == "applied" || kind == "drag") continue;  // on one body only
    CAPTURE(kind);
    const Model model = random_force(kind, 0, 1, random);
    const System system(model);
    const Evaluation at = evaluate_initially(system);
    Vec3<double> force = Vec3<double>::Zero(), moment = Vec3<double>::Zero();
    for (int b = 0; b < 2; ++b) {
      const Body& body = model.bodies()[b];
      const Vec3<double> F = at.g.segment<3>(6 * b) - body.mass * model.gravity();
      const Vec3<double> n = at.g.segment<3>(6 * b + 3) + body.omega.cross(body.inertia * body.omega);
      force += F;
      moment += body.position.cross(F) + rotation_matrix<double>(body.orientation) * n;
    }
    CHECK(force.norm() < 1e-14);
    CHECK(moment.norm() < 1e-13);
  }
}

TEST_CASE("forces between bodies are the same to the last bit a thousand kilometers away") {
  Random random(23);
  for (const ForceKind& kind : force_kinds()) {
    CAPTURE(kind.info.name);
    const HereAndAway models(random_force(kind.info.name, 0, 1, random));
    const Evaluation here = evaluate_initially(System(models.here)), away = evaluate_initially(System(models.away));
    CHECK(away.g == here.g);
    CHECK(away.power == here.power);
  }
}

TEST_CASE("a spring-damper pulls with k (l - l_0) + c l_dot + f") {
  Model model(Vec3<double>::Zero());
  Body body;
  body.position = {3.0, 0.0, 0.0};
  body.velocity = {0.5, 7.0, 0.0};
  model.add_body("ball", body);
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("spring_damper", "spring", ground, 0, {Vec3<double>::Zero(), Vec3<double>::Zero(), I, I},
                  {{10.0, -1}, {4.0, -1}, {1.0, -1}, {0.25, -1}});
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  CHECK(at.g[0] == doctest::Approx(-(10.0 * 2.0 + 4.0 * 0.5 + 0.25)).epsilon(1e-15));
  CHECK(at.g.segment<5>(1).norm() == 0.0);
  CHECK(at.potential == doctest::Approx(0.5 * 10.0 * 4.0).epsilon(1e-15));
}

TEST_CASE("a spring whose points coincide exerts nothing and stores 1/2 k l_0^2") {
  Model model(Vec3<double>::Zero());
  model.add_body("ball", Body{});
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("spring_damper", "spring", ground, 0, {Vec3<double>::Zero(), Vec3<double>::Zero(), I, I},
                  {{10.0, -1}, {4.0, -1}, {2.0, -1}, {0.0, -1}});
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  CHECK(at.g.head<6>().norm() == 0.0);
  CHECK(at.potential == doctest::Approx(20.0).epsilon(1e-15));
}

TEST_CASE("an applied force in inertial components acts at its point") {
  Random random(23);
  Model model(Vec3<double>::Zero());
  Body body = random_body(random);
  body.omega.setZero();
  model.add_body("a", body);
  const Vec3<double> F = random.vec3(), N = random.vec3(), s = random.vec3();
  const Mat3<double> I = Mat3<double>::Identity(), A = rotation_matrix<double>(body.orientation);
  model.add_force("applied", "push", ground, 0, {Vec3<double>::Zero(), s, I, I},
                  {{F[0], -1}, {F[1], -1}, {F[2], -1}, {N[0], -1}, {N[1], -1}, {N[2], -1}});
  const System system(model);
  const Evaluation at = evaluate_initially(system);
  CHECK((at.g.head<3>() - F).norm() < 1e-15);
  CHECK((A * at.g.segment<3>(3) - ((A * s).cross(F) + N)).norm() < 1e-14);
}

TEST_CASE("an applied force in body components turns with the body") {
  Random random(24);
  Model model(Vec3<double>::Zero());
  const Body body = random_body(random);
  model.add_body("a", body);
  const Vec3<double> F = random.vec3();
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("applied", "jet", 0, 0, {Vec3<double>::Zero(), Vec3<double>::Zero(), I, I},
                  {{F[0], -1}, {F[1], -1}, {F[2], -1}, {0, -1}, {0, -1}, {0, -1}});
  const System system(model);
  CHECK((evaluate_initially(system).g.head<3>() - rotation_matrix<double>(body.orientation) * F).norm() < 1e-14);
}

TEST_CASE("a rotational spring-damper exerts -k (theta - theta_0) - c theta_dot + n about its axis") {
  const TorsionSpring spring;
  const System system(spring.model);
  Evaluation at = system.make_evaluation();
  turn(system, 1.1, 2.0, at);
  const double torque = -spring.k * (1.1 - spring.theta_0) - spring.c * 2.0 + spring.n;
  CHECK(at.g[5] == doctest::Approx(torque).epsilon(1e-14));
  CHECK(at.g.head<5>().norm() < 1e-15);
}

TEST_CASE("a rotational spring turned over several revolutions keeps its angle, in both senses") {
  const TorsionSpring spring;
  const System system(spring.model);
  for (const double sense : {1.0, -1.0}) {
    Evaluation at = system.make_evaluation();
    for (int k = 0; k <= 50; ++k) {
      const double theta = sense * 0.5 * k;
      turn(system, theta, 0.0, at);
      CHECK(at.potential == doctest::Approx(0.5 * spring.k * std::pow(theta - spring.theta_0, 2)).epsilon(1e-12));
    }
    CHECK(std::abs(at.history[0]) > 3 * 2 * pi);
  }
}
