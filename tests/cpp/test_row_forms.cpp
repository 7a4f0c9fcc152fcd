#include <doctest/doctest.h>

#include <algorithm>

#include "linkwork/ensemble/row_forms.hpp"

#include "support.hpp"

using namespace support;

namespace {

/// D of one joint of a kind between two bodies at a random state, first the rows of one body and then of the other.
VectorXd random_D(const KindInfo& info, Random& random) {
  Model model;
  for (const char* name : {"a", "b"}) model.add_body(name, random_body(random));
  std::vector<Parameter> parameters;
  for (const ParameterInfo& it : info.parameters) parameters.push_back({it.value.example, -1});
  model.add_joint(info.name, "joint", 0, 1, random_attachment(random), parameters);
  const Evaluation at = evaluate_initially(System(model));
  return Eigen::Map<const VectorXd>(at.D.data(), 12 * Eigen::Index{info.rows});
}

bool has_form(const Vec3<double>& translation, RowForm form) {
  if (form == RowForm::general) return true;
  Vec3<double> expected = Vec3<double>::Zero();
  if (form != RowForm::rotation) expected[static_cast<int>(form) - static_cast<int>(RowForm::x)] = 1.0;
  return translation.cwiseAbs() == expected;
}

}  // namespace

TEST_CASE("rows of D have the form of their kind in every state") {
  Random random(7);
  for (int kind = 0; kind < static_cast<int>(joint_kinds().size()); ++kind) {
    const KindInfo& info = joint_kinds()[kind].info;
    CAPTURE(info.name);
    const std::vector<RowForm> forms = row_forms(kind);
    REQUIRE(static_cast<int>(forms.size()) == 2 * info.rows);
    for (int state = 0; state < 20; ++state) {
      const VectorXd D = random_D(info, random);
      for (int row = 0; row < 2 * info.rows; ++row) CHECK(has_form(D.segment<3>(6 * row), forms[row]));
    }
  }
}

TEST_CASE("a hinge holds a point along the axes of space, and two rotations") {
  using enum RowForm;
  const std::vector<RowForm> hinge = {x, y, z, rotation, rotation, x, y, z, rotation, rotation};
  CHECK((row_forms(joint_kind_index("revolute")) == hinge));
}

TEST_CASE("kinds that say that they hold a point do, and those that do say it") {
  Random random(8);
  for (const JointKind& kind : joint_kinds()) {
    CAPTURE(kind.info.name);
    bool holds = true;
    for (int state = 0; state < 20; ++state) {
      const VectorXd D = random_D(kind.info, random);
      for (int row = 0; row < kind.info.rows; ++row) {
        const Vec3<double> expected = row < 3 ? Vec3<double>(Vec3<double>::Unit(row)) : Vec3<double>::Zero();
        holds = holds && D.segment<3>(6 * row) == expected && D.segment<3>(6 * (kind.info.rows + row)) == -expected;
      }
    }
    CHECK(kind.holds_point == (holds && kind.info.rows >= 3));
  }
}

TEST_CASE("kinds that say that they slide hold two shifts and all rotations, and those that do say it") {
  Random random(9);
  for (const JointKind& kind : joint_kinds()) {
    CAPTURE(kind.info.name);
    bool slides = kind.info.rows == 5;
    for (int state = 0; slides && state < 20; ++state) {
      const VectorXd D = random_D(kind.info, random);
      for (int row = 0; row < 10; ++row) slides = slides && (D.segment<3>(6 * row).norm() > 0.1) == (row % 5 < 2);
    }
    CHECK(kind.slides == slides);
  }
}

TEST_CASE("a slider moves along an axis of its own") {
  const std::vector<RowForm> forms = row_forms(joint_kind_index("translational"));
  CHECK(std::count(forms.begin(), forms.end(), RowForm::general) == 4);
  CHECK(std::count(forms.begin(), forms.end(), RowForm::rotation) == 6);
}
