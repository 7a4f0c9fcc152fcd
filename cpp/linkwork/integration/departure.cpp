#include "linkwork/integration/departure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/constraints/displacement.hpp"
#include "linkwork/constraints/length_scale.hpp"
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
constexpr double roundoff_of_places = 3.0;            // of positions, relative to the square of the way
constexpr double beside = 0.03;                       // of the way along velocities: others from there
constexpr double slow = 1e-9;                         // of the speed of a fall: velocities that mean rest
constexpr double balanced = 1e-8;                     // of what forces would do without joints
constexpr double in_pose = 1e-6;                      // of rows that near each other in the pose
constexpr double undecided = 1e-9, not_known = 1e-6;  // the same beside it
constexpr double different = 0.1;                     // of what joints do to accelerations: of another branch
constexpr double same = 1e-2;                         // of accelerations
constexpr std::uint64_t places = 12;                  // that are looked at

// [s] in which drivers move the mechanism so far, from rest.
constexpr double shortest_start = 1e-9, longest_start = 1e3;
constexpr double at_once = 1e-7;        // of that way in an eighth of the time: they move it from the start
constexpr double close = 1e-3;          // to that time, relative
constexpr double driven_at_all = 1e-6;  // of the start of the fastest component

}  // namespace

DepartureSearch::DepartureSearch(const System& system, const std::vector<int>& redundant, const TimedPose& pose)
    : given_(system),
      solver_(system),
      system_(solver_.system()),
      pose_(pose),
      size_(system),
      dropped_(system, redundant),
      at_(system_.make_evaluation()),
      lambda_(system.row_count()),
      way_(way),
      blur_(std::numeric_limits<double>::epsilon() * farthest_position(system, pose.q)) {}

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
  const VectorXd start = of_start(v_dot), moves = sizes(start);
  OfComponents open = undecided_by(start);
  for (Eigen::Index c = 0; c < moves.size() && start != v_dot; ++c)  // accelerations of later say nothing
    open[static_cast<std::size_t>(c)] = moves[c] > driven_at_all * moves.maxCoeff();
  out.kind = kind_of(start, open, out.v_dot);
  return out;
}

/// The accelerations of a start from rest: those of the pose, or where a driver begins more gently what it makes of
/// them on the way to the places.
VectorXd DepartureSearch::of_start(const VectorXd& v_dot) {
  starts_ = given_.time_dependent_constraints() && size_.of(v_) == 0.0;
  if (!starts_) return v_dot;
  seconds_ = std::sqrt(2.0 * way / size_.of(v_dot));
  for (double s = shortest_start; s < std::min(longest_start, 0.5 * seconds_); s *= 2.0) {
    if (!(size_.of(driven_by(s)) >= way)) continue;
    if (!(size_.of(driven_by(0.125 * s)) > at_once * way)) break;  // it rests for a while
    double least = 0.5 * s;
    for (seconds_ = s; seconds_ - least > close * s;) {
      const double middle = 0.5 * (least + seconds_);
      (size_.of(driven_by(middle)) < way ? least : seconds_) = middle;
    }
    return 2.0 / (seconds_ * seconds_) * driven_by(seconds_);
  }
  starts_ = std::isfinite(seconds_);
  if (!starts_) seconds_ = 0.0;
  return v_dot;
}

/// What drivers demand that much later.
VectorXd DepartureSearch::driven_by(double seconds) {
  const VectorXd none = VectorXd::Zero(v_.size());
  evaluate(pose_.t + seconds, pose_.q, none);
  return solve(none, -at_.Phi);
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
  const VectorXd direction = beside_center(unit(v_dot)), moves = sizes(direction), driven = sizes(v_dot);
  const VectorXd off = starts_ ? off_along_start(direction) : off_along(direction);
  const double tangent = std::max(starts_ ? off_branch : off_tangent, roundoff_of_places * blur_ / (way * way));
  VectorXd free;
  size_.of_free_motion(g_, free);
  OfComponents out(static_cast<std::size_t>(off.size()));
  for (Eigen::Index c = 0; c < off.size(); ++c)
    out[static_cast<std::size_t>(c)] =
        driven[c] > balanced * free[c] && driven[c] > 0.0 && !(off[c] <= tangent * moves[c]);
  return out;
}

/// How far a direction is off the branches, less what these bend; infinite where it leads to none.
VectorXd DepartureSearch::off_along(const VectorXd& direction) {
  const Place ahead = go(direction), behind = go(-direction, -1.0);
  return (ahead.off + behind.off)
      .array()
      .isFinite()
      .select(sizes(0.5 * (ahead.corrected - behind.corrected)), INFINITY);
}

/// The same from rest, where drivers lead ahead only: less what grows with the time, by half of it.
VectorXd DepartureSearch::off_along_start(const VectorXd& direction) {
  const Place ahead = go(direction);
  way_ = 0.25 * way;
  seconds_ *= 0.5;
  const Place nearer = go(direction);
  way_ = way;
  seconds_ *= 2.0;
  return (ahead.off + nearer.off).array().isFinite().select(sizes(2.0 * nearer.corrected - ahead.corrected), INFINITY);
}

/// By places beside the pose; `of_branch` become the accelerations of one that there is.
Departure::Kind DepartureSearch::kind_of(const VectorXd& v_dot, const OfComponents& open, VectorXd& of_branch) {
  if (std::find(open.begin(), open.end(), 1) == open.end()) return Departure::Kind::one_motion;
  std::vector<std::pair<Place, VectorXd>> found;
  VectorXd farthest_away = sizes(center_);
  for (std::uint64_t seed = 1; seed <= places; ++seed) {
    VectorXd direction = beside_center(random_direction(seed));
    if (starts_) direction = unit(v_dot) + static_cast<double>(seed) / places * direction;
    const Place place = go(direction);
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
  const VectorXd displacement = way_ * (sign * center_ + direction), none = VectorXd::Zero(v_.size());
  Place out{pose_.t + sign * seconds_, pose_.q, none, {}, {}};
  displace(given_, displacement, out.q);
  VectorXd going = VectorXd::Ones(sizes(none).size());
  out.off = VectorXd::Zero(going.size());
  for (int k = 0; k < most_steps && going.maxCoeff() > 0.0; ++k) {
    evaluate(out.t, out.q, none);
    VectorXd step = solve(none, -at_.Phi);
    multiply(going, step);
    displace(given_, step, out.q);
    out.corrected += step / way_;
    const VectorXd last = sizes(step) / way_, all = sizes(out.corrected);
    for (Eigen::Index c = 0; c < going.size(); ++c) {
      if (going[c] == 0.0) continue;
      if (last[c] <= arrived || !(all[c] <= astray)) going[c] = 0.0;
      out.off[c] = last[c] <= arrived && all[c] <= farthest ? all[c] : INFINITY;
    }
  }
  out.away = sizes(displacement / way_ + out.corrected);
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
