#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "linkwork/linear/block/fill_reducing_order.hpp"
#include "support.hpp"

using namespace support;
using linkwork::block::fill_reducing_order;
using linkwork::block::NumberLists;

namespace {

NumberLists lists_of(const std::vector<std::set<int>>& neighbors) {
  NumberLists out;
  for (const std::set<int>& own : neighbors) out.add(std::vector<int>(own.begin(), own.end()));
  return out;
}

void couple(std::vector<std::set<int>>& graph, int a, int b) {
  graph[a].insert(b);
  graph[b].insert(a);
}

std::vector<std::set<int>> grid(int n) {
  std::vector<std::set<int>> graph(n * n);
  for (int k = 0; k < n * n; ++k) {
    if (k % n + 1 < n) couple(graph, k, k + 1);
    if (k + n < n * n) couple(graph, k, k + n);
  }
  return graph;
}

/// Entries below the diagonal of the factor.
std::size_t entries(std::vector<std::set<int>> graph, const std::vector<int>& order) {
  std::size_t sum = 0;
  for (const int node : order) {
    const std::set<int> own = graph[node];
    sum += own.size();
    for (const int a : own) {
      graph[a].erase(node);
      for (const int b : own)
        if (b != a) graph[a].insert(b);
    }
  }
  return sum;
}

bool is_permutation(std::vector<int> order, std::size_t n) {
  std::sort(order.begin(), order.end());
  for (std::size_t k = 0; k < order.size(); ++k)
    if (order[k] != static_cast<int>(k)) return false;
  return order.size() == n;
}

}  // namespace

TEST_CASE("a tree is eliminated without fill") {
  Random random(210);
  std::vector<std::set<int>> tree(300);
  for (int k = 1; k < 300; ++k) couple(tree, k, random.integer(0, k - 1));
  const std::vector<int> order = fill_reducing_order(lists_of(tree));
  CHECK(is_permutation(order, 300));
  CHECK(entries(tree, order) == 299);
}

TEST_CASE("a grid fills up much less than in its natural order, which has about n^3 entries") {
  const int n = 40;
  const std::vector<int> order = fill_reducing_order(lists_of(grid(n)));
  CHECK(is_permutation(order, static_cast<std::size_t>(n * n)));
  CHECK(entries(grid(n), order) < static_cast<std::size_t>(n * n * n / 2));
}

TEST_CASE("graphs may fall apart, or have no edges at all") {
  std::vector<std::set<int>> graph = grid(24);
  const std::vector<std::set<int>> same = graph;
  for (int copy = 1; copy < 3; ++copy)
    for (const std::set<int>& own : same) {
      graph.emplace_back();
      for (const int k : own) graph.back().insert(k + copy * 24 * 24);
    }
  CHECK(is_permutation(fill_reducing_order(lists_of(graph)), graph.size()));
  const std::vector<std::set<int>> alone(1500);
  CHECK(is_permutation(fill_reducing_order(lists_of(alone)), 1500));
  CHECK(fill_reducing_order(NumberLists{}).empty());
}
