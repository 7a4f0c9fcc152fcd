#pragma once

#include <vector>

namespace linkwork::block {

/// Joints and the cliques that they form on bodies.
struct JointGraph {
  std::vector<int> weight;                ///< rows of each joint
  std::vector<std::vector<int>> cliques;  ///< joints that share a body
};

/// Joints that are eliminated together: places [first, last) of the order, and the places that remain coupled to them.
struct Supernode {
  int first, last;
  int parent;              ///< supernode, or -1
  std::vector<int> below;  ///< ascending
};

struct Elimination {
  std::vector<int> order;         ///< joint at each place
  std::vector<int> supernode_of;  ///< of each place
  std::vector<Supernode> supernodes;
};

/// A fill-reducing order of the joints (minimum degree or nested dissection, whichever predicts fewer operations), and
/// its supernodes, small ones amalgamated.
Elimination order_joint_graph(const JointGraph& graph);

}  // namespace linkwork::block
