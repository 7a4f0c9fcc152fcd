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

void KeptOrders::forget() {
  const std::lock_guard lock(mutex_);
  found_.clear();
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
