#include "linkwork/integration/tolerances.hpp"

#include "support.hpp"

using namespace support;

TEST_CASE("an error of a rotation is measured by its angle, whatever its axis, and a change of length like one") {
  Random random(9);
  Model model;
  model.add_body("body", random_body(random));
  const System system(model);
  const Tolerances tolerances{1e-6, 1e-9};
  const ErrorMeasure measure(system, tolerances);
  const double angle = 1e-7;
  for (int trial = 0; trial < 20; ++trial) {
    VectorXd y = VectorXd::Zero(14), dy = VectorXd::Zero(14);
    const Vec4<double> p = random.unit_quaternion();
    y.segment<4>(3) = p;
    const Vec3<double> axis = random.vec3().normalized();
    dy.segment<4>(3) = quaternion_product<double>(p, exponential(angle * axis)) - p;
    CHECK(measure.of_change(y, y, dy).value == doctest::Approx(angle / 1.001e-6).epsilon(1e-6));
    dy.segment<4>(3) = 1e-3 * p;
    CHECK(measure.of_change(y, y, dy).value == doctest::Approx(2e-3 / 1.001e-6).epsilon(1e-9));
  }
}

TEST_CASE("a change counts by its length over the bound of its size, and names the body") {
  Model model;
  Body body;
  model.add_body("near", body);
  body.position = {3, 0, 4};
  model.add_body("far", body);
  const System system(model);
  const Tolerances tolerances{.relative = 1e-3, .absolute = 1e-4};
  VectorXd y = VectorXd::Zero(system.q_size() + system.v_size() + 1), dy = y;
  y.head(system.q_size()) = model.initial_q();
  dy[0] = 2e-4;
  dy.segment<3>(7) = Vec3<double>(3e-3, 0, 4e-3);
  const ErrorMeasure measure(system, tolerances);
  const BodyMaximum found = measure.of_change(y, y, dy);
  CHECK(found.body == 0);
  CHECK(found.value == doctest::Approx(2.0).epsilon(1e-14));  // 2e-4 / 1e-4 against 5e-3 / 5.1e-3
  CHECK(measure.of_length(y) == doctest::Approx(1e-4 + 1e-3 * 5).epsilon(1e-14));
  const VectorXd of_parts = measure.of_parts(y, y, dy);
  CHECK(of_parts.size() == 2);
  CHECK(of_parts[0] == found.value);
  CHECK(of_parts[1] == doctest::Approx(5e-3 / 5.1e-3).epsilon(1e-14));
}

TEST_CASE("what an error is does not depend on the axes of space") {
  Random random(8);
  Model model;
  model.add_body("body", random_body(random));
  const System system(model);
  const VectorXd y = random.vector(14), dy = random.vector(14, 1e-4);
  const Vec4<double> turn = random.unit_quaternion();
  const Mat3<double> R = rotation_matrix<double>(turn);
  const auto turned = [&](const VectorXd& x) {
    VectorXd out = x;
    out.head<3>() = R * x.head<3>();
    out.segment<4>(3) = quaternion_product<double>(turn, x.segment<4>(3));
    out.segment<3>(7) = R * x.segment<3>(7);
    return out;
  };
  const ErrorMeasure measure(system, {});
  CHECK(measure.of_change(turned(y), turned(y), turned(dy)).value ==
        doctest::Approx(measure.of_change(y, y, dy).value).epsilon(1e-12));
}
