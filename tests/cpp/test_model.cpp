#include <doctest/doctest.h>

#include <cmath>

#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

namespace {

Attachment<double> at_origins() {
  const Mat3<double> I = Mat3<double>::Identity();
  return {Vec3<double>::Zero(), Vec3<double>::Zero(), I, I};
}

/// Two bodies, a group of two links, a joint, a force, and functions of time with (0) and without (1) derivatives.
Model small_model() {
  Model model;
  model.add_body("crank", Body{});
  model.add_body("rod", Body{});
  model.add_bodies("link", {Body{}, Body{}});
  model.add_joint("spherical", "pin", ground, 0, at_origins());
  model.add_force("spring_damper", "spring", 0, 1, at_origins(), std::vector<Parameter>(4));
  model.add_signal(polynomial({1.0}));
  model.add_signal(callback([](double t) { return t; }));
  return model;
}

/// All that a refusal could have changed.
void check_same(const Model& a, const Model& b) {
  CHECK(a.bodies().size() == b.bodies().size());
  CHECK(a.joints().size() == b.joints().size());
  CHECK(a.forces().size() == b.forces().size());
  CHECK(a.joint_parameters().size() == b.joint_parameters().size());
  CHECK(a.force_parameters().size() == b.force_parameters().size());
  CHECK(a.joint_rows() == b.joint_rows());
  CHECK(a.body_names().size() == b.body_names().size());
  CHECK(a.joint_names().size() == b.joint_names().size());
  CHECK(a.force_names().size() == b.force_names().size());
  for (const char* name : {"new", "new[0]", "new[1]"}) {
    CHECK(a.body_names().find(name) == -1);
    CHECK(a.joint_names().find(name) == -1);
    CHECK(a.force_names().find(name) == -1);
  }
}

/// A call on the small model is refused with this class and code, the message holds these words, nothing has changed.
template <class ErrorClass = ModelError, class Call>
void check_refused(Call call, const std::string& code, const std::vector<std::string>& words) {
  Model model = small_model();
  try {
    call(model);
    FAIL_CHECK("no error, expected " << code);
  } catch (const ErrorClass& error) {
    CHECK(error.code() == code);
    INFO(std::string(error.what()));
    for (const std::string& word : words) {
      INFO("should contain: ", word);
      CHECK(std::string(error.what()).find(word) != std::string::npos);
    }
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
  }
  check_same(model, small_model());
}

/// The body is refused alone and as the second of a group, and the error data names it.
void check_body_refused(const Body& body, const std::string& code, const std::vector<std::string>& words) {
  auto with = [&](const char* name) {
    std::vector<std::string> all = words;
    all.push_back(name);
    return all;
  };
  check_refused([&](Model& model) { model.add_body("new", body); }, code, with("body 'new'"));
  check_refused([&](Model& model) { model.add_bodies("new", {Body{}, body}); }, code, with("body 'new[1]'"));
  try {
    Model().add_body("new", body);
  } catch (const Error& error) {
    CHECK(error.details.bodies.front() == "new");
  }
}

Body with_moments(double a, double b, double c) {
  Body body;
  body.inertia = Vec3<double>(a, b, c).asDiagonal();
  return body;
}

template <class Member, class Value>
Body with(Member member, const Value& value) {
  Body body;
  body.*member = value;
  return body;
}

}  // namespace

TEST_CASE("a mass that is negative or not finite is refused") {
  check_body_refused(with(&Body::mass, -2.5), "mass", {"-2.5"});
  check_body_refused(with(&Body::mass, NAN), "mass", {"nan"});
  check_body_refused(with(&Body::mass, INFINITY), "mass", {"inf"});
}

TEST_CASE("a body without mass and inertia is accepted") {
  Body body = with_moments(0, 0, 0);
  body.mass = 0.0;
  CHECK(Model().add_body("ghost", body) == 0);
}

TEST_CASE("inertia that is not finite, not symmetric or negative is refused") {
  check_body_refused(with_moments(NAN, 1, 1), "not_finite", {"inertia", "nan"});
  Body skewed;
  skewed.inertia(0, 1) = 0.1;
  check_body_refused(skewed, "inertia_not_symmetric", {"inertia"});
  check_body_refused(with_moments(1, -0.25, 1), "inertia_negative", {"-0.25"});
  Body indefinite;
  indefinite.inertia(0, 1) = indefinite.inertia(1, 0) = 1.5;
  check_body_refused(indefinite, "inertia_negative", {"-0.5"});
}

TEST_CASE("inertia against the triangle inequality is refused in any axes, a flat body is not") {
  check_body_refused(with_moments(1, 3, 1), "inertia_triangle", {"(1, 1, 3)"});
  Random random(30);
  const Mat3<double> A = random.frame();
  const auto turned = [&](double a, double b, double c) {
    const Mat3<double> J = A * Vec3<double>(a, b, c).asDiagonal() * A.transpose();
    return with(&Body::inertia, Mat3<double>(0.5 * (J + J.transpose())));
  };
  check_body_refused(turned(1, 3, 1), "inertia_triangle", {"(1, 1, 3)"});
  CHECK(Model().add_body("disk", turned(1, 2, 1)) == 0);
  CHECK(Model().add_body("rod", turned(0, 1, 1)) == 0);
}

TEST_CASE("an orientation that is not unit Euler parameters is refused") {
  check_body_refused(with(&Body::orientation, Vec4<double>(0, 0, 0, 0)), "orientation", {"(0, 0, 0, 0)", "norm 0"});
  check_body_refused(with(&Body::orientation, Vec4<double>(1, 1, 1, 1)), "orientation", {"(1, 1, 1, 1)", "norm 2"});
  check_body_refused(with(&Body::orientation, Vec4<double>(NAN, 0, 0, 0)), "not_finite", {"orientation", "nan"});
}

TEST_CASE("an orientation within 1e-6 of unit length is accepted and made unit") {
  Model model;
  model.add_body("a", with(&Body::orientation, Vec4<double>(1 + 1e-7, 0, 0, 0)));
  model.add_bodies("b", {with(&Body::orientation, Vec4<double>(1 + 1e-7, 0, 0, 0))});
  for (const Body& body : model.bodies()) CHECK(body.orientation.norm() == doctest::Approx(1.0).epsilon(1e-15));
}

TEST_CASE("a position or velocity that is not finite is refused") {
  check_body_refused(with(&Body::position, Vec3<double>(0, INFINITY, 0)), "not_finite", {"position", "(0, inf, 0)"});
  check_body_refused(with(&Body::velocity, Vec3<double>(0, NAN, 0)), "not_finite", {"velocity", "nan"});
  check_body_refused(with(&Body::omega, Vec3<double>(0, 0, -INFINITY)), "not_finite", {"omega", "-inf"});
}

TEST_CASE("gravity that is not finite is refused") { CHECK_THROWS_AS(Model(Vec3<double>(0, 0, NAN)), ModelError); }

TEST_CASE("names that are empty, taken or the ground's are refused") {
  check_refused([](Model& m) { m.add_body("", Body{}); }, "empty_name", {"body"});
  check_refused([](Model& m) { m.add_bodies("", {Body{}}); }, "empty_name", {"body"});
  check_refused([](Model& m) { m.add_body("ground", Body{}); }, "duplicate_name", {"ground"});
  check_refused([](Model& m) { m.add_body("rod", Body{}); }, "duplicate_name", {"body 'rod'"});
  check_refused([](Model& m) { m.add_body("link", Body{}); }, "duplicate_name", {"body 'link'"});
  check_refused([](Model& m) { m.add_body("link[1]", Body{}); }, "duplicate_name", {"body 'link[1]'"});
  check_refused([](Model& m) { m.add_bodies("rod", {Body{}}); }, "duplicate_name", {"body 'rod'"});
  check_refused([](Model& m) { m.add_joint("spherical", "pin", 0, 1, at_origins()); }, "duplicate_name",
                {"joint 'pin'"});
  check_refused([](Model& m) { m.add_joint("spherical", "", 0, 1, at_origins()); }, "empty_name", {"joint"});
  check_refused([](Model& m) { m.add_force("spring_damper", "spring", 0, 1, at_origins(), std::vector<Parameter>(4)); },
                "duplicate_name", {"force 'spring'"});
}

TEST_CASE("a group is refused where a single name is already one of its members'") {
  Model model;
  model.add_body("wheel[1]", Body{});
  CHECK_THROWS_AS(model.add_bodies("wheel", {Body{}, Body{}}), ModelError);
}

TEST_CASE("bodies, joints and forces may share a name") {
  Model model = small_model();
  CHECK(model.add_body("pin", Body{}) == 4);
  CHECK(model.add_joint("spherical", "spring", 0, 1, at_origins()) == 1);
}

TEST_CASE("a joint or force on a body that does not exist is refused") {
  for (const int body : {-2, 4, 1000}) {
    const std::string number = std::to_string(body);
    check_refused([&](Model& m) { m.add_joint("spherical", "new", 0, body, at_origins()); }, "unknown_body",
                  {"spherical 'new'", number});
    check_refused([&](Model& m) { m.add_joint("spherical", "new", body, 0, at_origins()); }, "unknown_body",
                  {"spherical 'new'", number});
    check_refused(
        [&](Model& m) { m.add_force("spring_damper", "new", body, 0, at_origins(), std::vector<Parameter>(4)); },
        "unknown_body", {"spring_damper 'new'", number});
  }
}

TEST_CASE("a joint of a body with itself is refused, the ground included") {
  check_refused([](Model& m) { m.add_joint("revolute", "new", 1, 1, at_origins()); }, "self_joint",
                {"revolute 'new'", "'rod'"});
  check_refused([](Model& m) { m.add_joint("revolute", "new", ground, ground, at_origins()); }, "self_joint",
                {"revolute 'new'", "'ground'"});
}

TEST_CASE("a joint whose place is not finite or whose axes are not a right-handed frame is refused") {
  const auto refused = [](auto change, const std::string& code) {
    Attachment<double> at = at_origins();
    change(at);
    check_refused([&](Model& m) { m.add_joint("revolute", "new", 0, 1, at); }, code, {"revolute 'new'"});
  };
  refused([](auto& at) { at.s_i[1] = NAN; }, "not_finite");
  refused([](auto& at) { at.s_j[2] = INFINITY; }, "not_finite");
  refused([](auto& at) { at.C_i(0, 0) = NAN; }, "not_finite");
  refused([](auto& at) { at.C_i.setZero(); }, "frame");
  refused([](auto& at) { at.C_j(0, 1) = 1e-6; }, "frame");
  refused([](auto& at) { at.C_j.col(2) *= -1; }, "frame");
}

TEST_CASE("a wrong number of parameters is refused") {
  check_refused([](Model& m) { m.add_joint("distance", "new", 0, 1, at_origins()); }, "parameters",
                {"distance 'new'", "1", "0"});
  check_refused([](Model& m) { m.add_joint("spherical", "new", 0, 1, at_origins(), {{1.0, -1}}); }, "parameters",
                {"spherical 'new'", "0", "1"});
  check_refused([](Model& m) { m.add_force("applied", "new", 0, 1, at_origins(), std::vector<Parameter>(5)); },
                "parameters", {"applied 'new'", "6", "5"});
}

TEST_CASE("a parameter that is not finite or an unknown function of time is refused") {
  check_refused([](Model& m) { m.add_joint("distance", "new", 0, 1, at_origins(), {{NAN, -1}}); }, "not_finite",
                {"distance 'new'", "length = nan"});
  check_refused([](Model& m) { m.add_joint("distance", "new", 0, 1, at_origins(), {{0.0, 2}}); }, "unknown_signal",
                {"distance 'new'", "length", "2"});
}

TEST_CASE("a function without derivatives is refused where derivatives enter, and only there") {
  check_refused([](Model& m) { m.add_joint("distance", "new", 0, 1, at_origins(), {{0.0, 1}}); }, "derivatives",
                {"distance 'new'", "length"});
  Model model = small_model();
  model.add_force("spring_damper", "actuator", 0, 1, at_origins(), {{1, -1}, {1, -1}, {1, -1}, {0, 1}});
  CHECK(model.forces().size() == 2);
}

TEST_CASE("an unknown kind is refused with a list of those there are") {
  check_refused<OptionError>([](Model& m) { m.add_joint("hinge", "new", 0, 1, at_origins()); }, "unknown_kind",
                             {"'hinge'", "revolute"});
  check_refused<OptionError>([](Model& m) { m.add_force("magnet", "new", 0, 1, at_origins(), {}); }, "unknown_kind",
                             {"'magnet'", "applied"});
}

TEST_CASE("a group of joints with one that is wrong is refused as a whole, naming that one") {
  const std::vector<Element> elements = {{0, 0, 1, at_origins(), 0}, {0, 1, 1, at_origins(), 0}};
  check_refused([&](Model& m) { m.add_joints("spherical", "new", elements, {}); }, "self_joint",
                {"spherical 'new[1]'"});
}

TEST_CASE("names are found by index and back, single ones and groups") {
  Model model = small_model();
  const std::vector<std::string> names = {"crank", "rod", "link[0]", "link[1]"};
  for (int body = 0; body < 4; ++body) {
    CHECK(model.body_name(body) == names[body]);
    CHECK(model.body_names().find(names[body]) == body);
  }
  CHECK(model.body_name(ground) == "ground");
  for (const char* unknown :
       {"", "link", "link[2]", "link[-1]", "link[x]", "link[]", "link[1", "rod[0]", "link[99999999999]"})
    CHECK(model.body_names().find(unknown) == -1);
}

TEST_CASE("an empty group has no members and its name is no body") {
  Model model;
  CHECK(model.add_bodies("link", {}) == 0);
  CHECK(model.body_names().size() == 0);
  CHECK(model.body_names().find("link") == -1);
  model.add_body("rod", Body{});
  CHECK(model.body_names().find("link") == -1);
  CHECK(model.body_name(0) == "rod");
}

TEST_CASE("rows are numbered joint by joint and described by joint and equation") {
  Model model = small_model();
  const Element element{0, 0, 1, at_origins(), 0};
  CHECK(model.add_joints("revolute", "hinge", {element, element}, {}) == 1);
  model.add_joint("distance", "rod", 0, 2, at_origins(), {{1.0, -1}});
  CHECK(model.joint_rows() == std::vector<int>{0, 3, 8, 13, 14});
  const std::vector<int> joints = {0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 3};
  for (int row = 0; row < 14; ++row) CHECK(model.joint_of_row(row) == joints[row]);
  CHECK(model.describe_row(0) == "spherical 'pin', translation x");
  CHECK(model.describe_row(12) == "revolute 'hinge[1]', rotation about joint x");
  CHECK(model.describe_row(13) == "distance 'rod', distance");
}

TEST_CASE("the parameters of each element are where first_parameter says") {
  Model model = small_model();
  const Element element{0, 0, 1, at_origins(), 0};
  model.add_joint("distance", "a", 0, 1, at_origins(), {{1.0, -1}});
  model.add_joints("distance", "b", {element, element}, {{2.0, -1}, {3.0, -1}});
  for (std::size_t k = 1; k <= 3; ++k)
    CHECK(model.joint_parameters()[model.joints()[k].first_parameter].constant == static_cast<double>(k));
}

TEST_CASE("initial q and v hold r, p and r_dot, omega body by body") {
  Random random(31);
  const Body a = random_body(random), b = random_body(random);
  Model model;
  model.add_bodies("body", {a, b});
  CHECK((model.initial_q().segment<3>(7) - b.position).norm() == 0.0);
  CHECK((model.initial_q().segment<4>(3) - a.orientation).norm() < 1e-15);
  CHECK((model.initial_v().segment<3>(6) - b.velocity).norm() == 0.0);
  CHECK((model.initial_v().segment<3>(3) - a.omega).norm() == 0.0);
}

TEST_CASE("principal moments that no real body has are taken where that is asked for, negative ones never") {
  linkwork::Model model;
  linkwork::Body body;
  body.inertia.diagonal() << 1.0, 1.0, 3.0;
  CHECK_THROWS_AS(model.add_body("a", body), linkwork::ModelError);
  body.inertia_as_is = true;
  CHECK(model.add_body("a", body) == 0);
  CHECK(model.bodies()[0].inertia(2, 2) == 3.0);
  body.inertia(0, 0) = -1.0;
  CHECK_THROWS_AS(model.add_body("b", body), linkwork::ModelError);
}
