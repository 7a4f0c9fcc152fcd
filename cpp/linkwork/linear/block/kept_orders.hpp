#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/linear/block/joint_order.hpp"

namespace linkwork::block {

/// Orders of elimination by their graphs. Of one mechanism the rank of its constraints and each factorization ask for
/// the order of much the same joints, which takes longer than the rest of their analysis: it is found once. An order is
/// taken again for a graph with the same neighbors, weights and hubs alone, on which it depends and on nothing else.
class KeptOrders {
 public:
  static constexpr std::size_t most = 3;  ///< graphs: with all rows, with redundant ones left out, and one for changes

  /// As order_joint_graph.
  std::shared_ptr<const Elimination> order(const JointGraph& graph);
  void forget();

 private:
  struct Found {
    NumberLists neighbors;
    std::vector<int> weight, hub;
    std::shared_ptr<const Elimination> elimination;
  };
  std::mutex mutex_;
  std::list<Found> found_;  ///< the last one asked for first
};

/// Those kept with a system.
KeptOrders& kept_orders(const System& system);
/// From here on `to`, with the same joints, has those of `from`. Before anything is ordered for it.
void share_orders(const System& from, const System& to);

}  // namespace linkwork::block
