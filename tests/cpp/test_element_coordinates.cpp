#include "linkwork/assembly/element_coordinates.hpp"

#include <cstring>
#include <memory>

#include "support.hpp"

using namespace support;

namespace {

/// By quarters about one of its axes.
void turn(Mat3<double>& frame, int axis, int quarters) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  for (int k = 0; k < quarters; ++k) {
    const Vec3<double> first = frame.col(a);
    frame.col(a) = frame.col(b);
    frame.col(b) = -first;
  }
}

/// Joints between neighbors, each with a rotor, a stop, friction and, about angles, a spring: along one coordinate, or,
/// `apart`, along as many that are the same but for axes that do not count.
Model model_of(int bodies, bool turns, bool apart) {
  Random random(static_cast<std::uint64_t>(bodies));
  Model model;
  for (int body = 0; body < bodies; ++body) model.add_body("body" + std::to_string(body), random_body(random));
  int others = 0;
  const auto add = [&](const char* kind, int k, Attachment<double> at, std::vector<Parameter> parameters) {
    if (apart && turns) turn(at.C_j, 0, others++ % 4);   // an angle knows of x_j only
    if (apart && !turns) turn(at.C_i, 2, others++ % 4);  // and a shift of z_i
    model.add_force(kind, kind + std::to_string(k), k - 1, k, at, parameters);
  };
  for (int k = 0; k < bodies; ++k) {
    const Attachment<double> at = random_attachment(random);
    add(turns ? "rotational_inerter" : "translational_inerter", k, at, {{0.3, -1}});
    add(turns ? "rotational_friction" : "translational_friction", k, at, {{1.1, -1}, {0.2, -1}, {0.4, -1}});
    add(turns ? "rotational_stop" : "translational_stop", k, at, {{-0.2, -1}, {0.1, -1}, {30.0, -1}, {2.0, -1}});
    if (turns) add("rotational_spring_damper", k, at, {{5.0, -1}, {0.3, -1}, {0.1, -1}, {0.7, -1}});
  }
  return model;
}

template <class Numbers>
bool same_bits(const Numbers& a, const Numbers& b) {
  if (a.size() == 0 || a.size() != b.size()) return a.size() == b.size();
  return std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

}  // namespace

TEST_CASE("elements along one coordinate evaluate it once, and give what each gives by itself, to the last bit") {
  for (const int bodies : {1, 3, 8, 9, 2200})
    for (const bool turns : {false, true})
      for (int level = 0; level < instruction_set_count(); ++level) {
        CAPTURE(bodies);
        CAPTURE(turns);
        CAPTURE(level);
        const System together(model_of(bodies, turns, false), instruction_set(level));
        const System apart(model_of(bodies, turns, true), instruction_set(level));
        CHECK(together.element_coordinates().count() == static_cast<std::size_t>(bodies));
        CHECK(together.element_coordinates().D_size() == 0);
        CHECK(together.element_coordinates().row(1) == 0);
        CHECK(apart.element_coordinates().row(1) == -1);
        const Evaluation a = evaluate_initially(together), b = evaluate_initially(apart);
        CHECK(same_bits(VectorXd(a.g.head(6 * bodies)), VectorXd(b.g.head(6 * bodies))));
        CHECK(same_bits(a.history, b.history));
        CHECK(same_bits(a.history_rate, b.history_rate));
        CHECK(same_bits(a.switches, b.switches));
        CHECK(a.potential == b.potential);
        CHECK(a.power == b.power);
      }
}

TEST_CASE("and so do several threads") {
  System one(model_of(2200, true, false)), three(model_of(2200, true, false));
  three.use(std::make_shared<ThreadPool>(3));
  const Evaluation a = evaluate_initially(one), b = evaluate_initially(three);
  CHECK(same_bits(VectorXd(a.g.head(6 * 2200)), VectorXd(b.g.head(6 * 2200))));
  CHECK(a.power == b.power);
}

TEST_CASE("without an inerter they have a row of their own; what has a coordinate to itself is evaluated by itself") {
  Random random(4);
  Model model = random_tree(random, 3);
  const Attachment<double> at = random_attachment(random);
  model.add_force("rotational_friction", "friction", 0, 1, at, {{1.0, -1}, {0.1, -1}, {0.1, -1}});
  model.add_force("rotational_spring_damper", "spring", 0, 1, at, {{2.0, -1}, {0.1, -1}, {0.0, -1}, {0.0, -1}});
  const System both(model);
  CHECK(both.element_coordinates().count() == 1);
  CHECK(both.element_coordinates().D_size() == 12);
  CHECK(both.row_of_zeros() + 6 + 12 == static_cast<std::ptrdiff_t>(both.make_evaluation().D.size()));
  model.add_force("rotational_friction", "other", 1, 2, at, {{1.0, -1}, {0.1, -1}, {0.1, -1}});
  const System three(model);
  CHECK(three.element_coordinates().row(0) == -1);  // not all of its kind
  CHECK(three.element_coordinates().row(1) == 0);
}
