#include "linkwork/assembly/force_elements.hpp"

#include <cmath>
#include <numbers>

#include "mechanisms.hpp"

using namespace support;

namespace {

constexpr double stiffness = 7.0, damping = 0.3, length = 0.8;  // N/m, N s/m, m

/// A spring with damper from the ground at (0, 0, 1) to a corner of a moving body.
Model sprung() {
  Model model;
  Random random(3);
  Body body = body_at({1.0, 0.4, -0.2});
  body.velocity = random.vec3();
  body.omega = random.vec3();
  model.add_body("block", body);
  const Vec3<double> hook(0, 0, 1), corner(0.3, -0.2, 0.1);
  const Mat3<double> I = Mat3<double>::Identity();
  model.add_force("spring_damper", "spring", ground, 0, {hook, corner, I, I},
                  {{stiffness, -1}, {damping, -1}, {length, -1}, {0.0, -1}});
  return model;
}

/// Elements of one kind between random bodies, and what they give, one after the other or several at a time.
class Elements {
 public:
  Elements(const ForceKind& kind, int count, int seed, bool constant) : kind_(kind), q_(28), v_(24) {
    Random random(seed);
    for (int body = 0; body < 4; ++body) {
      const Body it = random_body(random);
      q_.segment<7>(7 * body) << it.position, it.orientation;
      v_.segment<6>(6 * body) << it.velocity, it.omega;
    }
    for (int k = 0; k < count; ++k) {
      const int i = random.integer(-1, 3);
      elements_.push_back({.i = i, .j = (i + 1 + random.integer(1, 4)) % 5 - 1, .at = random_attachment(random)});
      if (k % 3 == 1) coincide(elements_.back(), k % 2);
      for (const ParameterInfo& it : kind.info.parameters) {
        signals_.push_back({random.number(), random.number(), random.number()});
        if (it.name == "lower") signals_.back().value = -0.1;
        if (it.name == "upper") signals_.back().value = 0.2;
        if (constant || it.constant() || k % 2) parameters_.push_back({random.number(0, 2), -1});
        else parameters_.push_back({0.0, static_cast<int>(signals_.size()) - 1});
      }
      last_.push_back(random.number(-20, 20));
    }
  }

  /// g, potential, power, history, switches; `left`: wrenches instead of sums. Level -1: each element by itself.
  std::vector<double> evaluate(int level, bool left) const {
    const int count = static_cast<int>(elements_.size());
    std::vector<double> g(24, 0.1), next(count), rate(count), switches(2 * count), wrenches(wrench_size * count);
    double potential = 0.3, power = 0.7;
    const auto add = [&](int first, int last, int by) {
      const ForceBatch batch = batch_of(first, last, instruction_set(by).width);
      ForceArrays out{g.data(), last_.data(), next.data(), rate.data(), switches.data(), &potential, &power};
      if (left) out.wrenches = wrenches.data() + wrench_size * first;
      kind_.packs[by](batch.elements(0, last - first), q_.data(), v_.data(), signals_.data(), out);
    };
    if (level >= 0) add(0, count, level);
    for (int k = 0; k < count && level < 0; ++k) add(k, k + 1, 0);
    for (const auto* more : {&next, &rate, &switches, &wrenches}) g.insert(g.end(), more->begin(), more->end());
    g.insert(g.end(), {potential, power});
    return g;
  }

 private:
  struct Placed {
    int i, j;
    Attachment<double> at;
  };

  ForceBatch batch_of(int first, int last, int width) const {
    const std::size_t each = kind_.info.parameters.size();
    ForceBatch batch;
    batch.reserve(last - first, each, width);
    for (int k = first; k < last; ++k) {
      batch.append(k, elements_[k].i, elements_[k].j, parameters_.data() + each * k, each);
      batch.attach(elements_[k].at);
      batch.history.push_back(k);
      batch.switches.push_back(2 * k);
    }
    batch.fill_up();
    return batch;
  }

  BodyState<double> pose(int body) const {
    BodyState<double> out = BodyState<double>::ground();
    if (body == ground) return out;
    out.r = q_.segment<3>(7 * body);
    out.A = rotation_matrix<double>(q_.segment<4>(7 * body + 3));
    return out;
  }

  /// Points, and axes: where a law has no direction to act in.
  void coincide(Placed& it, bool axes) const {
    const BodyState<double> i = pose(it.i), j = pose(it.j);
    it.at.s_j = j.A.transpose() * (i.r + i.A * it.at.s_i - j.r);
    if (axes) it.at.C_j = j.A.transpose() * (i.A * it.at.C_i);
  }

  const ForceKind& kind_;
  VectorXd q_, v_;
  std::vector<Placed> elements_;
  std::vector<Parameter> parameters_;
  std::vector<Signal<double>> signals_;
  std::vector<double> last_;
};

/// Elements of one kind about z, each from the ground to a body that has turned by an angle and turns at a rate.
struct Turned {
  VectorXd q, v;
  std::vector<double> g, angles;

  Turned(const char* name, const std::vector<double>& constants, const std::vector<double>& turned,
         const std::vector<double>& rates, int level)
      : q(7 * turned.size()), v(VectorXd::Zero(6 * turned.size())), g(6 * turned.size()), angles(turned.size()) {
    const int count = static_cast<int>(turned.size());
    const ForceKind& kind = force_kinds()[force_kind_index(name)];
    std::vector<Parameter> parameters;
    for (const double constant : constants) parameters.push_back({constant, -1});
    ForceBatch batch;
    batch.reserve(turned.size(), parameters.size(), instruction_set(level).width);
    for (int k = 0; k < count; ++k) {
      q.segment<7>(7 * k) << 0, 0, 0, std::cos(turned[k] / 2), 0, 0, std::sin(turned[k] / 2);
      v[6 * k + 5] = rates[k];
      batch.append(k, ground, k, parameters.data(), parameters.size());
      batch.attach(Attachment<double>{Vec3<double>::Zero(), Vec3<double>::Zero(), Mat3<double>::Identity(),
                                      Mat3<double>::Identity()});
      batch.history.push_back(k);
      batch.switches.push_back(0);
    }
    batch.fill_up();
    const std::vector<double> last(count, 0.0);
    std::vector<double> rate(count);
    double potential = 0.0, power = 0.0;
    kind.packs[level](batch.elements(0, count), q.data(), v.data(), nullptr,
                      {g.data(), last.data(), angles.data(), rate.data(), nullptr, &potential, &power});
  }

  double torque(std::size_t k) const { return g[6 * k + 5]; }
  double angle_of_one(std::size_t k) const {
    const Mat3<double> A = rotation_matrix<double>(q.segment<4>(7 * static_cast<Eigen::Index>(k) + 3));
    return continued(elementary::arc_tangent(A(1, 0), A(0, 0)), 0.0);
  }
};

}  // namespace

TEST_CASE("elements that are evaluated several at a time give what each gives, to the last bit") {
  int kinds = 0;
  for (const ForceKind& kind : force_kinds()) {
    if (!kind.packs[0]) continue;
    kinds += 1;
    CAPTURE(kind.info.name);
    for (const int count : {1, 2, 3, 7, 8, 9, 21})
      for (int level = 0; level < evaluation_count(); ++level) {
        CAPTURE(count);
        CAPTURE(level);
        for (const bool constant : {false, true}) {
          const Elements elements(kind, count, 3 * count, constant);
          for (const bool left : {false, true}) CHECK(elements.evaluate(level, left) == elements.evaluate(-1, left));
        }
      }
  }
  CHECK(kinds >= 10);
}

// Zero, right angles and rates that are zero or large are where their series are not used.
TEST_CASE("angles and friction of many elements have the bits of the functions of one number") {
  using std::numbers::pi;
  const std::vector<double> angles = {0.0, 1e-12, 0.3, pi / 4, 1.1, pi / 2, 2.9, pi, -pi, -2.0, -pi / 2, -1e-7, -0.5};
  const std::vector<double> rates = {0.0, 1e-300, 1e-3, 0.1, -0.4, 3.0, -21.9, 22.1, -1e3, 1e300, 0.2, -0.1, 1.0};
  const std::vector<double> zeros(angles.size(), 0.0);
  for (int level = 0; level < evaluation_count(); ++level) {
    CAPTURE(level);
    const Turned springs("rotational_spring_damper", {1.0, 0.0, 0.0, 0.0}, angles, rates, level);
    const Turned rubbing("rotational_friction", {1.0, 0.0, 1.0}, zeros, rates, level);  // whose D is exact
    for (std::size_t k = 0; k < angles.size(); ++k) {
      CAPTURE(k);
      CHECK(springs.angles[k] == springs.angle_of_one(k));
      CHECK(std::signbit(springs.angles[k]) == std::signbit(springs.angle_of_one(k)));
      CHECK(rubbing.torque(k) == -elementary::hyperbolic_tangent(rates[k]));
    }
  }
}

TEST_CASE("a spring with damper pulls along its line, stores and gives what its law says") {
  const System system(sprung());
  const VectorXd q = system.model().initial_q(), v = system.model().initial_v();
  ForceElement spring(system, 0);
  const ForceOnBody found = spring.evaluate(0.0, q, v, VectorXd::Zero(v.size()), VectorXd());
  const Vec3<double> corner(0.3, -0.2, 0.1), end = q.head<3>() + corner;  // not turned at the start
  const Vec3<double> d = end - Vec3<double>(0, 0, 1);
  const Vec3<double> speed = v.head<3>() + Vec3<double>(v.segment<3>(3)).cross(corner);
  const double rate = d.normalized().dot(speed);
  const double pull = stiffness * (d.norm() - length) + damping * rate;
  CHECK((found.force + pull * d.normalized()).norm() < 1e-13);
  CHECK(found.torque.norm() < 1e-13);  // at its point there is none
  CHECK(found.power == doctest::Approx(-pull * rate));
  CHECK(found.potential == doctest::Approx(0.5 * stiffness * std::pow(d.norm() - length, 2)));
}

TEST_CASE("what it gives is what the energies of the mechanism lose") {
  const System system(sprung());
  const VectorXd q = system.model().initial_q(), v = system.model().initial_v();
  const Evaluation at = evaluate_initially(system);
  ForceElement spring(system, 0);
  const ForceOnBody found = spring.evaluate(0.0, q, v, VectorXd::Zero(v.size()), VectorXd());
  const double weight = system.model().gravity().dot(v.head<3>());  // of 1 kg
  CHECK(at.g.head(v.size()).dot(v) == doctest::Approx(found.power + weight));
}

TEST_CASE("an inerter gives what the energies of the mechanism lose, and its own grows by") {
  Random random(321);
  Model model = random_tree(random, 3);
  for (const char* kind : {"inerter", "rotational_inerter", "translational_inerter"})
    model.add_force(kind, kind, 0, 2, random_attachment(random), {{0.7, -1}});
  const System system(model);
  const VectorXd q = model.initial_q(), v = model.initial_v(), v_dot = random.vector(system.v_size());
  const Evaluation at = evaluate_initially(system);
  VectorXd inertial(v.size()), bodies(v.size());
  system.multiply_mass(at, v_dot, inertial);
  const System without(model.without_forces());
  without.multiply_mass(evaluate_initially(without), v_dot, bodies);
  double power = 0.0;
  for (int k = 0; k < 3; ++k) {
    const ForceOnBody found = ForceElement(system, k).evaluate(0.0, q, v, v_dot, VectorXd());
    power += found.power;
    CHECK(found.potential == 0.0);
  }
  // M v_dot - g of all and of the bodies alone differ by the forces of the inerters.
  const VectorXd g = at.g.head(v.size()), g_bodies = evaluate_initially(without).g.head(v.size());
  CHECK(power == doctest::Approx(v.dot((bodies - g_bodies) - (inertial - g))).epsilon(1e-12));
}
