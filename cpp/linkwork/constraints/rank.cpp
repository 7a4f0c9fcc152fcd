#include "linkwork/constraints/rank.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/consistent_pose.hpp"
#include "linkwork/constraints/constraint_kernel.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/constraints/row_selection.hpp"
#include "linkwork/linear/column_rank.hpp"
#include "linkwork/math/names.hpp"

namespace linkwork {
namespace {

constexpr double assembled = 1e-13;  // |Phi|, relative to the size, below which a pose needs no correction
constexpr double residual_margin = 10.0, coarsest = 1e-6;
constexpr std::size_t joints_in_text = 8;
constexpr double by_digits = 1e-3, few_rows = 30.0;  // what rounding makes of a mechanism that has so many at most

Places complement(const Places& places, int count) {
  Places out;
  auto next = places.begin();
  for (int k = 0; k < count; ++k) {
    if (next != places.end() && *next == k) ++next;
    else out.push_back(k);
  }
  return out;
}

/// The kernel by its values at the redundant rows, and where that leaves a singular matrix (a dead center) at the
/// singular ones, too.
std::unique_ptr<ConstraintKernel> make_kernel(MassWeightedLeastSquares& solver, const ClosedLoops& loops,
                                              Evaluation& at, const RankReport& report) {
  std::vector<int> rows = report.redundant_rows;
  auto kernel = std::make_unique<ConstraintKernel>(solver, loops, at, rows);
  if (kernel->regular() || report.singular_rows.empty()) return kernel;
  kernel.reset();
  rows.insert(rows.end(), report.singular_rows.begin(), report.singular_rows.end());
  return std::make_unique<ConstraintKernel>(solver, loops, at, rows);
}

/// Per component of the loops: 6 per body less the rank.
std::vector<int> degrees_of_freedom(const System& system, const ClosedLoops& loops, const Places& dependent) {
  std::vector<int> out(loops.component_count(), 0);
  const auto add = [&](int component, int count) { out[component] += count; };
  for (int body = 0; body < system.body_count(); ++body)
    if (const int component = loops.component_of_body(body); component >= 0) add(component, velocity_size);
  for (int place = 0; place < loops.row_count(); ++place) add(loops.component_of_row(place), -1);
  for (const int place : dependent) add(loops.component_of_row(place), 1);
  return out;
}

/// What is left of each row of Phi, relative to the size of the mechanism.
VectorXd residuals(const System& system, const Evaluation& at) {
  return at.Phi.cwiseQuotient(row_lengths(system, at)).cwiseAbs();
}

/// The least tolerance that does not tell errors of the given geometry from its rank: joints that are off by a little
/// can be assembled but for a residual, and singular values of that size mean nothing.
double tolerance_of_geometry(const System& system, const ClosedLoops& loops, const Evaluation& at) {
  const VectorXd left = residuals(system, at);
  double most = 0.0;
  for (const int row : loops.rows()) most = std::max(most, left[row]);
  return std::min(residual_margin * most, coarsest);
}

/// Fills in which joints have reactions that the motion does not tell: those with rows in a kernel of D^T at either
/// pose. Where all have some at the perturbed one, as in planar mechanisms, the assembled one has nothing to add.
void find_unique(MassWeightedLeastSquares& solver, const ClosedLoops& loops, Evaluation& assembled,
                 Evaluation& perturbed, RankReport& report) {
  std::vector<char> members(loops.row_count(), 0);
  const auto note = [&] {
    for (int place = 0; place < loops.row_count(); ++place)
      if (members[place]) report.unique[loops.joint_of_row(place)] = 0;
  };
  const auto kernel = make_kernel(solver, loops, perturbed, report);
  if (kernel->regular()) kernel->mark_members(members);
  else std::fill(members.begin(), members.end(), 1);
  note();
  bool left = false;
  for (int place = 0; place < loops.row_count(); ++place) left |= report.unique[loops.joint_of_row(place)] != 0;
  if (!report.singular_rows.empty() || !left) return;
  ConstraintKernel at_start(solver, loops, assembled, report.redundant_rows);
  if (at_start.regular()) at_start.mark_members(members);
  note();
}

/// Rows of one component of the loops that nearly depend on the others.
struct NearRows {
  int count = 0;
  double least = INFINITY, most = 0.0;
};

/// In a closed row of n links the last ones are independent by 1/n: of a large component only less is by digits.
std::vector<NearRows> near_rows(const ClosedLoops& loops, const LoopPose& pose) {
  std::vector<double> rows(loops.component_count(), 0.0);
  for (int place = 0; place < loops.row_count(); ++place) rows[loops.component_of_row(place)] += 1.0;
  std::vector<NearRows> out(rows.size());
  for (const auto& [place, part] : pose.weak) {
    const int c = loops.component_of_row(place);
    if (!(part < by_digits * few_rows / std::max(few_rows, rows[c]))) continue;
    out[c] = {out[c].count + 1, std::min(out[c].least, part), std::max(out[c].most, part)};
  }
  return out;
}

/// Fills in the report: near dependence that is there in both poses. A driver says where a mechanism stands, which may
/// be beside a singular pose: it is looked at without.
void note_near_dependence(const ClosedLoops& loops, const LoopPose& assembled, const LoopPose& perturbed,
                          RankReport& report) {
  const std::vector<NearRows> first = near_rows(loops, assembled), second = near_rows(loops, perturbed);
  if (loops.system().time_dependent_constraints()) {
    if (std::ranges::none_of(first, [](const NearRows& rows) { return rows.count > 0; })) return;
    const RankReport without = examine_rank(System(loops.system().model().without_drivers()));
    report.beside_drivers = without.nearly_dependent > 0;
    report.nearly_dependent = without.nearly_dependent;
    report.least_part = without.least_part;
    report.near = without.near;
    return;
  }
  for (std::size_t c = 0; c < first.size(); ++c) {
    if (first[c].count == 0 || second[c].count == 0) continue;
    report.nearly_dependent += std::min(first[c].count, second[c].count);
    report.least_part = std::min(report.least_part, std::max(first[c].least, second[c].least));
    report.near = std::max(report.near, first[c].most);
  }
}

/// Fills in the report: rows that are redundant at the assembled and at a perturbed pose, and those that are dependent
/// at the assembled one only. `reached`: the components that are assembled there.
void find_redundancy(MassWeightedLeastSquares& solver, const ClosedLoops& loops, LoopPose& assembled,
                     const std::vector<char>& reached, double tolerance, RankReport& report) {
  const System& system = solver.system();
  const auto row = [&](int place) { return loops.rows()[place]; };
  std::vector<int> freedoms = degrees_of_freedom(system, loops, assembled.dependent);
  for (std::size_t c = 0; c < freedoms.size(); ++c)
    if (!reached[c]) freedoms[c] = 0;  // it comes to no rest: there is no other pose to look at
  Evaluation at = system.make_evaluation();
  const PerturbedPose found = perturb(solver, loops, report.q, freedoms, at);
  report.q = found.q;
  system.evaluate_constraints(0.0, report.q, VectorXd::Zero(system.v_size()), system.initial_history(), at);
  LoopPose perturbed(loops, std::move(at), tolerance);
  note_near_dependence(loops, assembled, perturbed, report);
  const RedundantRows redundant = redundant_rows(solver, loops, assembled, perturbed, found, tolerance);
  for (const int place : redundant.rows) report.redundant_rows.push_back(row(place));

  Places kept = complement(redundant.rows, loops.row_count());
  std::erase_if(kept, [&](int place) { return redundant.independent[loops.component_of_row(place)] != 0; });
  for (const int k : dependent_rows(loops, select_rows(assembled.D, kept), tolerance))
    report.singular_rows.push_back(row(kept[k]));
  find_unique(solver, loops, assembled.at, perturbed.at, report);
}

/// From near by, where digits of positions far from the origin do not hide what is small, by a system without inerters,
/// whose D is another one than that of the given one. Changes q to what is seen from there.
struct CloseView {
  MassWeightedLeastSquares solver;
  Evaluation at;

  CloseView(const System& given, VectorXd& q)
      : solver(MassWeightedLeastSquares::of_geometry(given, q)), at(system().make_evaluation()) {
    q = solver.seen(q);
  }
  const System& system() const { return solver.system(); }
  void evaluate(const VectorXd& q) {
    system().evaluate_constraints(0.0, q, VectorXd::Zero(system().v_size()), system().initial_history(), at);
  }
};

/// Looks at the loops from the evaluation `at` of the initial pose on. Where that does not satisfy all constraints it
/// is assembled first.
void examine_loops(const System& given, const ClosedLoops& loops, double tolerance, Evaluation& at,
                   RankReport& report) {
  std::optional<CloseView> close;
  std::vector<char> reached(loops.component_count(), 1);
  const bool is_assembled = residuals(given, at).maxCoeff() <= assembled;
  if (!is_assembled) {
    const System& system = close.emplace(given, report.q).system();
    ConsistentPose start =
        project_positions(close->solver, loops, {0.0, report.q, system.initial_history()}, close->at);
    report.q = std::move(start.q);
    reached = std::move(start.reached);
    close->evaluate(report.q);
    tolerance = std::max(tolerance, tolerance_of_geometry(system, loops, close->at));
  }
  LoopPose pose(loops, std::move(is_assembled ? at : close->at), tolerance);
  if (is_assembled && !(pose.dependent.empty() && pose.weak.empty())) close.emplace(given, report.q);
  if (!pose.dependent.empty()) {
    const bool other_D = is_assembled && !given.inerters().empty();
    if (other_D) close->evaluate(report.q);
    if (other_D) std::swap(pose.at, close->at);
    find_redundancy(close->solver, loops, pose, reached, tolerance, report);
    if (other_D) std::swap(pose.at, close->at);
  } else if (!pose.weak.empty()) {
    const System& system = close->system();
    Evaluation scratch = system.make_evaluation();
    const PerturbedPose found =
        perturb(close->solver, loops, report.q, degrees_of_freedom(system, loops, pose.dependent), scratch);
    const LoopPose perturbed(system, loops, {0.0, found.q, system.initial_history()}, tolerance);
    note_near_dependence(loops, pose, perturbed, report);
  }
  if (is_assembled) at = std::move(pose.at);
}

}  // namespace

PoseRank rank_of_constraints(const System& system, const Evaluation& at, double tolerance) {
  const ClosedLoops loops(system, at, tolerance);
  PoseRank report;
  report.rows = system.row_count();
  for (const int place : dependent_rows(loops, loops.scaled_D(at), tolerance))
    report.dependent_rows.push_back(loops.rows()[place]);
  report.rank = report.rows - static_cast<int>(report.dependent_rows.size());
  report.degrees_of_freedom = system.v_size() - report.rank;
  return report;
}

RankReport examine_rank(const System& given, double least_tolerance) {
  Evaluation scratch = given.make_evaluation();
  return examine_rank(given, scratch, least_tolerance);
}

RankReport examine_rank(const System& given, Evaluation& at, double least_tolerance) {
  RankReport report;
  report.rows = given.row_count();
  report.unique.assign(given.joint_count(), 1);
  report.q = given.model().initial_q();
  const double tolerance = std::max(least_tolerance, roundoff_of_positions(given, report.q));
  given.evaluate_constraints(0.0, report.q, VectorXd::Zero(given.v_size()), given.initial_history(), at);
  const ClosedLoops loops(given, at, tolerance);
  if (loops.row_count() > 0) examine_loops(given, loops, tolerance, at, report);
  report.rank = report.rows - static_cast<int>(report.redundant_rows.size());
  report.degrees_of_freedom = given.v_size() - report.rank;
  return report;
}

namespace {

bool same_joint(const Element& a, const Element& b) {
  return a.kind == b.kind && a.i == b.i && a.j == b.j && a.first_parameter == b.first_parameter &&
         a.at.s_i == b.at.s_i && a.at.s_j == b.at.s_j && a.at.C_i == b.at.C_i && a.at.C_j == b.at.C_j;
}

bool same_number(const Parameter& a, const Parameter& b) {
  return a.signal < 0 && b.signal < 0 && a.constant == b.constant;
}

bool has_special_joint(const Model& model) {
  for (int joint = 0; joint < static_cast<int>(model.joints().size()); ++joint)
    if (model.special_joint(joint)) return true;
  return false;
}

/// Joints with functions of time, with a memory, or with numbers of their own such as the factors of a coupler are not
/// compared; nor what inerters make of masses.
bool comparable(const System& system) {
  return system.initial_history().size() == 0 && system.inerters().empty() && !system.time_dependent_constraints() &&
         !has_special_joint(system.model());
}

}  // namespace

bool same_geometry(const System& a, const System& b) {
  const Model &one = a.model(), &other = b.model();
  return comparable(a) && comparable(b) && std::ranges::equal(one.joints(), other.joints(), same_joint) &&
         std::ranges::equal(one.joint_parameters(), other.joint_parameters(), same_number) &&
         one.initial_q() == other.initial_q() && characteristic_lengths(a) == characteristic_lengths(b);
}

std::vector<DependentGroup> dependent_groups(const System& given, const RankReport& report, std::size_t most) {
  std::vector<DependentGroup> groups;
  if (report.redundant_rows.empty()) return groups;
  const VectorXd start = given.model().initial_q();
  MassWeightedLeastSquares solver = MassWeightedLeastSquares::of_geometry(given, start);
  const System& system = solver.system();
  Evaluation at = system.make_evaluation();
  system.evaluate_constraints(0.0, report.q, VectorXd::Zero(system.v_size()), system.initial_history(), at);
  const ClosedLoops loops(system, at, std::max(rank_tolerance, roundoff_of_positions(given, start)));
  const auto kernel = make_kernel(solver, loops, at, report);
  for (std::size_t k = 0; k < std::min(most, report.redundant_rows.size()); ++k) {
    const auto& dependent = kernel->dependent();
    const auto own = std::lower_bound(dependent.begin(), dependent.end(), report.redundant_rows[k]) - dependent.begin();
    const VectorXd n = kernel->vector(VectorXd::Unit(kernel->size(), own));
    const double least = ConstraintKernel::member * n.cwiseAbs().maxCoeff();
    DependentGroup group{report.redundant_rows[k], {}};
    for (int place = 0; place < loops.row_count(); ++place)
      if (const int row = loops.rows()[place]; std::abs(n[place]) > least && row != group.row)
        group.others.push_back(row);
    groups.push_back(std::move(group));
  }
  return groups;
}

std::string describe(const Model& model, const DependentGroup& group) {
  const std::string row = model.describe_row(group.row) + ", ";
  if (group.others.empty()) return row + "holds nothing";
  const int own = model.joint_of_row(group.row);
  std::vector<std::string> joints;
  for (int last = own; const int other : group.others)
    if (const int joint = model.joint_of_row(other); joint != own && joint != last)
      joints.push_back(model.joint_name(last = joint));
  if (joints.empty()) return row + "repeats what the joint's other equations already fix";
  return row + "repeats what " + quoted(joints, ", ", joints_in_text) +
         (joints.size() > 1 ? " already fix" : " already fixes");
}

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// What an inerter feels of a body.
struct FeltBody {
  int body, row;  ///< behind those of the joints
  const double* d;
  bool operator<(const FeltBody& other) const { return body < other.body; }
};

/// By their bodies, but the ground.
std::vector<FeltBody> felt_by_inerters(const System& system, const Evaluation& at) {
  std::vector<FeltBody> out;
  for (std::size_t k = 0; k < system.inerters().count(); ++k)
    for (const Inerters::Part& part : system.inerters().row(k, at.D.data()))
      if (part.body != ground) out.push_back({part.body, system.row_count() + static_cast<int>(k), part.d});
  std::stable_sort(out.begin(), out.end());
  return out;
}

}  // namespace

// ker M and ker D meet iff D K has dependent columns, K a basis of ker M: per massless body the directions without
// inertia. What an equation feels of one is nothing where it is roundoff of its lever arms. Inerters are inertia of a
// motion that they feel.
std::vector<int> free_massless_bodies(const System& system, const Evaluation& at, double tolerance) {
  std::vector<int> owner;
  std::vector<Entry> entries;
  const VectorXd& lengths = characteristic_lengths(system);
  const VectorXd of_rows = row_lengths(system, at);
  const std::vector<FeltBody> inerters = felt_by_inerters(system, at);
  for (const int body : system.massless_bodies()) {
    const MatrixXd kernel = system.massless_directions(body);
    for (Eigen::Index c = 0; c < kernel.cols(); ++c) {
      const int column = static_cast<int>(owner.size());
      owner.push_back(body);
      const Vec6 motion = kernel.col(c);
      const double natural = motion.head<3>().norm() / lengths[body] + motion.tail<3>().norm();
      for (const int index : system.body_blocks(body)) {
        const ConstraintBlock& block = system.blocks()[index];
        for (int k = 0; k < block.rows; ++k) {
          const double felt = Eigen::Map<const Vec6>(at.D.data() + block.offset + 6 * k).dot(motion);
          if (std::abs(felt) > tolerance * natural * of_rows[block.row + k])
            entries.push_back({block.row + k, column, felt});
        }
      }
      const auto [first, last] = std::equal_range(inerters.begin(), inerters.end(), FeltBody{body, 0, nullptr});
      for (auto it = first; it != last; ++it) {
        const Eigen::Map<const Vec6> d(it->d);
        const double felt = d.dot(motion),
                     most = d.head<3>().norm() * motion.head<3>().norm() + d.tail<3>().norm() * motion.tail<3>().norm();
        if (std::abs(felt) > tolerance * most) entries.push_back({it->row, column, felt});
      }
    }
  }
  const int rows = system.row_count() + static_cast<int>(system.inerters().count());
  std::vector<int> bodies;
  for (const int column : dependent_columns(rows, static_cast<int>(owner.size()), std::move(entries), tolerance))
    bodies.push_back(owner[column]);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

}  // namespace linkwork
