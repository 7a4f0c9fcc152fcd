#include "linkwork/formulation/singular_watch.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/constraints/constraint_kernel.hpp"
#include "linkwork/constraints/row_selection.hpp"

namespace linkwork {
namespace {

constexpr double rank_tolerance = 1e-9;
constexpr double involved = 1e-3;          // part of the largest entry of a dependence
constexpr double margin = 3.0;             // between pivots in one order and in another
constexpr double recovered = 4.0;          // times the suspicious pivot: the passage is over
constexpr double trusted = 1e-10;          // pivots whose solutions keep half of the digits
constexpr double trusted_relative = 1e-7;  // the same for models whose pivots are all small
constexpr double less = 1e-2;
constexpr std::size_t trend_samples = 8;
constexpr std::size_t most_passages = 100;

/// Places of the core that are not among `rows`.
Places kept_places(const LoopCore& core, const std::vector<int>& rows) {
  Places out;
  for (int place = 0; place < core.row_count(); ++place)
    if (!std::binary_search(rows.begin(), rows.end(), core.rows()[static_cast<std::size_t>(place)]))
      out.push_back(place);
  return out;
}

/// Kept rows that nearly depend on the others.
std::vector<int> near_rows(const LoopCore& core, const SparseRows& D, const std::vector<int>& redundant, double near) {
  const Places kept = kept_places(core, redundant);
  std::vector<int> out;
  for (const int k : dependent_rows(select_rows(D, kept), near))
    out.push_back(core.rows()[static_cast<std::size_t>(kept[static_cast<std::size_t>(k)])]);
  return out;
}

std::vector<int> joints_of(const Model& model, const std::vector<int>& rows) {
  std::vector<int> joints;
  for (const int row : rows)
    if (const int joint = model.joint_of_row(row); joints.empty() || joints.back() != joint) joints.push_back(joint);
  return joints;
}

/// Joints of the rows of which the near rows are combinations.
std::vector<int> involved_joints(MetricSolver& solver, const LoopCore& core, const Evaluation& at,
                                 const std::vector<int>& redundant, const std::vector<int>& near) {
  std::vector<int> dependent = redundant;
  dependent.insert(dependent.end(), near.begin(), near.end());
  const Model& model = solver.system().model();
  ConstraintKernel kernel(solver, core, at, dependent);
  if (!kernel.regular()) return joints_of(model, near);
  VectorXd n_d(kernel.size());
  for (Eigen::Index k = 0; k < n_d.size(); ++k)
    n_d[k] = std::binary_search(near.begin(), near.end(), kernel.dependent()[static_cast<std::size_t>(k)]) ? 1.0 : 0.0;
  const VectorXd n = kernel.vector(n_d);
  const double least = involved * n.cwiseAbs().maxCoeff();
  std::vector<int> rows;
  for (Eigen::Index place = 0; place < n.size(); ++place)
    if (std::abs(n[place]) > least) rows.push_back(core.rows()[static_cast<std::size_t>(place)]);
  return joints_of(model, rows);
}

/// The redundant rows as they would be chosen in this pose; none where their number would be another.
std::vector<int> choose_here(MetricSolver& solver, const LoopCore& core, const CorePose& pose,
                             const std::vector<int>& redundant) {
  const std::size_t present = static_cast<std::size_t>(core.row_count()) - kept_places(core, redundant).size();
  if (present == 0 || pose.dependent.size() != present) return {};
  const std::vector<char> all(static_cast<std::size_t>(core.component_count()), 1);
  const PerturbedPose found{{{}, all}, all};
  std::vector<int> rows;
  for (const int place : redundant_rows(solver, core, pose, pose, found, rank_tolerance, false))
    rows.push_back(core.rows()[static_cast<std::size_t>(place)]);
  for (const int row : redundant)
    if (!std::binary_search(core.rows().begin(), core.rows().end(), row)) rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  return rows.size() == redundant.size() ? rows : std::vector<int>();
}

}  // namespace

PoseExamination examine_pose(const System& given, const TimedPose& here, const std::vector<int>& redundant,
                             double near) {
  MetricSolver solver = MetricSolver::of_geometry(given);
  const System& system = solver.system();
  Evaluation at = system.make_evaluation();
  system.evaluate_constraints(here.t, here.q, VectorXd::Zero(system.v_size()), here.history, at);
  const LoopCore core(system, at, rank_tolerance);
  PoseExamination out;
  if (core.row_count() == 0) return out;
  const VectorXd q = pull_back(solver, core, here).q;
  const CorePose pose(system, core, {here.t, q, here.history}, rank_tolerance);
  out.rows = near_rows(core, pose.D, redundant, near);
  if (out.rows.empty()) return out;
  out.joints = involved_joints(solver, core, pose.at, redundant, out.rows);
  out.singular = dependent_rows(pose.D, near).size() + kept_places(core, redundant).size() >
                 static_cast<std::size_t>(core.row_count());
  out.better_choice = choose_here(solver, core, pose, redundant);
  if (!near_rows(core, pose.D, out.better_choice, near).empty()) out.better_choice.clear();
  return out;
}

std::vector<int> choose_redundant_rows(const System& given, const TimedPose& here, const std::vector<int>& present) {
  MetricSolver solver = MetricSolver::of_geometry(given);
  const System& system = solver.system();
  Evaluation at = system.make_evaluation();
  system.evaluate_constraints(here.t, here.q, VectorXd::Zero(system.v_size()), here.history, at);
  const LoopCore core(system, at, rank_tolerance);
  const CorePose pose(system, core, {here.t, pull_back(solver, core, here).q, here.history}, rank_tolerance);
  return choose_here(solver, core, pose, present);
}

SingularWatch::SingularWatch() : untrusted_(trusted) {}

void SingularWatch::raise(double level) {
  level_ = level;
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
  row_changes_ += 1;
  keep(t, pivot, std::move(joints), true);
}

void SingularWatch::cross(double t, double pivot, std::vector<int> joints) {
  singular_poses_ += 1;
  keep(t, pivot, std::move(joints), false);
  passages_.back().taken_over = std::exchange(taken_over_, 0);
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

/// The first passages are kept, and the last one.
void SingularWatch::keep(double t, double pivot, std::vector<int> joints, bool rows_changed) {
  if (level_ == 0.0) raise(1.0);
  if (passages_.size() > most_passages) passages_.pop_back();
  passages_.push_back({t, std::max(pivot, 0.0) / level_, std::move(joints), rows_changed, 0});
}

void SingularWatch::go_on(double pivot) { open_ = pivot < recovered * suspicious_; }

}  // namespace linkwork
