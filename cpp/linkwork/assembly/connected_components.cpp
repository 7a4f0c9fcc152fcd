#include "linkwork/assembly/connected_components.hpp"

#include <numeric>

namespace linkwork {
namespace {

/// Disjoint sets of bodies, each with a representative.
class DisjointSets {
 public:
  explicit DisjointSets(int count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  int find(int k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }
  void unite(int i, int j) { parent_[find(i)] = find(j); }

 private:
  std::vector<int> parent_;
};

}  // namespace

ConnectedComponents::ConnectedComponents(const System& system, Edges edges)
    : of_body_(system.body_count()), of_row_(system.row_count(), 0) {
  DisjointSets sets(system.body_count());
  for (int joint = 0; joint < system.joint_count(); ++joint)
    for (const int index : system.joint_blocks(joint))
      sets.unite(system.blocks()[index].body, system.blocks()[*system.joint_blocks(joint).begin()].body);
  for (std::size_t k = 0; k < system.inerters().count(); ++k)
    if (const auto [i, j] = system.inerters().bodies(k); i != ground && j != ground) sets.unite(i, j);
  if (edges == Edges::forces_too)
    for (const Element& force : system.model().forces())
      if (force.i != ground && force.j != ground) sets.unite(force.i, force.j);
  std::vector<int> number(system.body_count(), -1);
  for (int body = 0; body < system.body_count(); ++body) {
    int& own = number[sets.find(body)];
    if (own < 0) own = count_++;
    of_body_[body] = own;
  }
  for (const ConstraintBlock& block : system.blocks())
    for (int r = 0; r < block.rows; ++r) of_row_[block.row + r] = of_body_[block.body];
}

const ConnectedComponents& ConnectedComponents::of(const System& system) {
  return system.kept().get<ConnectedComponents>([&] { return ConnectedComponents(system); });
}

const ConnectedParts& ConnectedParts::of(const System& system) {
  return system.kept().get<ConnectedParts>([&] { return ConnectedParts(system); });
}

int ConnectedParts::of_history(const System& system, Eigen::Index variable) const {
  const HistoryOwner& owner = system.history_owners()[static_cast<std::size_t>(variable)];
  const Model& model = system.model();
  const auto part = [this](const auto& element) { return of_bodies(element.i, element.j); };
  if (owner.joint) return part(model.joints()[owner.element]);
  const int forces = static_cast<int>(model.forces().size());
  return owner.element < forces ? part(model.forces()[owner.element])
                                : part(model.joint_forces()[owner.element - forces]);
}

}  // namespace linkwork
