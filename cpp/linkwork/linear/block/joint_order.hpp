#pragma once

#include <vector>

#include "linkwork/linear/block/number_lists.hpp"

namespace linkwork::block {

/// What is eliminated after the bodies, and the cliques that it forms: the joints on one body; a hub and one of its
/// joints.
struct JointGraph {
  std::vector<int> weight;  ///< rows of each joint; 6 for a hub
  std::vector<int> hub;     ///< of a joint that must follow a hub at once: that hub, else -1
  NumberLists cliques;
};

/// Nodes of the graph that are eliminated together: places [first, last) of the order, and the places that remain
/// coupled to them.
struct Supernode {
  int first, last;
  int parent;              ///< supernode, or -1
  std::vector<int> below;  ///< ascending
};

struct Elimination {
  std::vector<int> order;         ///< node at each place
  std::vector<int> supernode_of;  ///< of each place
  std::vector<Supernode> supernodes;
  std::vector<double> work;  ///< operations of each supernode, with a fixed cost for handling it
  double cost = 0.0;         ///< of all
};

/// A fill-reducing order of the nodes (minimum degree or nested dissection, whichever predicts fewer operations), and
/// its supernodes, small ones amalgamated.
Elimination order_joint_graph(const JointGraph& graph);
/// The same; `neighbors` are those in the graph.
Elimination order_joint_graph(const JointGraph& graph, const NumberLists& neighbors);

/// Of each node, ascending, without itself.
NumberLists neighbors_in(const JointGraph& graph);

}  // namespace linkwork::block
