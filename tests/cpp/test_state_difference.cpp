#include "linkwork/integration/state_difference.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

constexpr double turned = 1e-3;  // rad

/// Two bodies that nothing connects, the second displaced, turned and pushed from where the first of both states is.
struct Two {
  Two() {
    for (const char* name : {"first", "second"}) {
      Body body;
      body.mass = 1.0;
      model.add_body(name, body);
    }
    a = VectorXd::Zero(2 * (position_size + velocity_size));
    a.head(2 * position_size) = model.initial_q();
    b = a;
    b.segment<3>(7) += Vec3<double>(3.0, 4.0, 0.0);
    b.segment<4>(10) = Vec4<double>(std::cos(turned / 2), 0.0, 0.0, std::sin(turned / 2));
    b.segment<3>(14 + 6) += Vec3<double>(0.0, 0.0, 2.0);
    b.segment<3>(14 + 9) += Vec3<double>(0.0, 0.5, 0.0);
  }

  Model model;
  VectorXd a, b;
};

}  // namespace

TEST_CASE("states differ by a length, an angle, a speed and an angular speed, each part by its own") {
  const Two two;
  const System system(two.model);
  const DifferencesOfParts apart = differences(system, two.a, two.b);
  REQUIRE(apart.size() == 2);
  CHECK(apart[0].position + apart[0].rotation + apart[0].velocity + apart[0].omega == 0.0);
  CHECK(apart[1].position == doctest::Approx(5.0));
  CHECK(apart[1].rotation == doctest::Approx(turned).epsilon(1e-6));
  CHECK(apart[1].velocity == doctest::Approx(2.0));
  CHECK(apart[1].omega == doctest::Approx(0.5));
}

TEST_CASE("a difference is raised to another, and lowered by one, not below zero") {
  StateDifference difference{1.0, 2.0, 3.0, 4.0};
  difference.raise({2.0, 1.0, 0.0, 5.0});
  difference.lower({0.5, 3.0, 1.0, 1.0});
  difference.scale(2.0);
  CHECK(difference.position == 3.0);
  CHECK(difference.rotation == 0.0);
  CHECK(difference.velocity == 4.0);
  CHECK(difference.omega == 8.0);
}
