#include "linkwork/linear/block/core_elimination.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <utility>

#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

constexpr int none = -1;

std::ptrdiff_t padded(std::ptrdiff_t count) { return (count + lanes - 1) / lanes * lanes; }

/// Memory of contribution blocks over their lifetimes: freed places of about the same size are used again, by the same
/// task or, in a later stage, by any.
class ContributionAllocator {
 public:
  void end_task() { freed_in_stage_.merge(free_); }
  void end_stage() { idle_.merge(freed_in_stage_); }
  std::ptrdiff_t allocate(std::ptrdiff_t size) {
    size = std::max<std::ptrdiff_t>(size, lanes);  // places are known by where they begin
    for (Places* places : {&free_, &idle_})
      if (const auto found = places->lower_bound(size); found != places->end() && found->first <= 2 * size) {
        const std::ptrdiff_t place = found->second;
        taken_[place] = found->first;
        places->erase(found);
        return place;
      }
    const std::ptrdiff_t place = total_;
    taken_[place] = size;
    total_ += size;
    return place;
  }
  void release(std::ptrdiff_t place) {
    const auto found = taken_.find(place);
    free_.emplace(found->second, place);
    taken_.erase(found);
  }
  std::ptrdiff_t total() const { return total_; }

 private:
  using Places = std::multimap<std::ptrdiff_t, std::ptrdiff_t>;  // by size
  Places free_, freed_in_stage_, idle_;
  std::map<std::ptrdiff_t, std::ptrdiff_t> taken_;
  std::ptrdiff_t total_ = 0;
};

/// Joints that share a body with this many others make it a hub where that takes fewer operations, ...
constexpr std::size_t joints_of_a_hub = 8;
/// ... and this many in any case: their pairs alone would be too many.
constexpr std::size_t joints_of_a_large_hub = 1000;

class CoreBuilder {
 public:
  CoreBuilder(const System& system, const PrunedLeaves& pruned, const std::vector<int>& slot,
              const EliminatedRows& rows, const std::vector<SymbolicFactorization::DelayedPivot>& delayed,
              const CoreOptions& options, SymbolicFactorization& out)
      : system_(system), slot_(slot), rows_(rows), delayed_(delayed), out_(out) {
    if (options.grounded) find_ground_joints(pruned);
    for (int joint = 0; joint < system.joint_count(); ++joint)
      if (!pruned.joints[joint] && !is_on_ground(joint)) joints_.push_back(joint);
    if (joints_.empty()) return;
    choose_order();
    place_bodies();
    append_fronts();
    connect();
    out_.front_plan = plan_work({.parent = std::move(parents_), .work = work_, .keeps = true}, options.for_threads);
    place_contributions();
    out_.contribution_size = contributions_.total();
  }

 private:
  /// The nodes of the elimination: joints of the core by their place in `joints_`, then hubs.
  struct Order {
    std::vector<int> hubs;      ///< bodies
    std::vector<int> hub_node;  ///< per body, or none
    std::shared_ptr<const Elimination> elimination;
    double cost = 0.0;
  };

  /// The hinge or slider on the ground that each body is eliminated with: the first of its joints that can be. A body
  /// with many joints may become a hub.
  void find_ground_joints(const PrunedLeaves& pruned) {
    ground_block_.assign(system_.body_count(), none);
    for (int body = 0; body < system_.body_count(); ++body) {
      const BlockRange blocks = system_.body_blocks(body);
      if (blocks.end() - blocks.begin() >= std::ptrdiff_t{joints_of_a_hub}) continue;
      for (const int index : blocks) {
        const int joint = system_.blocks()[index].joint;
        if (ground_block_[body] == none && !pruned.joints[joint] && holds_on_ground(joint)) ground_block_[body] = index;
      }
    }
  }

  bool holds_on_ground(int joint) const {
    const BlockRange blocks = system_.joint_blocks(joint);
    const bool whole = rows_.count(joint) == ground_rows && first_row(joint + 1) - first_row(joint) == ground_rows;
    return whole && rows_.next(joint) == none && blocks.end() - blocks.begin() == 1 &&
           (rows_.turning(joint) || rows_.slides(joint));
  }

  const ConstraintBlock* ground_joint(int body) const {
    return ground_block_.empty() || ground_block_[body] == none ? nullptr : &system_.blocks()[ground_block_[body]];
  }
  bool is_on_ground(int joint) const {
    const BlockRange blocks = system_.joint_blocks(joint);
    if (blocks.end() - blocks.begin() != 1) return false;
    const ConstraintBlock* block = ground_joint(system_.blocks()[*blocks.begin()].body);
    return block && block->joint == joint;
  }

  int first_row(int joint) const { return system_.model().joint_rows()[joint]; }
  int joint_count() const { return static_cast<int>(joints_.size()); }
  bool is_hub(int node) const { return node >= joint_count(); }
  int hub_body(int node) const { return order_.hubs[node - joint_count()]; }
  int rows_of(int node) const { return is_hub(node) ? 6 : rows_.count(joints_[node]); }
  int node_at(int position) const { return order_.elimination->order[position]; }
  int rows_at(int position) const { return rows_of(node_at(position)); }
  int position_of(int node) const { return position_[node]; }

  void choose_order() {
    core_index_.assign(system_.joint_count(), none);
    for (std::size_t k = 0; k < joints_.size(); ++k) core_index_[joints_[k]] = static_cast<int>(k);
    std::vector<int> candidates;
    std::size_t most = 0;
    for (int body = 0; body < system_.body_count(); ++body) {
      const std::size_t joints = core_joints(body).size();
      if (joints >= joints_of_a_hub) candidates.push_back(body);
      most = std::max(most, joints);
    }
    if (most <= joints_of_a_large_hub) order_ = order_with({});
    if (!candidates.empty()) {
      Order mixed = order_with(std::move(candidates));
      if (most > joints_of_a_large_hub || !delayed_.empty() || mixed.cost < 0.7 * order_.cost)
        order_ = std::move(mixed);
    }
    const std::vector<int>& order = order_.elimination->order;
    position_.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) position_[order[k]] = static_cast<int>(k);
  }

  Order order_with(std::vector<int> hubs) const {
    look_for_interruption();
    Order out;
    out.hubs = std::move(hubs);
    out.hub_node.assign(system_.body_count(), none);
    JointGraph graph;
    for (const int joint : joints_) graph.weight.push_back(rows_.count(joint));
    for (const int body : out.hubs) {
      out.hub_node[body] = static_cast<int>(graph.weight.size());
      graph.weight.push_back(6);
    }
    graph.hub.assign(graph.weight.size(), none);
    for (int body = 0; body < system_.body_count(); ++body) {
      std::vector<int> clique = core_joints(body);
      if (const int node = out.hub_node[body]; node != none) {
        for (const int joint : clique) {
          graph.cliques.add({{node, joint}});
          if (only_on_hubs(joints_[joint], out)) graph.hub[joint] = node;
        }
      } else if (!clique.empty()) {
        const double rows = std::accumulate(clique.begin(), clique.end(), 0.0,
                                            [&](double sum, int joint) { return sum + graph.weight[joint]; });
        out.cost += ground_joint(body) ? 36.0 * rows + rows * rows : 36.0 * rows + 6.0 * rows * rows;
        graph.cliques.add(clique);
      }
    }
    for (const SymbolicFactorization::DelayedPivot& it : delayed_)
      graph.hub[core_index_[rows_.host(it.joint)]] = out.hub_node[it.hub];
    out.elimination = kept_orders(system_).order(graph);
    out.cost += out.elimination->cost;
    return out;
  }

  /// Nothing is eliminated before such a joint that it could pivot on.
  bool only_on_hubs(int joint, const Order& order) const {
    for (const int index : system_.joint_blocks(joint))
      if (order.hub_node[system_.blocks()[index].body] == none) return false;
    return true;
  }

  /// The joints in loops on a body, as nodes; attached ones are none.
  std::vector<int> core_joints(int body) const {
    std::vector<int> out;
    for (const int index : system_.body_blocks(body)) {
      const int core = core_index_[system_.blocks()[index].joint];
      if (core != none) out.push_back(core);
    }
    return out;
  }

  /// Each body but hubs stands before the supernode of its first joint.
  void place_bodies() {
    bodies_of_.resize(order_.elimination->supernodes.size());
    for (int body = 0; body < system_.body_count(); ++body) {
      if (order_.hub_node[body] != none) continue;
      int first = none;
      for (const int node : core_joints(body))
        if (first == none || position_of(node) < first) first = position_of(node);
      if (first != none) bodies_of_[supernode_of(first)].push_back(body);
    }
  }

  int supernode_of(int position) const { return order_.elimination->supernode_of[position]; }

  void append_fronts() {
    const std::size_t count = order_.elimination->supernodes.size();
    place_.resize(order_.elimination->order.size());
    for (std::size_t s = 0; s < count; ++s) {
      constexpr double handling = 1000.0;  // as in joint_order
      const double before = out_.flops;
      append_joints(static_cast<int>(s));
      Front& front = out_.fronts.back();
      front.first_body = static_cast<int>(out_.bodies.size());
      front.bodies = static_cast<int>(bodies_of_[s].size());
      for (const int body : bodies_of_[s]) append_body(body, front);
      work_.push_back(out_.flops - before + handling);
    }
  }

  /// Into a front whose joints have their `place_`.
  void append_body(int body, const Front& front) {
    CoreBody out{};
    out.body = body;
    out.slot = slot_[body];
    out.mass_factor = out.slot == none ? out_.mass_factor_count++ : none;
    if (out.slot != none) {
      out.own_factors = out_.factor_size;
      out_.factor_size += own_factor_size;
    }
    append_ground_joint(out);
    out.first_vector = static_cast<int>(out_.vectors.size());
    out.first_run = static_cast<int>(out_.runs.size());
    out.first_row = static_cast<int>(out_.rows.size());
    std::vector<std::pair<int, int>> blocks;  // (place of the joint, block)
    for (const int index : system_.body_blocks(body)) {
      const int core = core_index_[system_.blocks()[index].joint];
      if (core != none) blocks.emplace_back(place_[position_of(core)], index);
    }
    std::sort(blocks.begin(), blocks.end());
    for (const auto& [place, index] : blocks) {
      int position = place;
      rows_.for_blocks_on(body, system_.blocks()[index].joint, [&](const ConstraintBlock& block) {
        for (int k = 0; k < block.rows; ++k) {
          if (rows_.is_dropped(block.row + k)) continue;
          append_row(out, front, position++, block.offset + 6 * k);
          out_.rows.push_back({block.offset + 6 * k, block.row + k});
        }
      });
    }
    out.vectors = static_cast<int>(out_.vectors.size()) - out.first_vector;
    out.runs = static_cast<int>(out_.runs.size()) - out.first_run;
    out.rows = static_cast<int>(out_.rows.size()) - out.first_row;
    const double square = (out.rows + 1.0) * (out.rows + 1.0);
    out_.flops += 72.0 + 36.0 * (out.rows + 1.0) + (out.grounded() ? 200.0 + square : 6.0 * square);
    out_.nonzeros += 21 + (out.grounded() ? 18 : 6 * out.rows);
    out_.bodies.push_back(out);
  }

  void append_ground_joint(CoreBody& body) {
    body.ground_row = none;
    const ConstraintBlock* block = ground_joint(body.body);
    if (!block) return;
    body.ground_row = block->row;
    body.ground_D = block->offset;
    body.slides = rows_.slides(block->joint);
    body.ground_factors = out_.factor_size;
    out_.factor_size += step_storage(block->rows);
  }

  /// Rows come in the order of their positions.
  void append_row(const CoreBody& body, const Front& front, int position, std::ptrdiff_t D) {
    const int base = position / lanes * lanes;
    const bool first = static_cast<int>(out_.vectors.size()) == body.first_vector;
    if (first || out_.vectors.back().position != base) {
      out_.vectors.push_back({base, {}});
      std::fill_n(out_.vectors.back().D, lanes, system_.row_of_zeros());
    }
    out_.vectors.back().D[position - base] = D;
    if (static_cast<int>(out_.runs.size()) > body.first_run && position != front.top) {
      RelativeIndices& run = out_.runs.back();
      if (run.parent_begin + run.length == position) {
        run.length += 1;
        return;
      }
    }
    const int vector = static_cast<int>(out_.vectors.size()) - 1 - body.first_vector;
    out_.runs.push_back({vector * lanes + position - base, position, 1});
  }

  void append_joints(int s) {
    const Supernode& supernode = order_.elimination->supernodes[s];
    Front front{};
    front.unknown = static_cast<std::ptrdiff_t>(out_.unknowns.size());
    for (int k = supernode.first; k < supernode.last; ++k) front.width += append_unknowns(k, 0, front.width);
    front.top = static_cast<int>(padded(front.width));
    for (const int k : supernode.below) front.size += append_unknowns(k, front.top, front.size);
    front.contribution_rows = static_cast<int>(padded(front.size));
    front.size += front.width;
    front.mixed = append_mixed(supernode);
    front.panel = out_.panel_size;
    out_.panel_size += (front.width + 2) * static_cast<std::ptrdiff_t>(front.stride());
    out_.highest_front = std::max(out_.highest_front, front.stride());
    out_.widest_front = std::max(out_.widest_front, front.width);
    const double w = front.width, r = front.size + 1.0 - w;
    out_.flops += w * w * w / 3.0 + w * w * r + w * r * r;
    out_.nonzeros += front.width * (front.width + 1) / 2 + front.width * (front.size - front.width);
    out_.fronts.push_back(front);
  }

  /// Those of the node that is eliminated at `k`, whose rows stand at `place` and after: how many they are.
  int append_unknowns(int k, int part, int place) {
    place_[k] = part + place;
    const int node = node_at(k);
    if (is_hub(node)) {
      for (int row = 0; row < 6; ++row) out_.unknowns.push_back(~(6 * hub_body(node) + row));
    } else {
      for (int joint = joints_[node]; joint != none; joint = rows_.next(joint))
        for (int row = first_row(joint); row < first_row(joint + 1); ++row)
          if (!rows_.is_dropped(row)) out_.unknowns.push_back(row);
    }
    return rows_of(node);
  }

  /// What a front has to do with hubs: place in `mixed`, or none.
  int append_mixed(const Supernode& supernode) {
    if (order_.hubs.empty()) return none;
    MixedFront mixed{static_cast<int>(out_.hubs.size()), 0, static_cast<int>(out_.couplings.size()), 0};
    std::vector<int> positions = supernode.below;
    for (int k = supernode.first; k < supernode.last; ++k) positions.push_back(k);
    std::map<int, int> place_of;  // of each node in the front
    for (const int k : positions) place_of[node_at(k)] = place_[k];
    const auto eliminates = [&](int node) { return position_of(node) < supernode.last; };
    for (const auto& [node, place] : place_of)
      if (is_hub(node)) {
        if (eliminates(node))
          out_.hubs.push_back({.body = hub_body(node), .slot = slot_[hub_body(node)], .position = place});
      } else {
        for (const int index : system_.joint_blocks(joints_[node])) {
          const ConstraintBlock& block = system_.blocks()[index];
          const auto hub = place_of.find(order_.hub_node[block.body]);
          if (hub != place_of.end() && (eliminates(node) || eliminates(hub->first))) {
            int position = place;
            rows_.for_blocks_on(block.body, block.joint, [&](const ConstraintBlock& it) {
              position = append_couplings(it, position, hub->second);
            });
          }
        }
      }
    mixed.hubs = static_cast<int>(out_.hubs.size()) - mixed.first_hub;
    mixed.couplings = static_cast<int>(out_.couplings.size()) - mixed.first_coupling;
    if (mixed.hubs == 0 && mixed.couplings == 0) return none;
    out_.mixed.push_back(mixed);
    return static_cast<int>(out_.mixed.size()) - 1;
  }

  /// Runs of rows between dropped ones; returns the position behind them.
  int append_couplings(const ConstraintBlock& block, int joint, int hub) {
    bool joined = false;
    for (int k = 0; k < block.rows; ++k) {
      if (rows_.is_dropped(block.row + k)) {
        joined = false;
        continue;
      }
      if (joined) out_.couplings.back().rows += 1;
      else out_.couplings.push_back({.joint = joint, .hub = hub, .rows = 1, .D = block.offset + 6 * k});
      joined = true;
      joint += 1;
    }
    return joint;
  }

  /// Parents, and runs of rows in them.
  void connect() {
    std::vector<char> begun(out_.fronts.size(), 0);
    for (std::size_t f = 0; f < out_.fronts.size(); ++f) {
      Front& front = out_.fronts[f];
      front.childless = !begun[f];
      const Supernode& supernode = order_.elimination->supernodes[f];
      front.parent = supernode.parent;
      parents_.push_back(front.parent);
      front.first_relative_indices = static_cast<int>(out_.relative_indices.size());
      if (const int p = front.parent; p != none) {
        front.begins_parent = !begun[p];
        begun[p] = 1;
        append_relative_indices(supernode.below, order_.elimination->supernodes[p], out_.fronts[p]);
      }
      front.relative_indices = static_cast<int>(out_.relative_indices.size()) - front.first_relative_indices;
    }
  }

  void place_contributions() {
    for (Stage& stage : out_.front_plan.stages) {
      for (Task& task : stage) {
        for (const NodeRange& range : task.ranges)
          for (int f = range.first; f < range.last; ++f) {
            place_contribution(out_.fronts[f], range.handing);
            if (range.handing != Handing::only && out_.fronts[f].stride() >= divisible_front)
              task.divisible += work_[f];
          }
        contributions_.end_task();
      }
      contributions_.end_stage();
    }
  }

  /// From where it is begun, by a child if there is one, until it is added to the parent's.
  void place_contribution(Front& front, Handing handing) {
    if (handing != Handing::only && front.childless)
      front.contribution = contributions_.allocate(contribution_size(front));
    if (handing == Handing::later) return;
    if (front.begins_parent)
      out_.fronts[front.parent].contribution = contributions_.allocate(contribution_size(out_.fronts[front.parent]));
    contributions_.release(front.contribution);
  }

  static std::ptrdiff_t contribution_size(const Front& front) {
    return static_cast<std::ptrdiff_t>(front.size - front.width) * front.contribution_rows;
  }

  void append_relative_indices(const std::vector<int>& below, const Supernode& parent, const Front& parent_front) {
    int row = 0, parent_row = 0, position = parent.first;
    auto next = parent.below.begin();
    const auto advance = [&] {  // to the next joint of the parent
      parent_row += rows_at(position);
      if (position + 1 < parent.last) position += 1;
      else position = next == parent.below.end() ? none : *next++;
    };
    bool joined = false;
    for (const int joint : below) {
      while (position != joint) {
        advance();
        joined = false;
      }
      const int rows = rows_at(joint);
      const bool below_width = parent_row >= parent_front.width;
      if (parent_row == parent_front.width) joined = false;
      if (joined) out_.relative_indices.back().length += rows;
      else
        out_.relative_indices.push_back(
            {row, parent_row + (below_width ? parent_front.top - parent_front.width : 0), rows});
      joined = true;
      row += rows;
      advance();
    }
  }

  const System& system_;
  const std::vector<int>& slot_;  ///< of articulated inertias, per body
  const EliminatedRows& rows_;
  const std::vector<SymbolicFactorization::DelayedPivot>& delayed_;
  SymbolicFactorization& out_;
  std::vector<int> ground_block_;  ///< the block of D, per body, or none; empty: of all
  std::vector<int> joints_, core_index_, position_;
  std::vector<int> place_;  ///< of each elimination in the front at hand: of its first row
  std::vector<std::vector<int>> bodies_of_;
  std::vector<int> parents_;  ///< of fronts
  std::vector<double> work_;
  Order order_;
  ContributionAllocator contributions_;
};

}  // namespace

void eliminate_core(const System& system, const PrunedLeaves& pruned, const std::vector<int>& slot,
                    const EliminatedRows& rows, const std::vector<SymbolicFactorization::DelayedPivot>& delayed,
                    const CoreOptions& options, SymbolicFactorization& out) {
  CoreBuilder(system, pruned, slot, rows, delayed, options, out);
}

}  // namespace linkwork::block
