#include "linkwork/ensemble/lane_structure.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/ensemble/row_forms.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/linear/block/block_solver.hpp"
#include "linkwork/model/force_kind.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

constexpr int widest_front = 512;  // see lane_loops.hpp

/// Where D_i of a joint on two bodies is.
std::ptrdiff_t place_of_D(const System& system, int joint, const Element& element) {
  const ConstraintBlock& block = system.blocks()[*system.joint_blocks(joint).begin()];
  return block.body == element.i ? block.offset : block.offset - velocity_size * block.rows;
}

bool same_elements(const std::vector<Element>& a, const std::vector<Element>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Element& one, const Element& other) {
    return one.kind == other.kind && one.i == other.i && one.j == other.j;
  });
}

/// Of the joints, and of inerters as rows behind those, at their place in D.
std::vector<ConstraintBlock> blocks_of(const System& system) {
  std::vector<ConstraintBlock> out = system.blocks();
  const Inerters& inerters = system.inerters();
  std::ptrdiff_t D = system.row_of_zeros() - inerters.D_size();
  for (std::size_t k = 0; k < inerters.count(); ++k)
    for (const int body : inerters.bodies(k)) {
      const int row = system.row_count() + static_cast<int>(k);
      if (body != ground) out.push_back({.joint = -1, .body = body, .row = row, .rows = 1, .offset = D});
      D += velocity_size;
    }
  return out;
}

/// As the block solver does, which is given inerters as joints with compliance.
block::SymbolicFactorization factorize_symbolically(const Dynamics& dynamics) {
  const System& system = dynamics.system();
  if (system.inerters().empty()) return block::SymbolicFactorization(system, dynamics.dropped().rows());
  return block::SymbolicFactorization(System(Inerters::as_joints(system.model())), dynamics.dropped().rows(),
                                      system.row_count());
}

}  // namespace

LaneStructure::LaneStructure(const Dynamics& dynamics)
    : bodies(dynamics.system().body_count()),
      rows(dynamics.system().row_count()),
      inerters(static_cast<int>(dynamics.system().inerters().count())),
      inerter_D(dynamics.system().row_of_zeros() - dynamics.system().inerters().D_size()),
      inerter_D_size(dynamics.system().inerters().D_size()),
      D_size(dynamics.system().row_of_zeros() + velocity_size + dynamics.system().element_coordinates().D_size()),
      time_dependent(dynamics.system().time_dependent_constraints()),
      with_ballast(dynamics.formulation().takes_small_inertias()),
      symbolic(factorize_symbolically(dynamics)),
      blocks(blocks_of(dynamics.system())),
      joint_blocks(std::ssize(dynamics.system().blocks())),
      component_count(ConnectedComponents::of(dynamics.system()).count()),
      coordinates(static_cast<std::ptrdiff_t>(dynamics.system().element_coordinates().count())),
      history_size(dynamics.system().history_size()),
      switch_count(static_cast<int>(dynamics.system().switches().size())),
      dropped(dynamics.dropped().rows()),
      elements_(dynamics.system().model().joints()) {
  for (int body = 0; body < bodies; ++body)
    components.push_back(ConnectedComponents::of(dynamics.system()).of_body(body));
  find_positions(dynamics.system());
  list_joints(dynamics.system());
  find_forms();
  coordinate_rows = coordinates_of(dynamics.system());
  list_forces(dynamics.system());
  for (const int row : dropped)
    for (const ConstraintBlock& block : blocks)
      if (block.row <= row && row < block.row + block.rows)
        dropped_D.push_back(block.offset + velocity_size * (row - block.row));
}

void LaneStructure::find_positions(const System& system) {
  for (const block::CoreBody& body : symbolic.bodies)
    for (int v = body.first_vector; v < body.first_vector + body.vectors; ++v)
      for (int l = 0; l < block::lanes; ++l)
        if (symbolic.vectors[v].D[l] != system.row_of_zeros())
          row_positions.push_back(symbolic.vectors[v].position + l);
}

void LaneStructure::list_joints(const System& system) {
  std::vector<int> place(joint_kinds().size(), -1);
  for (int joint = 0; joint < system.joint_count(); ++joint) {
    const Element& element = elements_[joint];
    if (system.model().special_joint(joint)) {
      special.push_back(joint);
      continue;
    }
    if (place[element.kind] < 0) {
      place[element.kind] = static_cast<int>(joints.size());
      joints.push_back({element.kind, {}, {}, {}, {}, {}});
    }
    Joints& all = joints[place[element.kind]];
    all.joint.push_back(joint);
    all.body_i.push_back(element.i == ground ? ~bodies : element.i);
    all.body_j.push_back(element.j == ground ? ~bodies : element.j);
    all.row.push_back(system.model().joint_rows()[joint]);
    all.D.push_back(place_of_D(system, joint, element));
  }
}

void LaneStructure::find_forms() {
  std::vector<RowForm> forms(D_size / velocity_size, RowForm::general);
  for (const Joints& it : joints) {
    const std::vector<RowForm> found = linkwork::row_forms(it.kind);
    for (const std::ptrdiff_t D : it.D) std::copy(found.begin(), found.end(), forms.begin() + D / velocity_size);
  }
  for (const block::BodyRow& row : symbolic.rows) row_forms.push_back(forms[row.D / velocity_size]);
}

std::vector<LaneStructure::CoordinateRows> LaneStructure::coordinates_of(const System& system) const {
  std::vector<CoordinateRows> out;
  for (const ElementCoordinates::Rows& it : system.element_coordinates().rows())
    out.push_back({it.kind, it.valued, it.batch.number, places_of(it.batch.body_i, it.batch.size()),
                   places_of(it.batch.body_j, it.batch.size()), it.batch.row, it.batch.D});
  return out;
}

/// Of the first `count` bodies, the ground behind the others.
std::vector<int> LaneStructure::places_of(const std::vector<int>& list, std::size_t count) const {
  std::vector<int> out(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count));
  std::replace(out.begin(), out.end(), ground, bodies);
  return out;
}

void LaneStructure::list_forces(const System& system) {
  for (std::size_t kind = 0; kind < system.force_batches().size(); ++kind)
    if (const ForceBatch& batch = system.force_batches()[kind]; batch.size() > 0)
      forces.push_back({static_cast<int>(kind), places_of(batch.body_i, batch.size()),
                        places_of(batch.body_j, batch.size()), batch.history, batch.switches, batch.row, batch.D});
}

bool LaneStructure::same_forces(const System& system) const {
  if (system.history_size() != history_size) return false;
  auto next = forces.begin();
  for (std::size_t kind = 0; kind < system.force_batches().size(); ++kind) {
    const ForceBatch& batch = system.force_batches()[kind];
    if (batch.size() == 0) continue;
    if (next == forces.end() || next->kind != static_cast<int>(kind) ||
        next->body_i != places_of(batch.body_i, batch.size()) ||
        next->body_j != places_of(batch.body_j, batch.size()) || next->history != batch.history ||
        next->row != batch.row)
      return false;
    ++next;
  }
  return next == forces.end();
}

bool LaneStructure::same(const Dynamics& dynamics) const {
  const System& system = dynamics.system();
  if (system.body_count() != bodies || !same_elements(system.model().joints(), elements_)) return false;
  if (system.time_dependent_constraints() != time_dependent || dynamics.dropped().rows() != dropped) return false;
  if (dynamics.formulation().takes_small_inertias() != with_ballast) return false;
  if (static_cast<int>(system.inerters().count()) != inerters || blocks_of(system) != blocks) return false;
  return coordinates_of(system) == coordinate_rows && same_forces(system);
}

bool LaneStructure::keeps_order(const Dynamics& dynamics, double pivot) const {
  if (symbolic.hubs.empty() && !symbolic.grounded()) return true;
  return pivot >= symbolic.breakdown() && !dynamics.formulation().saddle().reordered();
}

std::string LaneStructure::refusal_of_numbers(const Dynamics& dynamics) {
  const Options& options = dynamics.options();
  const System& system = dynamics.system();
  if (!options.deterministic) return "lanes have the bits of deterministic runs only";
  if (!formulation_info(options.formulation).lanes || !linear_solver_info(options.linear_solver).lanes)
    return "lanes have formulation 'standard' by linear solver 'block' only";
  if (std::isfinite(options.violation_limit[2])) return "lanes do not watch a violation_limit of accelerations";
  const auto trusted = [](const auto& force) { return force->trusted(); };
  const auto& forces = system.model().user_forces();
  if (!std::all_of(forces.begin(), forces.end(), trusted))
    return "it has a user force that was found to be another one beside other mechanisms than by itself";
  return "";
}

std::string LaneStructure::refusal(const Dynamics& dynamics) {
  if (std::string why = refusal_of_numbers(dynamics); !why.empty()) return why;
  if (dynamics.unconnected()) return "";
  const block::SymbolicFactorization symbolic = factorize_symbolically(dynamics);
  if (symbolic.widest_front > widest_front) return "its loops are too large";
  return "";
}

}  // namespace linkwork
