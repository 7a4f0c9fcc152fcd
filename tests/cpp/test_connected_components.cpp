#include "linkwork/assembly/connected_components.hpp"

#include "mechanisms.hpp"
#include "support.hpp"

using namespace support;

TEST_CASE("a force connects two bodies where forces count, too, and none to the ground") {
  Model model;
  for (int k = 0; k < 3; ++k) model.add_body("body " + std::to_string(k), body_at({1.0 * k, 0, 0}));
  Random random(53);
  const std::vector<Parameter> parameters = {{100.0, -1}, {0.0, -1}, {1.0, -1}, {0.0, -1}};
  model.add_force("spring_damper", "between", 0, 2, random_attachment(random), parameters);
  model.add_force("spring_damper", "to ground", ground, 1, random_attachment(random), parameters);
  const System system(model);
  CHECK(ConnectedComponents(system).count() == 3);
  const ConnectedComponents parts(system, ConnectedComponents::Edges::forces_too);
  CHECK(parts.count() == 2);
  CHECK(parts.of_body(0) == parts.of_body(2));
}

TEST_CASE("joints and inerters connect bodies, the ground does not") {
  Model model;
  for (int k = 0; k < 6; ++k) model.add_body("body " + std::to_string(k), body_at({1.0 * k, 0, 0}));
  join(model, "spherical", "to ground", ground, 0, {0, 0, 0});
  join(model, "spherical", "also to ground", ground, 1, {1, 0, 0});
  join(model, "revolute", "hinge", 1, 4, {2, 0, 0});
  join(model, "spherical", "ball", 5, 3, {4, 0, 0});
  Random random(52);
  model.add_force("inerter", "inerter", 2, 0, random_attachment(random), {{0.3, -1}});
  model.add_force("inerter", "inerter to ground", ground, 2, random_attachment(random), {{0.3, -1}});
  const System system(model);
  const auto& components = ConnectedComponents::of(system);
  CHECK(components.count() == 3);
  CHECK(components.of_body(0) == 0);
  CHECK(components.of_body(1) == components.of_body(4));
  CHECK(components.of_body(3) == components.of_body(5));
  CHECK(components.of_body(2) == components.of_body(0));
  CHECK(components.of_body(2) != components.of_body(1));
  CHECK(components.of_row(0) == 0);
  CHECK(components.of_row(3) == components.of_body(1));
  CHECK(components.of_row(6 + 4) == components.of_body(4));
  CHECK(components.of_row(system.row_count() - 1) == components.of_body(3));
  CHECK(&components == &ConnectedComponents::of(system));
}
