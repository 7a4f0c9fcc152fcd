#include "linkwork/model/name_table.hpp"

#include <doctest/doctest.h>

#include "linkwork/math/error.hpp"

using namespace linkwork;

TEST_CASE("find is the inverse of name, for names one by one and for groups") {
  NameTable table("body");
  table.add("crank");
  table.add_group("link", 1000);
  table.add(Names(std::vector<std::string>{"rocker", "rod"}), 2);
  REQUIRE(table.size() == 1003);
  for (int index = 0; index < table.size(); ++index) REQUIRE(table.find(table.name(index)) == index);
  CHECK(table.name(1) == "link[0]");
  CHECK(table.name(1000) == "link[999]");
  CHECK(table.find("rod") == 1002);
}

TEST_CASE("what is no name is not found") {
  NameTable table("body");
  table.add_group("link", 10);
  for (const char* name :
       {"", "link", "link[10]", "link[-1]", "link[01]", "link[-0]", "link[3", "link[3]x", "chain[3]"})
    CHECK(table.find(name) == -1);
}

TEST_CASE("a name is given once, also where a group would repeat it") {
  NameTable table("body");
  table.add("rod");
  table.add("link[2]");
  CHECK_THROWS_AS(table.add("rod"), ModelError);
  CHECK_THROWS_AS(table.add(""), ModelError);
  CHECK_THROWS_AS(table.add_group("link", 3), ModelError);
  CHECK_THROWS_AS(table.add(Names(std::vector<std::string>{"new", "rod"}), 2), ModelError);
  CHECK_THROWS_AS(table.add(Names(std::vector<std::string>{"new", "bar[5]", "new"}), 3), ModelError);
  CHECK(table.size() == 2);  // all of them, or none
  CHECK(table.find("new") == -1);
  CHECK_NOTHROW(table.add_group("bar", 6));
  CHECK_NOTHROW(table.add_group("link", 2));
}
