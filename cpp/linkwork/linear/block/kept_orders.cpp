#include "linkwork/linear/block/kept_orders.hpp"

#include <algorithm>

namespace linkwork::block {

std::shared_ptr<const Elimination> KeptOrders::order(const JointGraph& graph) {
  NumberLists neighbors = neighbors_in(graph);
  const std::lock_guard lock(mutex_);
  const auto same = [&](const Found& it) {
    return it.weight == graph.weight && it.hub == graph.hub && it.neighbors == neighbors;
  };
  if (const auto it = std::find_if(found_.begin(), found_.end(), same); it != found_.end()) {
    found_.splice(found_.begin(), found_, it);
    return it->elimination;
  }
  const auto elimination = std::make_shared<const Elimination>(order_joint_graph(graph, neighbors));
  found_.push_front({std::move(neighbors), graph.weight, graph.hub, elimination});
  if (found_.size() > most) found_.pop_back();
  return elimination;
}

std::shared_ptr<const SymbolicFactorization> KeptOrders::analysis(const System& system, const std::vector<int>& dropped,
                                                                  int compliant_from, bool grounded) {
  const auto make = [&] {
    return std::make_shared<const SymbolicFactorization>(
        system, dropped, compliant_from, std::vector<SymbolicFactorization::DelayedPivot>(), false, grounded);
  };
  if (system.body_count() > small) return make();
  const auto same = [&](const Analysis& it) {
    return it.grounded == grounded && it.compliant_from == compliant_from && it.dropped == dropped &&
           it.row_of_zeros == system.row_of_zeros() && it.blocks == system.blocks();
  };
  {
    const std::lock_guard lock(mutex_);
    if (const auto it = std::find_if(analyses_.begin(), analyses_.end(), same); it != analyses_.end()) {
      analyses_.splice(analyses_.begin(), analyses_, it);
      return it->symbolic;
    }
  }
  auto symbolic = make();  // which asks for orders
  const std::lock_guard lock(mutex_);
  analyses_.push_front({system.blocks(), system.row_of_zeros(), dropped, compliant_from, grounded, symbolic});
  if (analyses_.size() > most_analyses) analyses_.pop_back();
  return symbolic;
}

void KeptOrders::forget() {
  const std::lock_guard lock(mutex_);
  found_.clear();
  analyses_.clear();
}

namespace {

using Share = std::shared_ptr<KeptOrders>;

const Share& share_of(const System& system) {
  return system.kept().get<Share>([] { return std::make_shared<KeptOrders>(); });
}

}  // namespace

KeptOrders& kept_orders(const System& system) { return *share_of(system); }

void share_orders(const System& from, const System& to) {
  const Share shared = share_of(from);
  to.kept().get<Share>([&] { return shared; });
}

}  // namespace linkwork::block
