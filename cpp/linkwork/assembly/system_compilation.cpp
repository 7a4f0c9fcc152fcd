// A Model made into flat arrays: masses, joints, forces, and the history that a motion begins with.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>

#include "linkwork/assembly/system.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork {
namespace {

constexpr double singular_moment = 1e-14;   // principal moment, relative to the largest
constexpr std::size_t many_forces = 4096;   // from here on threads share them
constexpr std::ptrdiff_t cached = 1 << 22;  // doubles of D that may still be in a cache when they are read, 32 MB

/// Fills `begin` and `list` so that list[begin[k] .. begin[k+1]) holds the blocks whose key is k, in order.
template <class Key>
void group_blocks(const std::vector<ConstraintBlock>& blocks, int groups, Key key, std::vector<int>& list,
                  std::vector<int>& begin) {
  begin.assign(groups + 1, 0);
  for (const ConstraintBlock& block : blocks) begin[key(block) + 1] += 1;
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  list.resize(blocks.size());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (std::size_t b = 0; b < blocks.size(); ++b) list[next[key(blocks[b])]++] = static_cast<int>(b);
}

Mat3<double> inverse(const Mat3<double>& J) {
  return J.isDiagonal(0.0) ? Mat3<double>(J.diagonal().cwiseInverse().asDiagonal()) : Mat3<double>(J.inverse());
}

/// The inverse on the range of J, zero on its kernel (bodies without inertia).
Mat3<double> pseudo_inverse(const Mat3<double>& J, bool& singular) {
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> eigen(J);
  const Vec3<double> moments = eigen.eigenvalues();
  singular = moments[0] <= singular_moment * moments[2] || moments[2] <= 0.0;
  if (!singular) return inverse(J);
  Vec3<double> inverse = Vec3<double>::Zero();
  for (int k = 0; k < 3; ++k)
    if (moments[k] > singular_moment * moments[2] && moments[2] > 0.0) inverse[k] = 1.0 / moments[k];
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

std::size_t count_elements(const std::vector<ForceBatch>& batches) {
  return std::accumulate(batches.begin(), batches.end(), std::size_t{0},
                         [](std::size_t sum, const ForceBatch& batch) { return sum + batch.size(); });
}

void append_joint(const Model& model, int joint, int row, std::ptrdiff_t D, JointBatch& batch) {
  const Element& element = model.joints()[joint];
  batch.append(joint, element.i, element.j, model.joint_parameters().data() + element.first_parameter,
               joint_info(element.kind).parameters.size());
  batch.attach(element.at);
  batch.row.push_back(row);
  batch.D.push_back(D);
}

void append_block(const ConstraintBlock& block, std::vector<ConstraintBlock>& blocks) {
  if (block.body != ground) blocks.push_back(block);
}

}  // namespace

System::System(const Model& model, const InstructionSet& instructions)
    : model_(model),
      instructions_(instructions),
      body_forces_(body_forces(evaluation_for(static_cast<int>(model.bodies().size()), instructions))),
      inerters_(model_, 0) {
  compile_masses();
  compile_joints();
  inerters_ = Inerters(model_, D_size_);
  D_size_ += inerters_.D_size();
  coordinates_ = ElementCoordinates(model_, inerters_, D_size_ + velocity_size, instructions);
  compile_forces();
  begin_history();
}

void System::compile_masses() {
  mass_.resize(model_.bodies().size());
  for (std::size_t k = 0; k < mass_.size(); ++k) {
    const Body& body = model_.bodies()[k];
    bool singular = false;
    const Mat3<double> inverse_inertia = pseudo_inverse(body.inertia, singular);
    Eigen::Map<Mat3<double>>(mass_[k].J) = body.inertia;
    mass_[k].m = body.mass;
    if (!singular && body.mass > 0.0) continue;
    massless_.push_back(static_cast<int>(k));
    massless_inverses_.push_back(inverse_inertia);
  }
}

/// Found anew each time: of a large model few are asked for, and they would take a tenth of its memory.
Mat3<double> System::inverse_inertia(int body) const {
  if (massless_.empty()) return inverse(inertia(body));
  const auto found = std::lower_bound(massless_.begin(), massless_.end(), body);
  if (found == massless_.end() || *found != body) return inverse(inertia(body));
  return massless_inverses_[static_cast<std::size_t>(found - massless_.begin())];
}

void System::append_kind(int kind, int count) {
  const JointKind& it = joint_kinds()[kind];
  const InstructionSet instructions = evaluation_for(count, instructions_);
  joints_.push_back({.evaluate = it.evaluate[instructions.level],
                     .reactions = joint_reactions(instructions),
                     .rows = it.info.rows,
                     .holds_point = it.holds_point,
                     .width = instructions.width,
                     .batch = {}});
  JointBatch& batch = joints_.back().batch;
  batch.reserve(count, it.info.parameters.size(), instructions.width);
  batch.row.reserve(count);
  batch.D.reserve(count);
}

void System::compile_joints() {
  std::vector<int> count(joint_kinds().size(), 0);
  std::vector<std::size_t> place(joint_kinds().size(), 0);
  for (const Element& element : model_.joints())
    if (static_cast<std::size_t>(element.kind) < count.size()) count[element.kind] += 1;
  for (std::size_t kind = 0; kind < count.size(); ++kind) {
    if (count[kind] == 0) continue;
    place[kind] = joints_.size();
    append_kind(static_cast<int>(kind), count[kind]);
  }
  blocks_.reserve(2 * model_.joints().size());
  for (int joint = 0; joint < joint_count(); ++joint) {
    const Element& element = model_.joints()[joint];
    if (const SpecialJoint* special = model_.special_joint(joint)) {
      compile_special_joint(joint, *special);
      continue;
    }
    const int row = model_.joint_rows()[joint], rows = joint_info(element.kind).rows;
    append_joint(model_, joint, row, D_size_, joints_[place[element.kind]].batch);
    const std::ptrdiff_t D_j = D_size_ + velocity_size * rows;
    append_block({.joint = joint, .body = element.i, .row = row, .rows = rows, .offset = D_size_}, blocks_);
    append_block({.joint = joint, .body = element.j, .row = row, .rows = rows, .offset = D_j}, blocks_);
    D_size_ += 2 * velocity_size * rows;
  }
  for (CompiledJoints& kind : joints_) {
    kind.batch.fill_up();
    kind.batch.streamed = D_size_ > cached;
    for (int first = 0, count = static_cast<int>(kind.batch.size()); first < count; first += chunk)
      joint_chunks_.push_back({&kind, kind.batch.joints(first, std::min(first + chunk, count))});
  }
  list_driven_rows();
  group_blocks(
      blocks_, joint_count(), [](const ConstraintBlock& b) { return b.joint; }, joint_block_list_, joint_block_begin_);
  group_blocks(
      blocks_, body_count(), [](const ConstraintBlock& b) { return b.body; }, body_block_list_, body_block_begin_);
}

void System::compile_special_joint(int joint, const SpecialJoint& special) {
  const Element& element = model_.joints()[joint];
  const KindInfo& info = joint_info(element.kind);
  const int row = model_.joint_rows()[joint];
  special_joints_.push_back(
      {.special = &special, .joint = joint, .row = row, .rows = info.rows, .D = D_size_, .history = history_size()});
  add_history(special.history_kind(), true, joint, special.history_size());
  most_bodies_ = std::max(most_bodies_, special.bodies().size());
  for (const int body : special.bodies()) {
    if (body != ground)
      blocks_.push_back({.joint = joint, .body = body, .row = row, .rows = info.rows, .offset = D_size_});
    D_size_ += velocity_size * info.rows;
  }
}

void System::list_driven_rows() {
  for (int joint = 0; joint < joint_count(); ++joint) {
    if (!model_.is_driven(joint)) continue;
    for (int row = model_.joint_rows()[joint]; row < model_.joint_rows()[joint + 1]; ++row) driven_rows_.push_back(row);
  }
}

void System::compile_forces() {
  begin_force_batches();
  for (std::size_t k = 0; k < model_.forces().size(); ++k) append_force(static_cast<int>(k));
  for (std::size_t k = 0; k < model_.joint_forces().size(); ++k) {
    const HistoryKind kind = model_.joint_forces()[k].history_kind();
    joint_force_history_.push_back(kind == HistoryKind::none ? -1 : history_size());
    add_history(kind, false, static_cast<int>(model_.forces().size() + k), kind == HistoryKind::none ? 0 : 1);
  }
  for (ForceBatch& batch : force_batches_) batch.fill_up();
  for (std::size_t kind = 0; kind < force_batches_.size(); ++kind)
    if (force_batches_[kind].size() > 0) force_kinds_in_use_.push_back(kind);
  list_posed_bodies();
  if (count_elements(force_batches_) >= many_forces) place_wrenches();
}

void System::begin_force_batches() {
  std::vector<int> count(force_kinds().size(), 0);
  for (const Element& element : model_.forces())
    if (!force_kinds()[element.kind].inertia) count[element.kind] += 1;
  force_batches_.resize(count.size());
  for (std::size_t kind = 0; kind < count.size(); ++kind) {
    const InstructionSet instructions = evaluation_for(count[kind], instructions_);
    force_levels_.push_back(instructions.level);
    force_batches_[kind].reserve(count[kind], force_kinds()[kind].info.parameters.size(),
                                 evaluated_one_by_one(kind) ? 1 : instructions.width);
  }
}

bool System::evaluated_one_by_one(std::size_t kind) const { return !force_kinds()[kind].packs[force_levels_[kind]]; }

void System::append_force(int force) {
  const Element& element = model_.forces()[force];
  const ForceKind& kind = force_kinds()[element.kind];
  if (kind.inertia) return;
  ForceBatch& batch = force_batches_[element.kind];
  batch.append(force, element.i, element.j, model_.force_parameters().data() + element.first_parameter,
               kind.info.parameters.size());
  if (const int row = coordinates_.row(force); row >= 0) {
    batch.row.push_back(row);
    batch.D.push_back(coordinates_.place(row));
  } else if (evaluated_one_by_one(element.kind)) {
    batch.attachment.push_back(element.at);
  } else {
    batch.attach(element.at);
  }
  batch.history.push_back(history_size());
  batch.switches.push_back(static_cast<std::ptrdiff_t>(switches_.size()));
  const int contact = kind.history == HistoryKind::onset ? history_size() : -1;
  switches_.insert(switches_.end(), kind.switches, contact);
  add_history(kind.history, false, force, kind.history == HistoryKind::none ? 0 : 1);
}

void System::list_posed_bodies() {
  std::vector<char> acted_on(body_count(), 0);
  for (std::size_t kind = 0; kind < force_batches_.size(); ++kind)
    if (evaluated_one_by_one(kind))
      for (const std::vector<int>* bodies : {&force_batches_[kind].body_i, &force_batches_[kind].body_j})
        for (const int body : *bodies)
          if (body != ground) acted_on[body] = 1;
  for (int body = 0; body < body_count(); ++body)
    if (acted_on[body]) posed_bodies_.push_back(body);
}

/// Of each body the wrenches that elements apply to it, in the order in which one thread adds them up.
void System::place_wrenches() {
  body_wrench_begin_.assign(body_count() + 1, 0);
  const auto visit = [&](const auto& see) {
    int element = 0;
    for (const ForceBatch& batch : force_batches_)
      for (std::size_t k = 0; k < batch.size(); ++k, ++element) {
        if (batch.body_i[k] != ground) see(batch.body_i[k], 2 * element);
        if (batch.body_j[k] != ground) see(batch.body_j[k], 2 * element + 1);
      }
  };
  visit([&](int body, int) { body_wrench_begin_[body + 1] += 1; });
  std::partial_sum(body_wrench_begin_.begin(), body_wrench_begin_.end(), body_wrench_begin_.begin());
  body_wrench_list_.resize(body_wrench_begin_.back());
  std::vector<int> next(body_wrench_begin_.begin(), body_wrench_begin_.end() - 1);
  visit([&](int body, int wrench) { body_wrench_list_[next[body]++] = wrench; });
  for (const ForceBatch& batch : force_batches_)
    called_alone_.push_back(std::any_of(batch.parameters.begin(), batch.parameters.end(), [&](const Parameter& it) {
      return it.signal >= 0 && !model_.signals()[it.signal]->of_time();
    }));
}

void System::add_history(HistoryKind kind, bool joint, int element, int count) {
  history_owners_.insert(history_owners_.end(), count, {kind, joint, element});
}

std::string System::history_element(int variable) const {
  const HistoryOwner& owner = history_owners_[variable];
  if (owner.joint) return model_.joint_name(owner.element);
  if (const auto k = static_cast<std::size_t>(owner.element); k >= model_.forces().size())
    return model_.joint_forces()[k - model_.forces().size()].name;
  return model_.force_names().name(owner.element);
}

std::string System::history_name(int variable) const {
  return (history_owners_[variable].joint ? "joint '" : "force '") + history_element(variable) + "'";
}

void System::begin_history() {
  initial_history_ = blank_history();
  if (initial_history_.size() == 0) return;
  const std::vector<double>& given = model_.initial_history();
  if (!given.empty() && std::ssize(given) != history_size())
    throw ModelError("history", "the initial state of the model has " + std::to_string(given.size()) +
                                    " history variables, but its springs, stops, contacts and couplers have " +
                                    std::to_string(history_size()) +
                                    ": set the initial state after all of them are there");
  if (!given.empty()) initial_history_ = Eigen::Map<const VectorXd>(given.data(), history_size());
  if (special_joints_.empty()) return;
  Evaluation at = make_evaluation();
  at.history = initial_history_;
  evaluate_constraints(0.0, model_.initial_q(), VectorXd::Zero(v_size()), initial_history_, at);
  initial_history_ = at.history;
}

/// Nothing is known of the past.
VectorXd System::blank_history() const {
  VectorXd out(history_size());
  for (int k = 0; k < history_size(); ++k)
    out[k] = history_owners_[k].joint ? std::numeric_limits<double>::quiet_NaN() : 0.0;
  return out;
}

Evaluation System::make_evaluation() const {
  Evaluation out;
  InterruptionMeter meter;  // it is memory that is touched first here, which takes as long as an evaluation
  if (!posed_bodies_.empty()) out.bodies.assign(body_count(), BodyState<double>::ground());
  out.signals.resize(model_.signals().size());
  out.D.assign(D_size_ + velocity_size + coordinates_.D_size(), 0.0);
  meter.add(body_count());
  out.special.resize(most_bodies_);
  if (!body_wrench_begin_.empty()) out.wrenches.resize(wrench_size * count_elements(force_batches_));
  out.potentials.resize((body_count() + chunk - 1) / chunk);
  for (VectorXd* variables : {&out.history, &out.history_rate}) variables->setZero(history_size());
  out.switches.setZero(static_cast<Eigen::Index>(switches_.size()));
  for (VectorXd* rows : {&out.Phi, &out.Phi_t, &out.Phi_dot, &out.gamma}) rows->setZero(row_count());
  for (VectorXd* each : {&out.coordinate_gamma, &out.coordinates, &out.coordinate_rates})
    each->setZero(static_cast<Eigen::Index>(coordinates_.count()));
  out.g.setZero(v_size() + velocity_size);
  meter.add(body_count());
  return out;
}

MatrixXd System::massless_directions(int body) const {
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> eigen(inertia(body));
  const Vec3<double> moments = eigen.eigenvalues();
  MatrixXd kernel(6, 0);
  const auto append = [&](int first_row, const Vec3<double>& direction) {
    kernel.conservativeResize(6, kernel.cols() + 1);
    kernel.rightCols<1>().setZero();
    kernel.rightCols<1>().segment<3>(first_row) = direction;
  };
  for (int k = 0; k < 3; ++k) {
    if (mass(body) == 0.0) append(0, Vec3<double>::Unit(k));
    if (moments[k] <= singular_moment * moments[2] || moments[2] <= 0.0) append(3, eigen.eigenvectors().col(k));
  }
  return kernel;
}

}  // namespace linkwork
