#include "linkwork/assembly/force_elements.hpp"

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
  Elements(const ForceKind& kind, int count, int seed) : kind_(kind) {
    Random random(seed);
    for (int body = 0; body < 4; ++body) {
      const Body it = random_body(random);
      bodies_.push_back({it.position, rotation_matrix<double>(it.orientation), it.velocity, it.omega});
    }
    bodies_.push_back(BodyState<double>::ground());
    for (int k = 0; k < count; ++k) {
      const int i = random.integer(0, 4);
      batch_.body_i.push_back(i);
      batch_.body_j.push_back((i + random.integer(1, 4)) % 5);
      batch_.attachment.push_back(random_attachment(random));
      if (k % 3 == 1) coincide(k);
      for (const ParameterInfo& it : kind.info.parameters) {
        signals_.push_back({random.number(), random.number(), random.number()});
        if (it.name == "lower") signals_.back().value = -0.1;
        if (it.name == "upper") signals_.back().value = 0.2;
        const bool constant = it.constant() || k % 2;
        batch_.parameters.push_back({constant ? random.number(0, 2) : 0.0, constant ? -1 : int(signals_.size()) - 1});
      }
      batch_.history.push_back(k);
      batch_.switches.push_back(2 * k);
      last_.push_back(random.number(-20, 20));
    }
  }

  /// g, potential, power, history and switches; `from`, `to`: wrenches of those alone.
  std::vector<double> evaluate(int level, int from = -1, int to = -1) {
    const std::size_t count = batch_.size();
    std::vector<double> g(30, 0.1), next(count), rate(count), switches(2 * count), wrenches(wrench_size * count);
    double potential = 0.3, power = 0.7;
    ForceArrays out{g.data(), last_.data(), next.data(), rate.data(), switches.data(), &potential, &power};
    if (from >= 0) {
      out.wrenches = wrenches.data();
      out.begin = static_cast<std::size_t>(from);
      out.end = static_cast<std::size_t>(to);
    }
    if (level >= 0) kind_.packs[level](batch_.elements(), bodies_.data(), signals_.data(), out);
    for (std::size_t k = 0; k < count && level < 0; ++k) {  // each by itself
      ForceElements one = batch_.elements();
      one.count = k + 1;
      ForceArrays its = out;
      its.begin = std::max(out.begin, k);
      if (k < out.end) kind_.packs[0](one, bodies_.data(), signals_.data(), its);
    }
    for (const auto* more : {&next, &rate, &switches, &wrenches}) g.insert(g.end(), more->begin(), more->end());
    g.insert(g.end(), {potential, power});
    return g;
  }

 private:
  /// Points, and axes: where a law has no direction to act in.
  void coincide(int k) {
    const BodyState<double>&i = bodies_[batch_.body_i[k]], &j = bodies_[batch_.body_j[k]];
    Attachment<double>& at = batch_.attachment[k];
    at.s_j = j.A.transpose() * (i.r + i.A * at.s_i - j.r);
    if (k % 2) at.C_j = j.A.transpose() * (i.A * at.C_i);
  }

  const ForceKind& kind_;
  std::vector<BodyState<double>> bodies_;
  Batch batch_;
  std::vector<Signal<double>> signals_;
  std::vector<double> last_;
};

}  // namespace

TEST_CASE("elements that are evaluated several at a time give what each gives, to the last bit") {
  int kinds = 0;
  for (const ForceKind& kind : force_kinds()) {
    if (!kind.packs[0]) continue;
    kinds += 1;
    CAPTURE(kind.info.name);
    for (const int count : {1, 2, 3, 7, 8, 9, 21})
      for (int level = 0; level < instruction_set_count(); ++level) {
        CAPTURE(count);
        CAPTURE(level);
        Elements elements(kind, count, 3 * count);
        CHECK(elements.evaluate(level) == elements.evaluate(-1));
        CHECK(elements.evaluate(level, 1, count - 1) == elements.evaluate(-1, 1, count - 1));
      }
  }
  CHECK(kinds >= 10);
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
