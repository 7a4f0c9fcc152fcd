#include "linkwork/constraints/redundancy_watch.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/rank.hpp"
#include "linkwork/constraints/row_selection.hpp"

namespace linkwork {
namespace {

constexpr double noticed = 1e-8;     // of the size or the speed of the mechanism
constexpr double explained = 100.0;  // times what the others are violated by
constexpr double louder = 3.0, more = 2.0;
constexpr double met = 1e-6;  // part of a violation that is left where all constraints can be met
constexpr double met_absolute = 1e-13;
constexpr double remaining = 1e-2;  // part that is left where they cannot
constexpr double involved = 1e-2;
constexpr int most_pulls = 5;

double largest(const VectorXd& values) { return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0; }

/// Of centers of mass and of the points of joints, as far as they are apart.
double size_of(const System& system, const VectorXd& q) {
  Vec3<double> least = Vec3<double>::Constant(INFINITY), most = -least;
  double arm = 0.0;
  const auto take = [&](const Vec3<double>& point) {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  };
  for (int body = 0; body < system.body_count(); ++body) take(q.segment<3>(position_size * body));
  for (const Element& joint : system.model().joints())
    for (const auto& [body, s] : {std::pair{joint.i, joint.at.s_i}, std::pair{joint.j, joint.at.s_j}}) {
      if (body == ground) take(s);
      else arm = std::max(arm, s.norm());
    }
  const double size = std::max(arm, (most - least).maxCoeff());
  return size > 0.0 && std::isfinite(size) ? size : 1.0;
}

/// Rows of the loops alone: those of open branches yield to a pull.
void take_branches_from(VectorXd& Phi, const ClosedLoops& loops) {
  VectorXd of_loops = VectorXd::Zero(Phi.size());
  for (const int row : loops.rows()) of_loops[row] = Phi[row];
  Phi = of_loops;
}

/// The redundant rows as they would be chosen at a pose, with those outside of the loops.
std::vector<int> choose(MassWeightedLeastSquares& solver, const ClosedLoops& loops, LoopPose& pose,
                        const std::vector<int>& redundant) {
  const std::vector<char> all(loops.component_count(), 1);
  const PerturbedPose found{{{}, all}, all};
  std::vector<int> rows;
  for (const int place : redundant_rows(solver, loops, pose, pose, found, rank_tolerance).rows)
    rows.push_back(loops.rows()[place]);
  for (const int row : redundant)
    if (!std::binary_search(loops.rows().begin(), loops.rows().end(), row)) rows.push_back(row);
  std::sort(rows.begin(), rows.end());
  return rows;
}

std::vector<int> joints_with_residuals(const Model& model, const VectorXd& Phi) {
  std::vector<int> joints;
  const double least = involved * largest(Phi);
  for (Eigen::Index row = 0; row < Phi.size(); ++row)
    if (std::abs(Phi[row]) > least)
      if (const int joint = model.joint_of_row(static_cast<int>(row)); joints.empty() || joints.back() != joint)
        joints.push_back(joint);
  return joints;
}

}  // namespace

RedundancyExamination examine_redundancy(const System& given, const TimedPose& here,
                                         const std::vector<int>& redundant) {
  MassWeightedLeastSquares solver(given);
  const System& system = solver.system();
  const VectorXd rest = VectorXd::Zero(system.v_size());
  Evaluation at = system.make_evaluation();
  system.evaluate_constraints(here.t, here.q, rest, here.history, at);
  const double before = largest(at.Phi);
  const ClosedLoops loops(system, at, rank_tolerance);
  RedundancyExamination out;
  out.q = here.q;
  if (loops.row_count() == 0) return out;
  bool reached = true;
  for (int k = 0; k < most_pulls && reached && !out.consistent; ++k) {
    ConsistentPose projected = project_positions(solver, loops, {here.t, out.q, here.history});
    reached = std::find(projected.reached.begin(), projected.reached.end(), 0) == projected.reached.end();
    out.q = std::move(projected.q);
    system.evaluate_constraints(here.t, out.q, rest, here.history, at);
    take_branches_from(at.Phi, loops);
    out.consistent = largest(at.Phi) <= std::max(met * before, met_absolute);
  }
  out.contradicts = reached && largest(at.Phi) > remaining * before;
  if (out.contradicts) out.joints = joints_with_residuals(system.model(), at.Phi);
  if (!out.consistent) return out;
  LoopPose pose(system, loops, {here.t, out.q, here.history}, rank_tolerance);
  out.choice = choose(solver, loops, pose, redundant);
  out.changed = out.choice.size() < redundant.size();
  return out;
}

RedundancyWatch::RedundancyWatch(const System& system, const VectorXd& q)
    : size_(size_of(system, q)), position_level_(noticed), velocity_level_(noticed) {
  set_least();
}

void RedundancyWatch::set_least() {
  least_Phi_ = std::max(usual_Phi_, position_level_ * std::min(size_, 1.0));
  least_Phi_dot_ = std::max(usual_Phi_dot_, velocity_level_ * speed_ / std::max(size_, 1.0));
}

void RedundancyWatch::measure(const System& system, const Evaluation& at, const DroppedRows& dropped,
                              const ConstVector& v) {
  for (int body = 0; body < system.body_count(); ++body) {
    const double speed = v.segment<3>(velocity_size * body).cwiseAbs().maxCoeff();
    const double turning = v.segment<3>(velocity_size * body + 3).cwiseAbs().maxCoeff();
    speed_ = std::max({speed_, speed, turning * size_});
  }
  excess_ = {};
  const std::vector<char> translating = dropped.translating();
  for (std::size_t place = 0; place < translating.size(); ++place) {
    const int row = dropped.rows()[place];
    const double unit = translating[place] ? size_ : 1.0;
    const double Phi = std::abs(at.Phi[row]), Phi_dot = std::abs(at.Phi_dot[row]);
    excess_.Phi = std::max(excess_.Phi, Phi);
    excess_.position = std::max(excess_.position, Phi / unit);
    if (speed_ > 0.0) excess_.velocity = std::max(excess_.velocity, Phi_dot * size_ / (unit * speed_));
  }
}

bool RedundancyWatch::exceeds(const System& system, const Evaluation& at, const DroppedRows& dropped,
                              const ConstVector& v) {
  measure(system, at, dropped, v);
  set_least();
  if (excess_.position <= position_level_ && excess_.velocity <= velocity_level_) return false;
  VectorXd Phi = at.Phi, Phi_dot = at.Phi_dot;
  dropped.take_from(Phi);
  dropped.take_from(Phi_dot);
  excess_.kept = largest(Phi) / std::min(size_, 1.0);
  const double rate = speed_ > 0.0 ? largest(Phi_dot) * std::max(size_, 1.0) / speed_ : INFINITY;
  if ((excess_.position > position_level_ && excess_.position > explained * excess_.kept) ||
      (excess_.velocity > velocity_level_ && excess_.velocity > explained * (excess_.kept + rate)))
    return true;
  for (const int row : dropped.rows()) {
    usual_Phi_ = std::max(usual_Phi_, more * std::abs(at.Phi[row]));
    usual_Phi_dot_ = std::max(usual_Phi_dot_, more * std::abs(at.Phi_dot[row]));
  }
  set_least();
  return false;
}

void RedundancyWatch::suspect_less() {
  position_level_ = std::max(position_level_, louder * excess_.position);
  velocity_level_ = std::max(velocity_level_, louder * excess_.velocity);
  set_least();
}

}  // namespace linkwork
