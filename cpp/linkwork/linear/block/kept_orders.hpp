#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/linear/block/joint_order.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"

namespace linkwork::block {

/// Orders of elimination by their graphs. Of one mechanism the rank of its constraints and each factorization ask for
/// the order of much the same joints, which takes longer than the rest of their analysis: it is found once. An order is
/// taken again for a graph with the same neighbors, weights and hubs alone, on which it depends and on nothing else.
///
/// Of small systems, of which factorizations take no longer than their analysis, all of it is kept: choices of
/// redundant rows are compared with each other in turn.
class KeptOrders {
 public:
  static constexpr std::size_t most = 3;  ///< graphs: with all rows, with redundant ones left out, and one for changes
  static constexpr std::size_t most_analyses = 6;
  static constexpr int small = 50;  ///< bodies

  /// As order_joint_graph.
  std::shared_ptr<const Elimination> order(const JointGraph& graph);
  /// For one thread, of a system with these joints. Arguments as of SymbolicFactorization.
  std::shared_ptr<const SymbolicFactorization> analysis(const System& system, const std::vector<int>& dropped,
                                                        int compliant_from, bool grounded);
  void forget();

 private:
  struct Found {
    NumberLists neighbors;
    std::vector<int> weight, hub;
    std::shared_ptr<const Elimination> elimination;
  };
  struct Analysis {
    std::vector<ConstraintBlock> blocks;
    std::ptrdiff_t row_of_zeros;
    std::vector<int> dropped;
    int compliant_from;
    bool grounded;
    std::shared_ptr<const SymbolicFactorization> symbolic;
  };
  std::mutex mutex_;
  std::list<Found> found_;  ///< the last one asked for first
  std::list<Analysis> analyses_;
};

/// Those kept with a system.
KeptOrders& kept_orders(const System& system);
/// From here on `to`, with the same joints, has those of `from`. Before anything is ordered for it.
void share_orders(const System& from, const System& to);

}  // namespace linkwork::block
