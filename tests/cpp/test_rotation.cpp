#include <doctest/doctest.h>

#include <numbers>

#include "support.hpp"

using namespace support;

TEST_CASE("A(p) is a rotation for p of any length") {
  Random random(1);
  for (const double length : {1e-3, 0.9, 1.0, 7.0}) {
    const Mat3<double> A = rotation_matrix<double>(length * random.unit_quaternion());
    CHECK((A.transpose() * A - Mat3<double>::Identity()).norm() < 1e-14);
    CHECK(A.determinant() == doctest::Approx(1.0).epsilon(1e-14));
  }
}

TEST_CASE("A(p) turns by the angle about the axis that p encodes") {
  const double angle = 0.7;
  const Mat3<double> A = rotation_matrix<double>({std::cos(angle / 2), 0.0, 0.0, std::sin(angle / 2)});
  Mat3<double> expected;
  expected << std::cos(angle), -std::sin(angle), 0, std::sin(angle), std::cos(angle), 0, 0, 0, 1;
  CHECK((A - expected).norm() < 1e-15);
}

TEST_CASE("A(a b) = A(a) A(b)") {
  Random random(2);
  for (int k = 0; k < 20; ++k) {
    const Vec4<double> a = random.vector(4), b = random.vector(4);
    const Mat3<double> product = rotation_matrix<double>(a) * rotation_matrix<double>(b);
    CHECK((rotation_matrix<double>(quaternion_product<double>(a, b)) - product).norm() < 1e-14);
  }
}

TEST_CASE("skew(a) b = a x b") {
  Random random(3);
  const Vec3<double> a = random.vec3(), b = random.vec3();
  CHECK((skew<double>(a) * b - a.cross(b)).norm() < 1e-16);
}

TEST_CASE("A_dot = A omega~ along p_dot = N(p) omega, also where p is not a unit vector") {
  Random random(4);
  for (const double length : {0.6, 1.0, 1.3}) {
    const Vec4<double> p = length * random.unit_quaternion();
    const Vec3<double> omega = random.vec3(3.0);
    const Vec4<double> p_dot = euler_parameter_rates<double>(p, omega);
    const auto A = [&](double s) { return rotation_matrix<double>(p + s * p_dot); };
    const Mat3<double> A_dot = first_difference(A, 1e-3);
    CHECK(relative_error(A_dot, rotation_matrix<double>(p) * skew<double>(omega)) < 1e-9);
  }
}

TEST_CASE("the rates of p keep its length") {
  Random random(5);
  const Vec4<double> p = random.unit_quaternion();
  CHECK(std::abs(p.dot(euler_parameter_rates<double>(p, random.vec3()))) < 1e-16);
}

TEST_CASE("logarithm inverts exponential from tiny angles to near pi") {
  Random random(6);
  const double pi = std::numbers::pi;
  for (const double angle : {1e-300, 1e-12, 1e-8, 9.9e-5, 1.01e-4, 1e-3, 1.0, 3.0, pi - 1e-6, pi - 1e-12}) {
    const Vec3<double> phi = angle * random.vec3().normalized();
    const Vec3<double> back = logarithm(exponential(phi));
    INFO("angle ", angle, " comes back as ", back.norm());
    CHECK((back - phi).norm() <= 4e-16 * std::max(angle, 1e-290));
  }
}

TEST_CASE("exponential has unit length at every angle") {
  Random random(7);
  for (const double angle : {0.0, 1e-9, 9.9e-5, 1.01e-4, 0.1, 3.0, 50.0})
    CHECK(exponential(angle * random.vec3().normalized()).norm() == doctest::Approx(1.0).epsilon(1e-15));
}

TEST_CASE("logarithm of p and of -p are the same, at most pi long") {
  Random random(8);
  for (int k = 0; k < 20; ++k) {
    const Vec4<double> p = random.vector(4).normalized();
    CHECK((logarithm(p) - logarithm(-p)).norm() < 1e-15);
    CHECK(logarithm(p).norm() <= std::numbers::pi);
  }
}
