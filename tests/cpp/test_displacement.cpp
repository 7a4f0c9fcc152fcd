#include "linkwork/constraints/displacement.hpp"

#include "mechanisms.hpp"

using namespace support;

namespace {

System bodies(Random& random) { return System(random_chain(random, 4, "spherical")); }

}  // namespace

TEST_CASE("a displacement is a translation and a rotation about an axis in the body") {
  Random random(21);
  const System system = bodies(random);
  const VectorXd q = system.model().initial_q(), x = random.vector(system.v_size(), 1.5);
  VectorXd found = q;
  displace(system, x, found);
  CHECK(relative_error(found, moved(q, x, VectorXd::Zero(x.size()), 1.0)) < 1e-14);
  for (int body = 0; body < 4; ++body) CHECK(std::abs(found.segment<4>(7 * body + 3).norm() - 1.0) < 1e-15);
}

TEST_CASE("there and back again is no displacement") {
  Random random(22);
  const System system = bodies(random);
  const VectorXd q = system.model().initial_q(), x = random.vector(system.v_size());
  VectorXd found = q;
  displace(system, x, found);
  displace(system, -x, found);
  CHECK(relative_error(found, q) < 1e-14);
}

TEST_CASE("small displacements are N(q) x") {
  Random random(23);
  const System system = bodies(random);
  const VectorXd q = system.model().initial_q(), x = random.vector(system.v_size());
  VectorXd rates(system.q_size());
  system.position_rates(q, x, rates);
  const auto displaced = [&](double s) {
    VectorXd out = q;
    displace(system, s * x, out);
    return out;
  };
  CHECK(relative_error(first_difference(displaced, 1e-3), rates) < 1e-10);
}
