#include "linkwork/formulation/singular_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/constraints/constraint_kernel.hpp"
#include "linkwork/constraints/rank.hpp"
#include "linkwork/constraints/row_selection.hpp"

namespace linkwork {
namespace {

constexpr double involved = 1e-3;          // part of the largest entry of a dependence
constexpr double margin = 3.0;             // between pivots in one order and in another
constexpr double recovered = 4.0;          // times the suspicious pivot: the crossing is over
constexpr double trusted = 1e-10;          // pivots whose solutions keep half of the digits
constexpr double trusted_relative = 1e-7;  // the same for models whose pivots are all small
constexpr double less = 1e-2;
constexpr std::size_t trend_samples = 8;
constexpr std::size_t most_crossings = 100;

/// Places of the rows in loops that are not among `rows`.
Places kept_places(const ClosedLoops& loops, const std::vector<int>& rows) {
  Places out;
  for (int place = 0; place < loops.row_count(); ++place)
    if (!std::binary_search(rows.begin(), rows.end(), loops.rows()[place])) out.push_back(place);
  return out;
}

/// Kept rows that nearly depend on the others.
std::vector<int> near_rows(const ClosedLoops& loops, const SparseRows& D, const std::vector<int>& redundant,
                           double near) {
  const Places kept = kept_places(loops, redundant);
  std::vector<int> out;
  for (const int k : dependent_rows(loops, select_rows(D, kept), near)) out.push_back(loops.rows()[kept[k]]);
  return out;
}

std::vector<int> joints_of(const Model& model, const std::vector<int>& rows) {
  std::vector<int> joints;
  for (const int row : rows)
    if (const int joint = model.joint_of_row(row); joints.empty() || joints.back() != joint) joints.push_back(joint);
  return joints;
}

/// Joints of the rows of which the near rows are combinations.
std::vector<int> involved_joints(MassWeightedLeastSquares& solver, const ClosedLoops& loops, Evaluation& at,
                                 const std::vector<int>& redundant, const std::vector<int>& near) {
  std::vector<int> dependent = redundant;
  dependent.insert(dependent.end(), near.begin(), near.end());
  const Model& model = solver.system().model();
  ConstraintKernel kernel(solver, loops, at, dependent);
  if (!kernel.regular()) return joints_of(model, near);
  VectorXd n_d(kernel.size());
  for (Eigen::Index k = 0; k < n_d.size(); ++k)
    n_d[k] = std::binary_search(near.begin(), near.end(), kernel.dependent()[k]) ? 1.0 : 0.0;
  const VectorXd n = kernel.vector(n_d);
  const double least = involved * n.cwiseAbs().maxCoeff();
  std::vector<int> rows;
  for (Eigen::Index place = 0; place < n.size(); ++place)
    if (std::abs(n[place]) > least) rows.push_back(loops.rows()[place]);
  return joints_of(model, rows);
}

/// The redundant rows as they would be chosen in this pose; none where their number would be another.
std::vector<int> choose_here(MassWeightedLeastSquares& solver, const ClosedLoops& loops, LoopPose& pose,
                             const std::vector<int>& redundant) {
  const std::size_t present = static_cast<std::size_t>(loops.row_count()) - kept_places(loops, redundant).size();
  if (present == 0 || pose.dependent.size() != present) return {};
  const std::vector<char> all(loops.component_count(), 1);
  const PerturbedPose found{{{}, all}, all};
  std::vector<int> rows;
  for (const int place : redundant_rows(solver, loops, pose, pose, found, rank_tolerance, false).rows)
    rows.push_back(loops.rows()[place]);
  for (const int row : redundant)
    if (!std::binary_search(loops.rows().begin(), loops.rows().end(), row)) rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  return rows.size() == redundant.size() ? rows : std::vector<int>();
}

ClosedLoops loops_at(const MassWeightedLeastSquares& solver, const TimedPose& here) {
  const System& system = solver.system();
  Evaluation at = system.make_evaluation();
  system.evaluate_constraints(here.t, solver.seen(here.q), VectorXd::Zero(system.v_size()), here.history, at);
  return {system, at, rank_tolerance};
}

/// The nearest pose that satisfies the constraints.
LoopPose assembled(MassWeightedLeastSquares& solver, const ClosedLoops& loops, const TimedPose& here) {
  const VectorXd q = solver.seen(here.q);
  const ConsistentPose found = project_positions(solver, loops, {here.t, q, here.history});
  return {solver.system(), loops, {here.t, found.q, here.history}, rank_tolerance};
}

}  // namespace

PoseExamination examine_pose(const System& given, const TimedPose& here, const std::vector<int>& redundant,
                             double near) {
  MassWeightedLeastSquares solver = MassWeightedLeastSquares::of_geometry(given, here.q);
  PoseExamination out;
  const ClosedLoops loops = loops_at(solver, here);
  if (loops.row_count() == 0) return out;
  LoopPose pose = assembled(solver, loops, here);
  out.rows = near_rows(loops, pose.D, redundant, near);
  if (out.rows.empty()) return out;
  out.joints = involved_joints(solver, loops, pose.at, redundant, out.rows);
  out.singular = dependent_rows(loops, pose.D, near).size() + kept_places(loops, redundant).size() >
                 static_cast<std::size_t>(loops.row_count());
  out.better_choice = choose_here(solver, loops, pose, redundant);
  if (!near_rows(loops, pose.D, out.better_choice, near).empty()) out.better_choice.clear();
  return out;
}

std::vector<int> choose_redundant_rows(const System& given, const TimedPose& here, const std::vector<int>& present) {
  MassWeightedLeastSquares solver = MassWeightedLeastSquares::of_geometry(given, here.q);
  const ClosedLoops loops = loops_at(solver, here);
  LoopPose pose = assembled(solver, loops, here);
  return choose_here(solver, loops, pose, present);
}

SingularWatch::SingularWatch() : untrusted_(trusted) {}

void SingularWatch::raise(double level) {
  level_ = level;
  root_of_level_ = std::sqrt(level);
  suspicious_ = suspicion_ * level_;
  untrusted_ = std::min(trusted, trusted_relative * level_);
}

double SingularWatch::near(double pivot) const { return margin * std::sqrt(std::max(pivot, untrusted_)); }

void SingularWatch::suspect_less() {
  suspicion_ *= less;
  raise(level_);
}

void SingularWatch::begin(double t, double pivot, std::vector<int> joints) {
  open_ = true;
  if (lists_) cross(t, pivot, std::move(joints));
}

void SingularWatch::change_rows(double t, double pivot, std::vector<int> joints) {
  if (t <= silent_until_) return;
  row_changes_ += 1;
  keep(t, pivot, std::move(joints), true);
}

void SingularWatch::cross(double t, double pivot, std::vector<int> joints) {
  const std::int64_t fallback_evaluations = std::exchange(fallback_evaluations_, 0);
  if (t <= silent_until_) return;
  singular_poses_ += 1;
  keep(t, pivot, std::move(joints), false);
  crossings_.back().fallback_evaluations = fallback_evaluations;
}

std::optional<SingularWatch::Trend> SingularWatch::trend() const {
  const std::size_t count = std::min(next_sample_, trend_samples);
  if (count < 2) return {};
  Trend out;
  out.last = out.other = samples_[(next_sample_ - 1) % samples_.size()];
  for (std::size_t k = 2; k <= count; ++k) {
    const Sample& sample = samples_[(next_sample_ - k) % samples_.size()];
    if (std::abs(sample.t - out.last.t) > std::abs(out.other.t - out.last.t)) out.other = sample;
  }
  return out;
}

std::optional<SingularWatch::Sample> SingularWatch::sample(double t, double within) const {
  for (std::size_t k = 1; k <= std::min(next_sample_, samples_.size()); ++k)
    if (const Sample& sample = samples_[(next_sample_ - k) % samples_.size()]; std::abs(sample.t - t) <= within)
      return sample;
  return {};
}

/// The first crossings are kept, and the last one.
void SingularWatch::keep(double t, double pivot, std::vector<int> joints, bool rows_changed) {
  if (level_ == 0.0) raise(1.0);
  if (crossings_.size() > most_crossings) crossings_.pop_back();
  crossings_.push_back(
      {.t = t, .pivot = std::max(pivot, 0.0) / level_, .joints = std::move(joints), .rows_changed = rows_changed});
}

void SingularWatch::go_on(double pivot) { open_ = pivot < recovered * suspicious_; }

}  // namespace linkwork
