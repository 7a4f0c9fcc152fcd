#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "dense_algebra.hpp"
#include "linkwork/model/special/coupler.hpp"
#include "linkwork/model/special/point_on_curve.hpp"
#include "support.hpp"

using namespace support;

namespace {

constexpr double tolerance = 1e-6;  // of the differences, relative

/// One joint at random places of two moving bodies, or of one and the ground; its parameters vary in time.
struct Case {
  Case(const std::string& kind, int i, int j, Random& random) : model(Vec3<double>::Zero()) {
    for (int body = 0; body <= std::max(i, j); ++body)
      model.add_body("body" + std::to_string(body), random_body(random));
    const KindInfo& info = joint_kinds()[joint_kind_index(kind)].info;
    std::vector<Parameter> parameters;
    for (const ParameterInfo& it : info.parameters) {
      if (it.constant()) {
        parameters.push_back({it.value.example, -1});
        continue;
      }
      const int polynomial_signal = model.add_signal(polynomial({1.0, 0.5, -0.7, 0.3}));
      const int harmonic_signal = model.add_signal(harmonic(0.3, 2.0, 0.4, 1.5));
      parameters.push_back({0.0, random.integer(0, 1) ? polynomial_signal : harmonic_signal});
    }
    model.add_joint(kind, "joint", i, j, random_attachment(random), parameters);
    v_dot = random.vector(6 * static_cast<Eigen::Index>(model.bodies().size()));
    positions = info.rows - info.velocity_rows();
  }
  Model model;
  VectorXd v_dot;
  int positions = 0;  ///< equations that have a Phi; the others, of velocities, follow
  double t = 0.3;
};

/// A special joint on three moving bodies and the ground; its parameters vary in time.
Case special_case(const std::string& kind, Random& random) {
  Case out("revolute", 0, 1, random);
  Model& model = out.model;
  model.add_body("body2", random_body(random));
  if (kind == "coupler") {
    model.add_joint("universal", "second", ground, 0, random_attachment(random));
    model.add_joint("cylindrical", "third", 1, 2, random_attachment(random));
    const auto coupler =
        std::make_shared<Coupler>(model, std::vector<CoupledCoordinate>{{0, "angle", random.number()},
                                                                        {1, "angle_a", random.number()},
                                                                        {1, "angle_b", random.number()},
                                                                        {2, "angle", random.number()},
                                                                        {2, "displacement", random.number()}});
    const int offset = model.add_signal(harmonic(0.3, 2.0, 0.4, 1.5));
    model.add_special_joint(kind, "special", 0, 1, model.joints()[0].at, coupler, {{0.0, offset}});
  } else {
    const auto piece = [&](const Vec3<double>& along) {  // slightly bent, with one foot for every point near it
      return std::array<Vec3<double>, 4>{random.vec3(), along, 0.02 * random.vec3(), 0.002 * random.vec3()};
    };
    const Mat3<double> F = random.frame();
    Curve curve{{-4.0, 4.0}, {piece(F.col(0))}, {piece(Vec3<double>::Zero())}, false};
    curve.e[0][0] = 2.0 * F.col(1);
    const int i = random.integer(0, 1) ? 2 : ground, j = 1;
    const Attachment<double> at = random_attachment(random);
    model.add_special_joint(kind, "special", i, j, at, std::make_shared<PointOnCurve>(i, j, at, curve));
  }
  out.v_dot = random.vector(6 * static_cast<Eigen::Index>(model.bodies().size()));
  out.positions = model.row_count();
  return out;
}

/// Runs a check for every registered joint, with each of its bodies as the ground, in random places.
template <class Check>
void for_every_joint(Check check) {
  const std::vector<std::pair<int, int>> pairs = {{0, 1}, {1, 0}, {ground, 0}, {0, ground}};
  Random random(10);
  for (const JointKind& kind : joint_kinds())
    for (const auto& [i, j] : pairs)
      for (int repetition = 0; repetition < 3; ++repetition) {
        INFO(kind.info.name, " between ", i, " and ", j);
        check(Case(kind.info.name, i, j, random));
      }
  for (const KindInfo& kind : special_joint_kinds())
    for (int repetition = 0; repetition < 6; ++repetition) {
      INFO(kind.name, " number ", repetition);
      check(special_case(kind.name, random));
    }
}

/// Evaluates near the initial pose, from which the turns of angles are counted.
struct Nearby : System {
  explicit Nearby(const Model& model, double t = 0.0) : System(model), initial(make_evaluation()) {
    history = beginning_history(t, model.initial_q(), model.initial_v());
  }
  Evaluation initial;
  VectorXd history;
};

Evaluation evaluate(const Nearby& system, double t, const VectorXd& q, const VectorXd& v) {
  Evaluation at = system.initial;
  system.evaluate_constraints(t, q, v, system.history, at);
  return at;
}

/// Turns body j of a model by the rotation vector `turn` about point P and shifts it by `shift`; all in space.
VectorXd displaced(const Model& model, int j, const Vec3<double>& P, const Vec3<double>& turn,
                   const Vec3<double>& shift) {
  VectorXd q = model.initial_q();
  const Vec4<double> rotation = exponential(turn);
  const Vec3<double> r = q.segment<3>(7 * j);
  q.segment<3>(7 * j) = P + rotation_matrix<double>(rotation) * (r - P) + shift;
  q.segment<4>(7 * j + 3) = quaternion_product<double>(rotation, q.segment<4>(7 * j + 3));
  return q;
}

}  // namespace

TEST_CASE("every column of D is the derivative of Phi along the unit velocity") {
  for_every_joint([](const Case& c) {
    const Nearby system(c.model, c.t);
    const VectorXd q = c.model.initial_q(), rest = VectorXd::Zero(system.v_size());
    const MatrixXd D = dense_D(system, evaluate(system, c.t, q, rest)).topRows(c.positions);
    MatrixXd differences(D.rows(), D.cols());
    for (Eigen::Index k = 0; k < D.cols(); ++k) {
      const VectorXd unit = VectorXd::Unit(D.cols(), k);
      const auto Phi = [&](double s) {
        return VectorXd(evaluate(system, c.t, moved(q, unit, rest, s), rest).Phi.head(c.positions));
      };
      differences.col(k) = first_difference(Phi, 1e-3);
    }
    CHECK(relative_error(D, differences) < tolerance);
  });
}

TEST_CASE("D and gamma between bodies are the same to the last bit a thousand kilometers away") {
  Random random(42);
  for (const JointKind& kind : joint_kinds()) {
    CAPTURE(kind.info.name);
    const HereAndAway models(Case(kind.info.name, 0, 1, random).model);
    const Evaluation here = evaluate_initially(System(models.here)), away = evaluate_initially(System(models.away));
    CHECK(away.D == here.D);
    CHECK(away.gamma == here.gamma);
  }
}

TEST_CASE("Phi_t is the derivative of Phi in time at a fixed pose") {
  for_every_joint([](const Case& c) {
    const Nearby system(c.model, c.t);
    const VectorXd q = c.model.initial_q(), v = c.model.initial_v();
    const auto Phi = [&](double s) { return evaluate(system, c.t + s, q, v).Phi; };
    CHECK(relative_error(evaluate(system, c.t, q, v).Phi_t, first_difference(Phi, 1e-3)) < tolerance);
  });
}

TEST_CASE("Phi_dot is the derivative of Phi along the motion") {
  for_every_joint([](const Case& c) {
    const Nearby system(c.model, c.t);
    const VectorXd q = c.model.initial_q(), v = c.model.initial_v();
    const auto Phi = [&](double s) { return evaluate(system, c.t + s, moved(q, v, c.v_dot, s), v).Phi; };
    const VectorXd Phi_dot = evaluate(system, c.t, q, v).Phi_dot;
    CHECK(relative_error(Phi_dot.head(c.positions), first_difference(Phi, 2.5e-4).head(c.positions)) < tolerance);
  });
}

TEST_CASE("D v_dot - gamma is the second derivative of Phi along the motion") {
  for_every_joint([](const Case& c) {
    const Nearby system(c.model, c.t);
    const VectorXd q = c.model.initial_q(), v = c.model.initial_v();
    const Evaluation at = evaluate(system, c.t, q, v);
    const VectorXd Phi_ddot = dense_D(system, at) * c.v_dot - at.gamma;
    const auto Phi = [&](double s) { return evaluate(system, c.t + s, moved(q, v, c.v_dot, s), v).Phi; };
    CHECK(relative_error(Phi_ddot.head(c.positions), second_difference(Phi, 4e-4).head(c.positions)) < tolerance);
  });
}

TEST_CASE("D v_dot - gamma is the derivative of Phi_dot along the motion, of equations of velocities, too") {
  for_every_joint([](const Case& c) {
    const Nearby system(c.model, c.t);
    const VectorXd q = c.model.initial_q(), v = c.model.initial_v();
    const Evaluation at = evaluate(system, c.t, q, v);
    const auto Phi_dot = [&](double s) {  // velocities differ from the motion's by O(s^2), which is even and cancels
      return evaluate(system, c.t + s, moved(q, v, c.v_dot, s), v + s * c.v_dot).Phi_dot;
    };
    CHECK(relative_error(dense_D(system, at) * c.v_dot - at.gamma, first_difference(Phi_dot, 2.5e-4)) < tolerance);
    CHECK(at.Phi.tail(at.Phi.size() - c.positions).isZero(0.0));
  });
}

TEST_CASE("every joint names each of its equations once") {
  for (const JointKind& kind : joint_kinds()) {
    CAPTURE(kind.info.name);
    CHECK(kind.info.rows > 0);
    CHECK(std::ssize(kind.info.equations) == kind.info.rows);
    CHECK_FALSE(kind.info.documentation.empty());
    for (std::size_t a = 0; a < kind.info.equations.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) CHECK(kind.info.equations[a].name != kind.info.equations[b].name);
  }
}

TEST_CASE("every joint that the initial pose satisfies has Phi = 0 and full row rank there") {
  Random random(11);
  for (const JointKind& kind : joint_kinds())
    for (const auto& [i, j] : std::vector<std::pair<int, int>>{{0, 1}, {ground, 1}, {0, ground}}) {
      INFO(kind.info.name, " between ", i, " and ", j);
      Model model;
      for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
      add_joint(model, random, kind.info.name, "joint", i, j);
      const System system(model);
      const Evaluation at = evaluate_initially(system);
      CHECK(at.Phi.cwiseAbs().maxCoeff() < 1e-14);
      CHECK(dense_rank(dense_D(system, at), 1e-10) == kind.info.rows);
    }
}

namespace {

/// Largest |Phi| of a joint after body b was turned about the joint's point and shifted, in joint axes.
double violation(const std::string& kind, const Vec3<double>& turn, const Vec3<double>& shift) {
  Random random(12);
  Model model;
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  const Vec3<double> P = random.vec3();
  const Mat3<double> F = random.frame();
  model.add_joint(kind, "joint", 0, 1, place(model, 0, 1, P, P, F, F));
  const Nearby system(model);
  const VectorXd q = displaced(model, 1, P, F * turn, F * shift);
  return evaluate(system, 0.0, q, model.initial_v()).Phi.cwiseAbs().maxCoeff();
}

const Vec3<double> x = Vec3<double>::UnitX(), y = Vec3<double>::UnitY(), z = Vec3<double>::UnitZ(),
                   none = Vec3<double>::Zero();

}  // namespace

TEST_CASE("spherical: every rotation is free, no shift is") {
  CHECK(violation("spherical", Vec3<double>(1.0, -2.0, 0.5), none) < 1e-14);
  for (const auto& d : {x, y, z}) CHECK(violation("spherical", none, 0.1 * d) > 0.05);
}

TEST_CASE("revolute: rotation about z is free and nothing else") {
  CHECK(violation("revolute", 2.5 * z, none) < 1e-14);
  for (const auto& d : {x, y, z}) CHECK(violation("revolute", none, 0.1 * d) > 0.05);
  for (const auto& d : {x, y}) CHECK(violation("revolute", 0.1 * d, none) > 0.05);
}

TEST_CASE("cylindrical: rotation about z and shift along z are free and nothing else") {
  CHECK(violation("cylindrical", 2.5 * z, 3.0 * z) < 1e-14);
  for (const auto& d : {x, y}) CHECK(violation("cylindrical", none, 0.1 * d) > 0.05);
  for (const auto& d : {x, y}) CHECK(violation("cylindrical", 0.1 * d, none) > 0.05);
}

TEST_CASE("translational: shift along z is free and nothing else") {
  CHECK(violation("translational", none, -3.0 * z) < 1e-14);
  for (const auto& d : {x, y}) CHECK(violation("translational", none, 0.1 * d) > 0.05);
  for (const auto& d : {x, y, z}) CHECK(violation("translational", 0.1 * d, none) > 0.05);
}

TEST_CASE("fixed: nothing is free") {
  for (const auto& d : {x, y, z}) CHECK(violation("fixed", none, 0.1 * d) > 0.05);
  for (const auto& d : {x, y, z}) CHECK(violation("fixed", 0.1 * d, none) > 0.05);
}

TEST_CASE("universal: rotation about the axis of a after rotation about the axis of b is free, and nothing else") {
  Random random(13);
  Model model;
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  const Vec3<double> P = random.vec3();
  const Mat3<double> F = random.frame();
  Mat3<double> F_b;
  F_b << F.col(1), F.col(2), F.col(0);  // axis of a: z of F, of b: x of F
  model.add_joint("universal", "joint", 0, 1, place(model, 0, 1, P, P, F, F_b));
  const Nearby system(model);
  const auto largest_Phi = [&](const Vec4<double>& turn, const Vec3<double>& shift) {
    const VectorXd q = displaced(model, 1, P, logarithm(turn), shift);
    return evaluate(system, 0.0, q, model.initial_v()).Phi.cwiseAbs().maxCoeff();
  };
  const Vec4<double> free = quaternion_product<double>(exponential(1.3 * F.col(2)), exponential(-0.8 * F.col(0)));
  CHECK(largest_Phi(free, none) < 1e-14);
  CHECK(largest_Phi(exponential(0.1 * F.col(1)), none) > 0.05);
  for (int k = 0; k < 3; ++k) CHECK(largest_Phi(exponential(none), 0.1 * F.col(k)) > 0.05);
}

TEST_CASE("distance: Phi is the distance of the points less the length") {
  Random random(14);
  Model model;
  const Vec3<double> a = random.vec3(), b = random.vec3();
  Body body;
  body.position = random.vec3();
  model.add_body("ball", body);
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_joint("distance", "rod", ground, 0, place(model, ground, 0, a, b, I, I), {{0.25, -1}});
  const System system(model);
  CHECK(evaluate_initially(system).Phi[0] == doctest::Approx((a - b).norm() - 0.25).epsilon(1e-14));
}
