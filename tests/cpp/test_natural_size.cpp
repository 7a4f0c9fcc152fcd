#include "linkwork/constraints/natural_size.hpp"

#include "mechanisms.hpp"

using namespace support;

TEST_CASE("a displacement counts by its rotation, or by its translation over the length of the body") {
  const System system(four_bar());
  const NaturalSize size(system);
  VectorXd x = VectorXd::Zero(system.v_size());
  x.segment<3>(6) = Vec3<double>(0.3, 0, 0.4);
  CHECK(size.of(x) == doctest::Approx(0.5 / size.length(1)).epsilon(1e-15));
  x.segment<3>(15) = Vec3<double>(2, 1, 2);
  CHECK(size.of(x) == doctest::Approx(3.0).epsilon(1e-15));
}

TEST_CASE("a force counts by what it does to the mass alone, a torque as that force at the length of the body") {
  Model model = four_bar();
  std::vector<Body> bodies = model.bodies();
  bodies[1].mass = 4.0;
  bodies[2].mass = 0.0;
  bodies[2].inertia.setZero();
  const System system(model.with_masses(bodies));
  const NaturalSize size(system);
  const double length = size.length(1);
  VectorXd a = VectorXd::Zero(system.v_size());
  a[6] = 3.0;
  CHECK(size.of_free_motion(a) == doctest::Approx(3.0 / (4.0 * length)).epsilon(1e-15));
  a[6] = 0.0;
  a[11] = 3.0;
  CHECK(size.of_free_motion(a) == doctest::Approx(3.0 / (4.0 * length * length)).epsilon(1e-15));
  a.tail<6>().setConstant(1e9);  // on a body without mass
  CHECK(size.of_free_motion(a) == doctest::Approx(3.0 / (4.0 * length * length)).epsilon(1e-15));
}

TEST_CASE("nothing in proportion to nothing is nothing") {
  CHECK(NaturalSize::ratio(0.0, 0.0) == 0.0);
  CHECK(NaturalSize::ratio(1.0, 4.0) == 0.25);
}

TEST_CASE("connected components have sizes of their own") {
  Model model = four_bar();
  model.add_body("apart", body_at({3, 0, 0}));
  const System system(model);
  const NaturalSize size(system);
  VectorXd x = VectorXd::Zero(system.v_size()), sizes, free_motions;
  x.head<18>().setConstant(0.1);
  x.tail<6>() << 0, 0, 0, 2e6, 0, 0;
  size.of(x, sizes);
  REQUIRE(sizes.size() == 2);
  CHECK(sizes[1] == 2e6);
  CHECK(size.of(x) == 2e6);
  x.tail<6>().setZero();
  CHECK(sizes[0] == size.of(x));
  size.of_free_motion(x, free_motions);
  CHECK(free_motions[0] == size.of_free_motion(x));
  CHECK(free_motions[1] == 0.0);
  CHECK(NaturalSize::largest_ratio(Vec3<double>(1, 0, 2), Vec3<double>(4, 0, 5)) == 0.4);
}
