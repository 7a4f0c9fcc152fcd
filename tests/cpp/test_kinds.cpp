#include <set>

#include "linkwork/math/error.hpp"
#include "support.hpp"

using namespace support;

TEST_CASE("every kind is found by its name, and no two have the same") {
  std::set<std::string> names;
  for (std::size_t k = 0; k < joint_kinds().size(); ++k) {
    const KindInfo& info = joint_kinds()[k].info;
    INFO(info.name);
    CHECK(joint_kind_index(info.name) == static_cast<int>(k));
    CHECK(names.insert(info.name).second);
    CHECK(std::ssize(info.equations) == info.rows);
  }
  for (std::size_t k = 0; k < force_kinds().size(); ++k) {
    CHECK(force_kind_index(force_kinds()[k].info.name) == static_cast<int>(k));
    CHECK(names.insert(force_kinds()[k].info.name).second);
    CHECK(force_kinds()[k].info.rows == 0);
  }
}

TEST_CASE("a kind that does not exist is refused with those that do") {
  CHECK(error_code([] { joint_kind_index("revolut"); }) == "unknown_kind");
  CHECK_THROWS_WITH_AS(force_kind_index("sprung"), doctest::Contains("spring_damper"), OptionError);
}

TEST_CASE("a kind with more parameters or rows than an evaluation holds is found when it is registered") {
  JointKind kind{};
  kind.info.name = "many";
  kind.info.rows = 6;
  kind.info.parameters.resize(max_joint_parameters);
  CHECK_NOTHROW(checked(kind));
  kind.info.parameters.resize(max_joint_parameters + 1);
  CHECK_THROWS_WITH(checked(kind), "joint kind 'many' has 9 parameters, more than max_joint_parameters = 8");
  kind.info.parameters.clear();
  for (const int rows : {0, 7}) {
    kind.info.rows = rows;
    CHECK_THROWS_WITH(checked(kind), ("joint kind 'many' has " + std::to_string(rows) +
                                      " rows, but two bodies have 1 to 6 that can differ")
                                         .c_str());
  }
}
