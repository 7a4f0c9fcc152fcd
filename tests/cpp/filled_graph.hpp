#pragma once

#include <Eigen/Core>
#include <vector>

#include "linkwork/linear/block/joint_order.hpp"

namespace support {

/// Structure of the factor in an order, by dense elimination.
inline Eigen::MatrixXi filled(const linkwork::block::JointGraph& graph, const std::vector<int>& order) {
  const int nodes = static_cast<int>(order.size());
  std::vector<int> place(nodes);
  for (int k = 0; k < nodes; ++k) place[order[k]] = k;
  Eigen::MatrixXi fill = Eigen::MatrixXi::Zero(nodes, nodes);
  for (std::size_t c = 0; c < graph.cliques.size(); ++c)
    for (const int a : graph.cliques[c])
      for (const int b : graph.cliques[c]) fill(place[a], place[b]) = 1;
  for (int k = 0; k < nodes; ++k)
    for (int a = k + 1; a < nodes; ++a)
      for (int b = k + 1; b < nodes; ++b) fill(a, b) |= fill(a, k) & fill(k, b);
  return fill;
}

}  // namespace support
