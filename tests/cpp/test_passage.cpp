#include "linkwork/integration/passage.hpp"

#include "support.hpp"

using namespace linkwork;

namespace {

/// Along a branch, across it, and in the direction in which it bends.
VectorXd vector(double along, double across, double bent = 0.0) {
  return (VectorXd(3) << along, across, bent).finished();
}

Passage begun(const VectorXd& v) {
  Passage passage;
  passage.begin(1.0, vector(0, 0), v, 0.01);
  return passage;
}

}  // namespace

TEST_CASE("velocities that turn off with accelerations along themselves have left the branch") {
  const Passage passage = begun(vector(0.1, 0));
  CHECK(passage.left_branch(vector(0, 0.1), vector(0, 3)));
  CHECK(passage.left_branch(vector(0, -0.5, 0.02), vector(0, 3, 0.25)));
  CHECK(!passage.left_branch(vector(-0.5, 0, 0.02), vector(-3, 0, 0.25)));
  CHECK(!passage.left_branch(vector(0.1, 0.02), vector(0, 0)));
}

TEST_CASE("those that accelerations have turned have not, nor those of rest") {
  CHECK(!begun(vector(0.1, 0)).left_branch(vector(0.1, 0.5), vector(0, 3)));
  CHECK(!begun(vector(0, 0)).left_branch(vector(0, 0.1), vector(0, 3)));
  CHECK(!begun(vector(1e-6, 0)).left_branch(vector(0, 0.1), vector(0, 3)));
}

TEST_CASE("velocities differ by the branch where half of them does") {
  CHECK(Passage::differ(vector(0.1, 0), vector(0, 0.1)));
  CHECK(!Passage::differ(vector(0.1, 0.04), vector(0.1, 0)));
  CHECK(!Passage::differ(vector(0, 0), vector(0, 0)));
}

TEST_CASE("a passage is over when the motion has come away from the pose") {
  Passage passage;
  CHECK(!passage.over());
  passage = begun(vector(0.1, 0));
  passage.begin(1.5, vector(0, 0), vector(0, 1), 0.0);  // it is the first that counts
  passage.go_on(1.1, 0.4);
  CHECK(!passage.over());
  passage.go_on(1.2, 0.4);
  CHECK(passage.over());
  passage.forget();
  CHECK(!passage.over());
}
