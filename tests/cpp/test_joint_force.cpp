#include "linkwork/model/joint_force.hpp"

#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

TEST_CASE("a law along a coordinate of a joint has the power Q x_dot, and acts on both bodies alike") {
  struct Law final : CoordinateLaw {
    double effort(double t, double x, double x_dot) const override { return 2.0 * t - 3.0 * x + 0.5 * x_dot; }
  };
  Random random(21);
  for (const auto& [kind, coordinate] :
       std::vector<std::pair<std::string, std::string>>{{"revolute", "angle"},
                                                        {"translational", "displacement"},
                                                        {"universal", "angle_a"},
                                                        {"universal", "angle_b"}}) {
    INFO(kind, " ", coordinate);
    Model without(Vec3<double>::Zero());
    for (const char* name : {"a", "b"}) without.add_body(name, random_body(random));
    add_joint(without, random, kind, "joint", 0, 1);
    Model model = without;
    model.add_joint_force("law", 0, coordinate, std::make_shared<Law>());
    CHECK_THROWS_AS(model.add_joint_force("other", 0, "nix", std::make_shared<Law>()), ModelError);
    CHECK_THROWS_AS(model.add_joint_force("law", 0, coordinate, std::make_shared<Law>()), ModelError);
    const System system(model), plain(without);
    Evaluation at = system.make_evaluation(), bare = plain.make_evaluation();
    const VectorXd q = model.initial_q(), v = model.initial_v();
    system.evaluate(0.3, q, v, system.initial_history(), at);
    plain.evaluate(0.3, q, v, plain.initial_history(), bare);
    const VectorXd g = (at.g - bare.g).head(12);
    CHECK(g.dot(v) == doctest::Approx(at.power));
    CHECK(std::abs(at.power) > 1e-6);
    CHECK((g.segment<3>(0) + g.segment<3>(6)).norm() <= 1e-12 * g.norm());
  }
}
