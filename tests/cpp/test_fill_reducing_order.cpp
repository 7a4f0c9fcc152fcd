#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "linkwork/linear/block/fill_reducing_order.hpp"
#include "support.hpp"

using namespace support;
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

std::vector<int> fill_reducing_order(const NumberLists& graph) {
  return linkwork::block::fill_reducing_order(graph, std::vector<int>(graph.size(), 1));
}

/// Of a dense elimination that knows which entries are zero.
double operations(std::vector<std::set<int>> graph, const std::vector<int>& weight, const std::vector<int>& order) {
  double sum = 0.0;
  for (const int node : order) {
    const std::set<int> own = graph[node];
    double r = 0.0;
    const double w = weight[node];
    for (const int a : own) {
      r += weight[a];
      graph[a].erase(node);
      for (const int b : own)
        if (b != a) graph[a].insert(b);
    }
    sum += w * w * w / 3.0 + w * r * (w + r);
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

TEST_CASE("of small graphs with weights the order is nearly the best of all") {
  Random random(211);
  for (int trial = 0; trial < 30; ++trial) {
    const int n = 7;
    std::vector<std::set<int>> graph(n);
    std::vector<int> weight;
    for (int k = 0; k < n; ++k) weight.push_back(random.integer(1, 6));
    for (int k = 0; k < 10; ++k)
      if (const int a = random.integer(0, n - 1), b = random.integer(0, n - 1); a != b) couple(graph, a, b);
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    double least = INFINITY;
    do least = std::min(least, operations(graph, weight, order));
    while (std::next_permutation(order.begin(), order.end()));
    const std::vector<int> found = linkwork::block::fill_reducing_order(lists_of(graph), weight);
    CHECK(operations(graph, weight, found) <= 1.15 * least);
  }
}

TEST_CASE(
    "a sheet of five-point stars takes half of what dissection takes of one of nine points, 829 / 84 n^3 (A. George, "
    "1973)") {
  for (const int n : {40, 80}) {
    const std::vector<int> order = fill_reducing_order(lists_of(grid(n)));
    CHECK(is_permutation(order, static_cast<std::size_t>(n * n)));
    const double half = 0.5 * operations(grid(n), std::vector<int>(static_cast<std::size_t>(n * n), 1), order);
    CHECK(half <= 0.5 * 829.0 / 84.0 * n * n * n);
  }
}
