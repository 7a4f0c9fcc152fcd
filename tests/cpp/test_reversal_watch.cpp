#include "linkwork/integration/reversal_watch.hpp"

#include "swinging_rod.hpp"

using namespace linkwork;
using namespace support::swinging_rod;

namespace {

Attachment<double> along(const Vec3<double>& z) {
  Attachment<double> at;
  at.s_i.setZero();
  at.s_j = {0.0, 0.0, arm};
  at.C_i = at.C_j = Eigen::Quaterniond::FromTwoVectors(Vec3<double>::UnitZ(), z).toRotationMatrix();
  return at;
}

void rub(Model& model, const std::string& kind, const std::string& name, int i, int j, const Attachment<double>& at,
         double coulomb) {
  model.add_force(kind, name, i, j, at, {{coulomb, -1}, {0.5, -1}, {0.1, -1}});
}

std::vector<int> found(const Model& model, const VectorXd& y) {
  const System system(model);
  return ReversalWatch(system).directions(y);
}

}  // namespace

TEST_CASE("a hinge turns to and fro, or hardly at all") {
  Model model = pendulum();
  rub(model, "rotational_friction", "friction", ground, 0, along(Vec3<double>::UnitY()), 2.0);
  for (const double angle : {0.0, 1.0, 3.0}) {
    CHECK(found(model, state(angle, 0.2)) == std::vector<int>{1});
    CHECK(found(model, state(angle, -0.2)) == std::vector<int>{-1});
    CHECK(found(model, state(angle, 0.05)) == std::vector<int>{0});
  }
}

TEST_CASE("between two bodies it is what one does seen from the other") {
  Model model = pendulum();
  Body second;
  second.mass = 1.0;
  second.inertia = Mat3<double>::Identity();
  model.add_body("second", second);
  rub(model, "rotational_friction", "friction", 1, 0, along(Vec3<double>::UnitY()), 2.0);
  VectorXd y = VectorXd::Zero(27);
  y.head<7>() = state(0.5, 1.0).head<7>();
  y.segment<4>(10) = state(-0.3, 0.0).segment<4>(3);
  y.segment<6>(14) = state(0.5, 1.0).segment<6>(7);
  for (const auto& [rate, direction] : {std::pair(0.8, 1), std::pair(0.95, 0), std::pair(1.3, -1)}) {
    y[24] = rate;
    CHECK(found(model, y) == std::vector<int>{direction});
  }
}

TEST_CASE("a slider goes by what its point does along the axis, which turns with the first body") {
  Model model(Vec3<double>::Zero());
  for (const char* name : {"arm", "slider"}) {
    Body body;
    body.mass = 1.0;
    body.inertia = Mat3<double>::Identity();
    model.add_body(name, body);
  }
  Attachment<double> at = along(Vec3<double>::UnitX());
  at.s_j.setZero();
  rub(model, "translational_friction", "friction", 0, 1, at, 2.0);
  VectorXd y = VectorXd::Zero(27);
  y[3] = y[10] = 1.0;
  y[7] = 2.0;           // the slider is 2 m out
  y[19] = y[25] = 3.0;  // both turn about z
  y[21] = 3.0 * 2.0;    // what it does across is that
  for (const auto& [speed, direction] : {std::pair(0.5, 1), std::pair(0.05, 0), std::pair(-0.5, -1)}) {
    y[20] = speed;
    CHECK(found(model, y) == std::vector<int>{direction});
  }
}

TEST_CASE("what only slows down does not reverse") {
  Model model = pendulum();
  rub(model, "rotational_friction", "viscous", ground, 0, along(Vec3<double>::UnitY()), 0.0);
  const System viscous(model);
  CHECK(ReversalWatch(viscous).empty());
  rub(model, "rotational_friction", "dry", ground, 0, along(Vec3<double>::UnitY()), 1.0);
  const System dry(model);
  CHECK(ReversalWatch(dry).elements() == std::vector<int>{1});
}
