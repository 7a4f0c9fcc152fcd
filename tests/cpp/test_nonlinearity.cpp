#include "linkwork/integration/nonlinearity.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double k = 40.0;  // N/m
constexpr int states = 16;

Body body_at(const Vec3<double>& position) {
  Body body;
  body.mass = 2.0;
  body.inertia = 0.1 * Mat3<double>::Identity();
  body.position = position;
  return body;
}

Attachment<double> between(const Vec3<double>& on_i, const Vec3<double>& on_j) {
  Attachment<double> at;
  at.s_i = on_i;
  at.s_j = on_j;
  at.C_i = at.C_j = Mat3<double>::Identity();
  return at;
}

std::vector<Parameter> spring(double free_length) { return {{k, -1}, {0.0, -1}, {free_length, -1}, {0.0, -1}}; }

/// A body that springs of this free length hold along x: at (0, +-1, 0), where they are transverse, or at (+-1, 0, 0).
Model held(double free_length, bool transverse) {
  Model model(Vec3<double>::Zero());
  model.add_body("body", body_at(Vec3<double>::Zero()));
  const Vec3<double> way = transverse ? Vec3<double>::UnitY() : Vec3<double>::UnitX();
  for (const double side : {-1.0, 1.0})
    model.add_force("spring_damper", "spring " + std::to_string(side), ground, 0,
                    between(side * way, Vec3<double>::Zero()), spring(free_length));
  return model;
}

/// Two that a spring across the way of the first holds together.
Model pair() {
  Model model(Vec3<double>::Zero());
  model.add_body("body", body_at(Vec3<double>::Zero()));
  model.add_body("other", body_at(Vec3<double>::UnitY()));
  model.add_force("spring_damper", "spring", 0, 1, between(Vec3<double>::Zero(), Vec3<double>::Zero()), spring(0.7));
  return model;
}

/// As they come in a vibration of this amplitude, of a whole that goes along z.
std::vector<KeptStep> vibration(const Dynamics& dynamics, double amplitude, double along = 0.0, int count = states) {
  std::vector<KeptStep> out(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) {
    KeptStep& step = out[static_cast<std::size_t>(n)];
    const double phase = 2.0 * M_PI * n / count;
    step.t = 0.1 * n;
    step.h = 0.01;
    step.y = dynamics.initial_y();
    step.y[0] += amplitude * std::cos(phase);
    step.y[dynamics.system().q_size()] = amplitude * std::sin(phase);
    for (int body = 0; body < dynamics.system().body_count(); ++body) {
      step.y[position_size * body + 2] += along * step.t;
      step.y[dynamics.system().q_size() + velocity_size * body + 2] = along;
    }
    step.y_new = step.y;
  }
  return out;
}

MovingAxes axes(const Dynamics& dynamics, double along) {
  MovingAxes out;
  out.part.assign(static_cast<std::size_t>(dynamics.system().body_count()), 0);
  out.velocity = along * Vec3<double>::UnitZ();
  return out;
}

double nonlinearity(const Model& model, double amplitude, double along = 0.0, int count = states) {
  Dynamics dynamics(model, Options());
  const std::vector<KeptStep> steps = vibration(dynamics, amplitude, along, count);
  std::vector<const KeptStep*> places;
  for (const KeptStep& step : steps) places.push_back(&step);
  return find_nonlinearity(dynamics, places, axes(dynamics, along), VectorXd::Ones(1), {})[0];
}

}  // namespace

TEST_CASE("springs along the way are linear, however far it goes") {
  for (const double amplitude : {1e-3, 0.5}) CHECK(nonlinearity(held(0.7, false), amplitude) < 1e-11);
}

TEST_CASE("springs across the way have a term of the third order, and periods that depend on the energy") {
  const auto force = [](double x) { return 2.0 * k * x * (1.0 - 0.8 / std::sqrt(1.0 + x * x)); };
  for (const double amplitude : {0.01, 0.1, 0.3}) {
    const double odd = force(amplitude) - 2.0 * force(amplitude / 2.0);
    CHECK(nonlinearity(held(0.8, true), amplitude) == doctest::Approx(8.0 * odd / force(amplitude)).epsilon(1e-6));
  }
  CHECK(nonlinearity(held(1.0, true), 0.5) == 1.0);  // the linear term is none at all
}

TEST_CASE("a pendulum has the square of its largest rotation at least, and not far more") {
  Model model;
  model.add_body("rod", body_at({0.0, 0.0, -0.5}));
  Attachment<double> at = between(Vec3<double>::Zero(), {0.0, 0.0, 0.5});
  at.C_i = at.C_j = Eigen::AngleAxisd(-M_PI / 2.0, Vec3<double>::UnitX()).toRotationMatrix();  // z along y
  model.add_joint("revolute", "pin", ground, 0, at, {});
  for (const double amplitude : {0.05, 0.2, 1.5}) {  // of one freedom: even terms count by their squares
    Dynamics dynamics(model, Options());
    std::vector<KeptStep> steps = vibration(dynamics, 0.0);
    std::vector<const KeptStep*> places;
    for (KeptStep& step : steps) {
      const double angle = amplitude * std::cos(2.0 * M_PI * step.t / (0.1 * states));
      step.y.segment<3>(0) = Eigen::AngleAxisd(angle, Vec3<double>::UnitY()) * Vec3<double>(0.0, 0.0, -0.5);
      step.y.segment<4>(3) << std::cos(angle / 2.0), 0.0, std::sin(angle / 2.0), 0.0;
      places.push_back(&step);
    }
    const double found = find_nonlinearity(dynamics, places, axes(dynamics, 0.0), VectorXd::Ones(1), {})[0];
    CHECK(found >= std::min(0.8 * amplitude * amplitude, 1.0));
    CHECK(found <= std::min(40.0 * amplitude * amplitude, 1.0));
  }
}

TEST_CASE("how fast a vibrating whole goes changes nothing") {
  const double at_rest = nonlinearity(pair(), 0.3);
  CHECK(at_rest > 0.01);
  CHECK(nonlinearity(pair(), 0.3, 700.0) == doctest::Approx(at_rest).epsilon(1e-6));
}

TEST_CASE("of few states, and of what acts at some of them only, nothing is known") {
  CHECK(nonlinearity(held(0.7, false), 0.5, 0.0, 7) == 1.0);
  Model model = held(0.7, false);
  model.add_force("translational_stop", "stop", ground, 0, between(Vec3<double>::Zero(), Vec3<double>::Zero()),
                  {{-9.0, -1}, {9.0, -1}, {1e5, -1}, {0.0, -1}});
  CHECK(nonlinearity(model, 0.5) == 1.0);
}

TEST_CASE("of what takes energy, and of what does not come back, nothing is told") {
  for (const double damping : {-0.1, 0.1}) {
    Model model = held(0.7, false);
    model.add_force("spring_damper", "damper", ground, 0, between(-Vec3<double>::UnitX(), Vec3<double>::Zero()),
                    {{0.0, -1}, {damping, -1}, {1.0, -1}, {0.0, -1}});
    CHECK(nonlinearity(model, 0.5) == 1.0);
  }
  CHECK(nonlinearity(held(1.2, true), 0.1) == 1.0);  // pressed, and unstable in the middle
}
