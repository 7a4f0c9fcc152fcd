#include "linkwork/integration/departure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/constraints/displacement.hpp"
#include "linkwork/constraints/rank.hpp"
#include "linkwork/formulation/singular_watch.hpp"

namespace linkwork {
namespace {

constexpr double way = 1e-3;                          // to the places beside the pose [rad, or relative to the length]
constexpr double yielding = 1e-12;                    // of rows, so that there is a solution in the pose
constexpr double arrived = 1e-6;                      // of the way: the last step to the constraints
constexpr int most_steps = 30;                        // to there
constexpr double farthest = 0.9;                      // of the way: corrections that lead back into the pose
constexpr double astray = 3.0;                        // of the way: and those that lead elsewhere
constexpr double back_in_pose = 1e-2;                 // of the way
constexpr double off_branch = 1e-2;                   // of the way: a branch bends less
constexpr double off_tangent = 1e-5;                  // the same, less what it bends
constexpr double beside = 0.03;                       // of the way along velocities: others from there
constexpr double slow = 1e-9;                         // of the speed of a fall: velocities that mean rest
constexpr double balanced = 1e-8;                     // of what forces would do without joints
constexpr double in_pose = 1e-6;                      // of rows that near each other in the pose
constexpr double undecided = 1e-9, not_known = 1e-6;  // the same beside it
constexpr double different = 0.1;                     // of what joints do to accelerations: of another branch
constexpr double same = 1e-2;                         // of accelerations
constexpr std::uint64_t places = 12;                  // that are looked at

}  // namespace

DepartureSearch::DepartureSearch(const System& system, const std::vector<int>& redundant, const TimedPose& pose)
    : given_(system),
      solver_(system),
      system_(solver_.system()),
      pose_(pose),
      size_(system),
      dropped_(system, redundant),
      at_(system_.make_evaluation()),
      lambda_(system.row_count()) {}

Departure DepartureSearch::find(const VectorXd& v, const VectorXd& g) {
  v_ = v;
  g_ = g;
  evaluate(pose_.t, pose_.q, v);
  const VectorXd v_dot = solve(g, at_.gamma);
  if (!lies_on_branch(sizes(v_dot).cwiseSqrt())) return {Departure::Kind::of_no_branch};
  const Place ahead = go(VectorXd::Zero(v.size()));
  Departure out{Departure::Kind::one_motion, accelerations(ahead)};
  out.decided = !singular(ahead, size_.of(v_) > 0.0 ? undecided : in_pose);
  if (out.decided) return out;
  out.kind = kind_of(v_dot, undecided_by(v_dot), out.v_dot);
  return out;
}

/// False: they do not. Those that are nothing but roundoff become zero.
bool DepartureSearch::lies_on_branch(const VectorXd& fall) {
  const auto see = [&] {
    center_ = unit(v_);
    const double speed = size_.of(v_);
    seconds_ = given_.time_dependent_constraints() && speed > 0.0 ? way / speed : 0.0;
  };
  see();
  const VectorXd off = go(VectorXd::Zero(v_.size())).off, speeds = sizes(v_);
  VectorXd kept = VectorXd::Ones(off.size());
  for (Eigen::Index c = 0; c < off.size(); ++c) {
    if (off[c] <= off_branch) continue;
    if (speeds[c] > slow * fall[c]) return false;
    kept[c] = 0.0;
  }
  multiply(kept, v_);
  see();
  return true;
}

/// The components of which the branch is not known by velocities or, if these do not tell, by the accelerations that
/// the pose allows.
DepartureSearch::OfComponents DepartureSearch::undecided_by(const VectorXd& v_dot) {
  const VectorXd direction = beside_center(unit(v_dot));
  const Place ahead = go(direction), behind = go(-direction, -1.0);
  const VectorXd off = sizes(0.5 * (ahead.corrected - behind.corrected)), moves = sizes(direction);
  VectorXd free;
  size_.of_free_motion(g_, free);
  const VectorXd driven = sizes(v_dot);
  OfComponents out(static_cast<std::size_t>(off.size()));
  for (Eigen::Index c = 0; c < off.size(); ++c)
    out[static_cast<std::size_t>(c)] = driven[c] > balanced * free[c] && driven[c] > 0.0 &&
                                       !(off[c] <= off_tangent * moves[c] && ahead.off[c] + behind.off[c] < INFINITY);
  return out;
}

/// By places beside the pose; `of_branch` become the accelerations of one that there is.
Departure::Kind DepartureSearch::kind_of(const VectorXd& v_dot, const OfComponents& open, VectorXd& of_branch) {
  if (std::find(open.begin(), open.end(), 1) == open.end()) return Departure::Kind::one_motion;
  std::vector<std::pair<Place, VectorXd>> found;
  VectorXd farthest_away = sizes(center_);
  for (std::uint64_t seed = 1; seed <= places; ++seed) {
    const Place place = go(beside_center(random_direction(seed)));
    farthest_away = farthest_away.cwiseMax(place.away);
    if (singular(place, not_known)) continue;
    const VectorXd a = accelerations(place);
    for (const auto& [other, b] : found)
      if (differ(place, a, other, b, v_dot, open)) return Departure::Kind::several_motions;
    found.emplace_back(place, a);
  }
  for (Eigen::Index c = 0; c < farthest_away.size(); ++c)
    if (open[static_cast<std::size_t>(c)] && farthest_away[c] < back_in_pose) return Departure::Kind::no_motion;
  if (!found.empty()) of_branch = found.front().second;
  return Departure::Kind::one_motion;
}

bool DepartureSearch::differ(const Place& one, const VectorXd& a, const Place& other, const VectorXd& b,
                             const VectorXd& v_dot, const OfComponents& open) const {
  const VectorXd between = sizes(a - b), of_a = sizes(a - v_dot), of_b = sizes(b - v_dot), size = sizes(v_dot);
  for (Eigen::Index c = 0; c < between.size(); ++c)
    if (open[static_cast<std::size_t>(c)] && one.off[c] + other.off[c] < INFINITY &&
        between[c] > std::max(different * std::max(of_a[c], of_b[c]), same * size[c]))
      return true;
  return false;
}

/// To the constraints, from a displacement along the velocities and in a direction beside them.
DepartureSearch::Place DepartureSearch::go(const VectorXd& direction, double sign) {
  const VectorXd displacement = way * (sign * center_ + direction), none = VectorXd::Zero(v_.size());
  Place out{pose_.t + sign * seconds_, pose_.q, none, {}, {}};
  displace(given_, displacement, out.q);
  VectorXd going = VectorXd::Ones(sizes(none).size());
  out.off = VectorXd::Zero(going.size());
  for (int k = 0; k < most_steps && going.maxCoeff() > 0.0; ++k) {
    evaluate(out.t, out.q, none);
    VectorXd step = solve(none, -at_.Phi);
    multiply(going, step);
    displace(given_, step, out.q);
    out.corrected += step / way;
    const VectorXd last = sizes(step) / way, all = sizes(out.corrected);
    for (Eigen::Index c = 0; c < going.size(); ++c) {
      if (going[c] == 0.0) continue;
      if (last[c] <= arrived || !(all[c] <= astray)) going[c] = 0.0;
      out.off[c] = last[c] <= arrived && all[c] <= farthest ? all[c] : INFINITY;
    }
  }
  out.away = sizes(displacement / way + out.corrected);
  return out;
}

VectorXd DepartureSearch::accelerations(const Place& place) {
  evaluate(place.t, place.q, VectorXd::Zero(v_.size()));
  const VectorXd v = solve(momentum(v_), -at_.Phi_dot);
  evaluate(place.t, place.q, v);
  return solve(g_, at_.gamma);
}

bool DepartureSearch::singular(const Place& place, double near) const {
  return examine_pose(given_, {place.t, place.q, pose_.history}, dropped_.rows(), near).singular;
}

void DepartureSearch::evaluate(double t, const VectorXd& q, const VectorXd& v) {
  system_.evaluate_constraints(t, q, v, pose_.history, at_);
  dropped_.take_out(at_);
  e_ = system_.delassus_diagonal(at_);
  e_ = (e_.array() > 0.0).select(yielding * e_.array(), 1.0);
}

/// M x - D^T lambda = a, D x = b; nothing where there is no solution.
VectorXd DepartureSearch::solve(const VectorXd& a, const VectorXd& b) {
  VectorXd x(a.size()), kept = b;
  dropped_.take_from(kept);
  if (!solver_.factorize_and_solve(at_, e_, a, kept, x, lambda_)) x.setZero();
  return x;
}

VectorXd DepartureSearch::momentum(const VectorXd& v) const {
  VectorXd out(v.size());
  system_.multiply_mass(at_, v, out);
  return out;
}

VectorXd DepartureSearch::random_direction(std::uint64_t seed) {
  const VectorXd none = VectorXd::Zero(system_.row_count());
  evaluate(pose_.t, pose_.q, VectorXd::Zero(v_.size()));
  VectorXd v = random_allowed_velocity(solver_, ClosedLoops(system_, at_, rank_tolerance), at_, seed);
  for (int k = 0; k < 2; ++k) v = solve(momentum(v), none);
  return unit(v);
}

/// Each component in its own size: where constraints change with time, all in that of the fastest.
VectorXd DepartureSearch::unit(const VectorXd& v) const {
  VectorXd out = v, size = sizes(v);
  if (given_.time_dependent_constraints()) size.setConstant(size.maxCoeff());
  multiply((size.array() > 0.0).select(size.array().inverse(), 0.0), out);
  return out;
}

/// A direction, by which velocities that do not decide are left by a little only.
VectorXd DepartureSearch::beside_center(const VectorXd& direction) const {
  VectorXd out = direction;
  multiply((sizes(center_).array() > 0.0).select(beside, VectorXd::Ones(sizes(center_).size())), out);
  return out;
}

VectorXd DepartureSearch::sizes(const VectorXd& x) const {
  VectorXd out;
  size_.of(x, out);
  return out;
}

void DepartureSearch::multiply(const VectorXd& factors, VectorXd& x) const {
  const ConnectedComponents& components = ConnectedComponents::of(given_);
  for (int body = 0; body < given_.body_count(); ++body)
    x.segment<velocity_size>(velocity_size * body) *= factors[components.of_body(body)];
}

}  // namespace linkwork
