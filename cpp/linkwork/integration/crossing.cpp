#include "linkwork/integration/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/displacement.hpp"
#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double reach = 0.14;      // of a leap [rad]: what the fastest body of the loops turns
constexpr double fastest = 0.8;     // the same for any body
constexpr double least_part = 0.1;  // of that, for leaps over a motion that varies more
constexpr double near = 0.3;  // of the usual least singular value, or root of the smallest pivot: else none is due
constexpr double near_at_start = 0.1;                         // that root, before there is a usual one
constexpr double roundoff = 1e-7;                             // that root, where nothing is left of a pivot
constexpr double way_at_start = 0.03, change_at_start = 0.1;  // [rad], and of the root there, relative, toward a pose
constexpr double passed_at_start = 2.0;                       // the same, where that way leads over the pose
constexpr double left_behind = 0.05;                          // [rad] so far behind the start a pose does not matter
constexpr double least_usual = 0.15;  // the usual value of both, for runs that begin near a pose
constexpr double solvable = 1e-2;     // of the usual root: nearer to a pose, accelerations are of few digits
constexpr double drifted = 1e-3;      // farthest that a run that steps into a pose is off the constraints [rad]
constexpr double in_pose = 1e-5;      // at the start: rows that near each other, and only a leap leads out of it
constexpr double looked_at = 0.2;     // of the usual root: nearer, pivots do not tell when a pose is passed
constexpr double look_part = 0.1;     // rad to the next look, where the least singular value is the usual one
constexpr double coarse = 0.02;       // a step in which a body turns so far [rad] may pass a pose that no pivot shows
constexpr double coarsest = 0.1, most_parts = 20;  // of the way between states that are looked at [rad]
constexpr double resolved = 1e-15;        // of the square of the least singular value: changes by less are none
constexpr double fallen = 0.4;            // part of either, for another look at redundant rows
constexpr double steps_before = 15.0;     // so many fixed steps before the pose a usual one is no longer taken
constexpr double farthest = 2.0;          // usual leaps: no pose is foreseen beyond
constexpr double before_pose = 0.3;       // of a leap: where adaptive steps end before the pose
constexpr double part_of_foreseen = 0.5;  // way to a pose that usual steps go, as it may be nearer
constexpr double most_of_way = 0.75;      // that they may have gone where it was not foreseen
constexpr double short_steps = 4.0;       // of which a leap beside the pose is worth so many
constexpr double least_beside = 0.4;      // of a usual leap
constexpr double least_margin = 0.006;    // the same, where nothing better is found
constexpr double in_pose_from = 0.03;     // the same: where such a node is left out if it must be there
constexpr double same_time = 1e-9;        // relative to the step
constexpr double same_pose = 1e-2;        // relative to a leap
constexpr double farther = 1e-3;          // the same, of nodes from poses: what makes a length the better one
constexpr int most_attempts = 12;
// Of the length, where a leap does not converge: a node may be in the pose, or the leap too long.
constexpr double other_lengths[most_attempts] = {0.85, 1.15, 0.7, 0.6, 0.5, 1.3, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15};
constexpr double precision = 1e-16;         // of solutions, relative to the square of the angle to the pose
constexpr double no_branch = 1e-2;          // correction of velocities by the constraints: they do not go on that way
constexpr double looked_at_between = 36.0;  // times, where steps are adaptive: the eight nodes are not all that counts
constexpr double beside_pose = 0.05;        // of a leap: so near nothing is projected
constexpr double too_far = 1.5;             // of the usual distance to the pose: steps go on before the leap
constexpr double other_pace = 0.2;          // change of the rate with which a pose that was found is not relied on
constexpr double part_of_way = 0.8;         // to a foreseen pose
constexpr double before_switch = 0.9;       // of the way to where a contact or a stop begins or ends
constexpr double touching = 1e-12;          // depths, relative to the length

/// From a center of mass to a joint [m]; 1 where they coincide.
double longest_arm(const Model& model) {
  double arm = 0.0;
  for (const Element& joint : model.joints()) {
    if (joint.i != ground) arm = std::max(arm, joint.at.s_i.norm());
    if (joint.j != ground) arm = std::max(arm, joint.at.s_j.norm());
  }
  return arm > 0.0 ? arm : 1.0;
}

}  // namespace

Crossing::Crossing(Dynamics& dynamics)
    : dynamics_(dynamics),
      step_(dynamics, longest_arm(dynamics.system().model())),
      poses_(dynamics),
      touches_(dynamics, touching * step_.length()) {
  const System& system = dynamics.system();
  dynamics.formulation().watch().list_evaluations(false);
  if (!dynamics.formulation().watched()) return;
  const ClosedLoops loops(system, dynamics.evaluation(), rank_tolerance);
  in_loops_.resize(static_cast<std::size_t>(system.body_count()));
  for (int body = 0; body < system.body_count(); ++body)
    in_loops_[static_cast<std::size_t>(body)] = loops.component_of_body(body) >= 0;
  prepared_ = loops.row_count() > 0;
}

namespace {

/// speed t + acceleration t^2 / 2 = way
double time_of(double way, double speed, double acceleration) {
  return 2.0 * way / (speed + std::sqrt(speed * speed + 2.0 * acceleration * way));
}

}  // namespace

/// Time in which the mechanism, with these velocities and accelerations, moves by `reach`; infinite for one at rest.
double Crossing::usual_length(const ConstVector& v, const ConstVector& v_dot) const {
  double least = INFINITY;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    const double way = in_loops_[static_cast<std::size_t>(body)] ? reach : fastest;
    least = std::min(least, time_of(way, step_.rate(v.segment<6>(6 * body)), step_.rate(v_dot.segment<6>(6 * body))));
  }
  return least;
}

double Crossing::usual_length(const Speeds& speeds) const {
  const auto time = [&](double way, const double* squares) {
    return time_of(way, std::max(std::sqrt(squares[0]) / step_.length(), std::sqrt(squares[1])), 0.0);
  };
  return std::min(time(fastest, speeds.outside), time(reach, speeds.inside));
}

// The deterministic sums of lane_speeds.cpp are of the same order.
Speeds Crossing::speeds(const ConstVector& v) const {
  const Eigen::Map<const Eigen::Matrix<double, 6, Eigen::Dynamic>> rates(v.data(), 6, v.size() / 6);
  Speeds out{rates.topRows<3>().cwiseAbs().maxCoeff(), rates.bottomRows<3>().cwiseAbs().maxCoeff()};
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    double* const squares = in_loops_[static_cast<std::size_t>(body)] ? out.inside : out.outside;
    squares[0] = std::max(squares[0], v.segment<3>(6 * body).squaredNorm());
    squares[1] = std::max(squares[1], v.segment<3>(6 * body + 3).squaredNorm());
  }
  return out;
}

/// Time until the pose by the trend of the pivots, infinite where they do not fall or did not lead to a leap.
double Crossing::pivots_say(double t) {
  const SingularWatch::Sample* latest = dynamics_.watch().latest();
  if (!latest || declined_before(latest->root, declined_root_)) return INFINITY;
  if (latest->root > near * std::max(dynamics_.watch().root_of_level(), least_usual)) return INFINITY;
  const auto trend = dynamics_.watch().trend();
  const double interval = trend->last.t - trend->other.t;
  const double fall = (trend->other.root - trend->last.root) * (interval > 0.0 ? 1.0 : -1.0);
  if (!(fall > 0.0)) return INFINITY;
  return trend->last.t + trend->last.root * std::abs(interval) / fall - t;
}

/// The same by the least singular values at the last two looks.
double Crossing::looks_say(double t) {
  return declined_before(least_.value, declined_least_) ? INFINITY : falls_to_ - t;
}

double Crossing::time_to_pose(double t) { return known_ > t ? known_ - t : std::min(pivots_say(t), looks_say(t)); }

/// Whether there was nothing to leap over at about this value, and the motion has not left it since.
bool Crossing::declined_before(double value, double& declined) {
  const bool so = value > 0.5 * declined && value < 2.0 * declined;
  if (!so) declined = 0.0;
  return so;
}

/// Whether the first pivot is so small that the run may begin in a singular pose, which is listed then.
bool Crossing::starts_near(double t, const VectorXd& y) {
  double root = 0.0;
  {
    const Unwatched unwatched(dynamics_);
    try {
      dynamics_.factorize();
      root = dynamics_.formulation().root_of_pivot();
    } catch (const SingularSystemError&) {
    }
  }
  const bool near_pose = root < near_at_start && pivot_changes(t, y, root);
  in_pose_ = near_pose && in_singular_pose(t, y);
  if (in_pose_) poses_.list(t, y);
  return near_pose;
}

/// Whether the root of the smallest pivot, which falls linearly to a pose, changes as the motion begins: in a large
/// mechanism it is small wherever it is. Leaves `dynamics` evaluated at y.
bool Crossing::pivot_changes(double t, const VectorXd& y, double root) {
  if (!(root > roundoff)) return true;
  const System& system = dynamics_.system();
  const Unwatched unwatched(dynamics_);
  VectorXd way = y.segment(system.q_size(), system.v_size());
  bool changes = false, away = true;
  try {
    if (!(largest_rate(way) > 0.0)) {
      VectorXd lambda(system.row_count());
      dynamics_.accelerations(way, lambda);
    }
    if (const double rate = largest_rate(way); rate > 0.0) way *= way_at_start / rate;
    for (const double part : {0.3, 1.0}) {  // one of them may be as far beyond the pose as the start is before it
      VectorXd ahead = y;
      displace(system, part * way, ahead);
      dynamics_.begin_elsewhere(t, ahead);  // no forces there: the motion does not go there
      dynamics_.factorize();
      const double rise = dynamics_.formulation().root_of_pivot() / root - 1.0;
      away = away && rise > part * way_at_start / left_behind;
      changes = changes || -rise > change_at_start || rise > passed_at_start;
    }
  } catch (const SingularSystemError&) {
    changes = true;
  }
  dynamics_.evaluate(t, y);
  return changes || away;
}

/// Of the components of all motions [rad/s].
double Crossing::largest_rate(const Speeds& speeds) const {
  return std::max(speeds.linear / step_.length(), speeds.angular);
}

/// In which states from the last one that was looked at to the one at t are looked at: a pose bends the least singular
/// value over some tenths of a radian only.
int Crossing::parts_to(double t) const {
  const double turned = fastest_ * (t - poses_.last());
  return turned > coarsest ? static_cast<int>(std::min(std::ceil(turned / coarsest), most_parts)) : 1;
}

namespace {

class Here final : public Arrival {
 public:
  explicit Here(const VectorXd& y) : y_(y) {}
  const VectorXd& arrive() override { return y_; }

 private:
  const VectorXd& y_;
};

}  // namespace

bool Crossing::due(double t, double h, const VectorXd& y, bool adaptive) {
  if (!prepared_) return false;
  const System& system = dynamics_.system();
  Here here(y);
  return due(t, h, speeds(y.segment(system.q_size(), system.v_size())), adaptive, here);
}

bool Crossing::due(double t, double h, const Speeds& speeds, bool adaptive, Arrival& state) {
  const bool is_due = is_due_by(t, h, speeds, adaptive, state);
  if (is_due) state.arrive();
  return is_due;
}

bool Crossing::is_due_by(double t, double h, const Speeds& speeds, bool adaptive, Arrival& state) {
  most_step_ = INFINITY;
  if (!prepared_) return false;
  starting_ = std::exchange(fresh_, false) && starts_near(t, state.arrive());
  if (starting_) return true;
  fastest_ = largest_rate(speeds);
  turned_ += fastest_ * (t - std::exchange(turned_until_, t));
  keep_rows_good(state);
  const bool falls = (falls_to_ < INFINITY || !(fastest_ > 0.0)) &&  // else no distance is near enough
                     falls_to_ - t <= near_enough(usual_length(speeds), h, adaptive);
  if (turned_ + 0.5 * fastest_ * h >= next_look_ || fastest_ * h > coarse || falls) look(t, state);
  if (std::abs(fastest_ - known_rate_) > other_pace * known_rate_) known_ = -INFINITY;
  const bool leaves = std::exchange(leaves_, false);
  const double tau = time_to_pose(t);
  beside_ = 0.0;
  const bool foreseen = tau >= -h && tau < INFINITY;
  if (!foreseen && !leaves) return false;
  const double usual = usual_length(speeds);
  if (!foreseen) {
    if (short_steps * h < usual) beside_ = usual;
    return beside_ > 0.0;
  }
  if (tau <= near_enough(usual, h, adaptive)) return true;
  if (!adaptive) return false;
  const double up_to = tau - before_pose * usual;
  most_step_ = known_ > t ? up_to : std::min(up_to, part_of_foreseen * tau);
  if (!approached_ && up_to < usual && up_to > std::max(short_steps * h, least_beside * usual)) {
    approached_ = true;
    beside_ = up_to;
  }
  return beside_ > 0.0;
}

/// Where the pose is by the least singular value, which goes linearly to zero toward it, and when to look again. It
/// costs two solutions; pivots, which cost nothing, hide some poses until they are a step away.
void Crossing::look(double t, Arrival& state) {
  if (least_.at == t) return;
  WatchedFormulation& formulation = dynamics_.formulation();
  SingularValueAt before =
      std::exchange(least_, ended_.at == t ? ended_ : SingularValueAt{t, least_singular_value(state)});
  const double usual = formulation.usual_least_singular_value(), small = near * std::max(usual, least_usual);
  if (rows_turn_bad(small, least_.value, highest_, state)) {
    least_.value = formulation.least_singular_value();
    before = {};
  }
  const double fall = before.value - least_.value;
  const bool falls = least_.value < small && fall * before.value > resolved && before.at < t;
  falls_to_ = falls ? t + least_.value * (t - before.at) / fall : INFINITY;
  next_look_ = usual > 0.0 ? look_part * (least_.value / usual) : 0.0;
  turned_ = 0.0;
}

double Crossing::least_singular_value(Arrival& state) {
  if (const std::optional<double> value = state.least_singular_value()) return *value;
  state.arrive();
  return dynamics_.formulation().least_singular_value();
}

/// Redundant rows that were well chosen become bad ones where loops turn, before a pose is in sight: they are looked at
/// whenever a measure of them has fallen to a part of the highest since. True where others are left out now.
bool Crossing::rows_turn_bad(double small, double measure, double& highest, Arrival& state) {
  highest = std::max(highest, measure);
  if (measure > std::min(small, fallen * highest)) return false;
  highest = measure;
  state.arrive();
  return dynamics_.formulation().improve_rows();
}

/// By the pivots.
void Crossing::keep_rows_good(Arrival& state) {
  if (const SingularWatch::Sample* latest = dynamics_.watch().latest())
    rows_turn_bad(near * dynamics_.watch().root_of_level(), latest->root, highest_root_, state);
}

/// How far ahead [s] a pose may be for a leap to begin; fixed steps h keep away from it by some of them, as far as it
/// can be foreseen: what falls in a large or slender mechanism, small as it always is, need not come down to zero.
double Crossing::near_enough(double usual, double h, bool adaptive) const {
  if (adaptive) return 0.5 * usual;
  return std::clamp(steps_before * h, 0.5 * usual, (weaker_than_usual() ? farthest : 0.5) * usual) + h;
}

/// By what was usual in this run, not by `least_usual`.
bool Crossing::weaker_than_usual() const {
  const SingularWatch::Sample* latest = dynamics_.watch().latest();
  return (latest && latest->root < near * dynamics_.watch().root_of_level()) ||
         least_.value < near * dynamics_.formulation().usual_least_singular_value();
}

/// Of the nodes from the poses, relative to the length.
double Crossing::nearest_node(const std::vector<double>& poses, double h, int left_out) const {
  double nearest = INFINITY;
  for (int i = 0; i < CollocationStep::stages; ++i)
    if (i != left_out)
      for (const double pose : poses) nearest = std::min(nearest, std::abs(step_.nodes()[i] - pose / h));
  return nearest;
}

/// The one that is left out, where the length cannot be chosen: the run ends beside a pose.
int Crossing::node_in_pose(const Search& search, double h) const {
  if (h < std::min(search.most, search.smooth)) return CollocationStep::none;
  for (int i = 0; i < CollocationStep::stages; ++i)
    for (const double pose : search.poses)
      if (std::abs(step_.nodes()[i] - pose / h) < in_pose_from) return i;
  return CollocationStep::none;
}

/// The length among the allowed ones with which the nodes stay farthest from the poses, in time where it is shorter
/// than wanted, but leads over them; of equals the shortest.
double Crossing::best_length(const Search& search) {
  const double least = limit(search, search.least), grid = search.grid;
  double best = least, distance = -1.0;
  const auto consider = [&](double h) {
    const double nearest = nearest_node(search.poses, h) * std::min(h / least, 1.0);
    if (nearest <= distance + farther) return;
    best = h;
    distance = nearest;
  };
  if (grid > 0.0) {
    const double first = std::max(1.0, std::ceil(least / grid)), last = std::ceil(2.0 * first);
    const double by = std::max(1.0, std::floor((last - first) / 40.0));
    for (double k = first; k <= last; k += by) consider(limit(search, k * grid));
  } else {
    for (double factor = 1.0; factor <= 2.0; factor += 0.025) consider(limit(search, factor * least));
  }
  for (double factor = 0.95; factor > 0.3 && distance < margin; factor -= 0.025)
    if (const double h = allowed_length(search, factor * least); h > search.poses.back()) consider(h);
  return best;
}

double Crossing::limit(const Search& search, double h) {
  h = std::min(h, search.smooth);
  limited_ = limited_ || h >= search.most;
  return std::min(h, search.most);
}

double Crossing::allowed_length(const Search& search, double h) {
  if (search.grid > 0.0) h = std::max(1.0, std::round(h / search.grid)) * search.grid;
  return limit(search, h);
}

bool Crossing::leap(double t, double h, double grid, double most, const VectorXd& y) {
  limited_ = false;
  const double foreseen = time_to_pose(t);
  const SingularWatch::Sample* latest = dynamics_.watch().latest();
  declined_root_ = latest ? latest->root : 0.0;
  declined_least_ = least_.value;
  const auto v = y.segment(dynamics_.system().q_size(), dynamics_.system().v_size());
  const bool beside = std::abs(foreseen) < beside_pose * usual_length(v);
  const bool in_it = starting_ || (beside && latest && latest->root < solvable * dynamics_.watch().root_of_level());
  stepped_in_ = in_it && !starting_;
  if (in_it) step_.begin_in_pose(t, y, stepped_in_ ? drifted : 0.0);
  const Unwatched unwatched(dynamics_);
  if (!in_it && !step_.begin(t, y, !beside)) return false;
  if (beside_ > 0.0) return leap_beside(most, usual_length(v));
  const VectorXd& v_dot = step_.start_accelerations();
  const double usual = usual_length(leap_.y.segment(dynamics_.system().q_size(), v_dot.size()), v_dot);
  const double pose = starting_ ? 0.0 : foreseen;
  Search search{t, grid, most, usual, {pose}, std::max({usual, 2.0 * pose, grid > 0.0 ? h : 0.0})};
  search.base = search.least;
  search.too_far = too_far * near_enough(usual, h, !(grid > 0.0)) + h;
  known_ = -INFINITY;
  if (!try_lengths(search, y)) {
    if (known_ > t && !(grid > 0.0)) most_step_ = known_ - t - before_pose * usual;
    return false;
  }
  leap_ = std::move(search.best);
  leap_.followed = leap_.h;
  dynamics_.formulation().watch().forget_trend();
  forget_looks();
  if (!leap_.poses.empty() && leap_.poses.back() > leap_.h) {  // something ends it before
    known_ = leap_.t + leap_.poses.back();
    known_rate_ = fastest_;
  }
  leaves_ = !(grid > 0.0);
  return true;
}

/// Near a pose explicit steps become short, as what their stages violate counts by 1 / sigma: up to where the leap over
/// it begins well, and away from it, there is one more on each side, in which no pose is.
bool Crossing::leap_beside(double most, double usual) {
  while (beside_ > least_beside * usual && beside_ <= most && step_.attempt(beside_).good()) {
    const std::vector<double> poses = poses_in_leap(1.0);
    if (poses.empty() || beside_ < poses.front() - 0.5 * before_pose * usual) return switches_in_leap() == INFINITY;
    beside_ = std::min(0.9 * beside_, poses.front() - before_pose * usual);
  }
  return false;
}

double Crossing::shorter_step(double t, double h) {
  if (!prepared_ || least_.at != t || fastest_ * h <= coarse) return INFINITY;
  ended_ = {t + h, dynamics_.formulation().least_singular_value()};
  const double fall = least_.value - ended_.value, way = h * least_.value / fall;
  return fall > 0.0 && h > most_of_way * way ? part_of_foreseen * way : INFINITY;
}

void Crossing::forget_looks() {
  declined_root_ = declined_least_ = 0.0;
  approached_ = leaves_ = false;
  least_ = {};
  falls_to_ = INFINITY;
  next_look_ = 0.0;
}

void Crossing::keep(Archive& archive, bool leaping) {
  archive(in_loops_, prepared_, starting_, in_pose_, fresh_, least_.at, least_.value, most_step_, fastest_);
  archive(falls_to_, next_look_, turned_, turned_until_, highest_, highest_root_, declined_least_, declined_root_);
  archive(known_, known_rate_, approached_, leaves_, ended_.at, ended_.value, poses_);
  if (leaping) archive(leap_);
}

void Crossing::cut(double length) {
  limited_ = true;
  leap_.followed = length;
  step_.state_at(length, leap_.y_new);
}

/// A part of the way to the pose that is foreseen: it tells where the pose is.
bool Crossing::look_ahead(Search& search) {
  if (!(search.poses.front() > 0.0)) return false;
  if (!step_.attempt(limit(search, part_of_way * search.poses.front())).converged) return false;
  std::vector<double> poses = poses_in_leap(1.0);
  if (poses.empty()) return false;
  search.poses = std::move(poses);
  return true;
}

/// False where no leap was found.
bool Crossing::try_lengths(Search& search, const VectorXd& y) {
  for (int k = 0; k < most_attempts && !search.done && std::isfinite(search.least); ++k) {
    const double other = other_lengths[std::max(search.failures - 2, 0)] * limit(search, search.base);
    const double h = search.failures < 2 ? best_length(search) : allowed_length(search, other);
    const std::pair attempt{h, node_in_pose(search, h)};
    if (std::find(search.tried.begin(), search.tried.end(), attempt) != search.tried.end()) {
      search.failures = std::max(search.failures + 1, 2);
      continue;
    }
    search.tried.push_back(attempt);
    const CollocationStep::Quality quality = step_.attempt(attempt.first, attempt.second);
    if (quality.converged) {
      weigh(search, quality);
      continue;
    }
    search.failures += 1;
    if (search.failures > 1 || search.ahead) continue;
    search.ahead = look_ahead(search);
    if (!search.ahead) search.failures = 2;
  }
  if (search.error < INFINITY) return true;
  const bool moves = step_.size(y.segment(dynamics_.system().q_size(), dynamics_.system().v_size())) > 0.0;
  if (starting_ && !search.any_converged && moves && in_pose_) throw_no_branch(search.t);
  return false;
}

/// A leap that converged: the best so far, or what the next one should be.
void Crossing::weigh(Search& search, CollocationStep::Quality quality) {
  search.any_converged = search.ahead = true;
  search.failures = 1;
  if (starting_ && quality.jump > no_branch && in_pose_) throw_no_branch(search.t);
  search.poses = leap_.poses = poses_in_leap(0.5);
  search.done = search.poses.empty();
  if (!starting_ && !search.done && search.poses.front() > search.too_far) {
    known_ = search.t + search.poses.front();
    known_rate_ = fastest_;
    search.done = true;
  }
  if (search.done) return;
  if (beside_a_pose(leap_.h)) step_.end_as_it_is(quality);
  const double nearest = nearest_node(search.poses, leap_.h, step_.left_out()), last = search.poses.back();
  const double end = std::min(search.most, search.smooth);  // something ends it there
  const bool beyond = last > leap_.h && leap_.h < end, clear = nearest >= margin && !beyond;
  const bool over = search.poses.front() <= leap_.h || leap_.h >= end;
  quality.roundoff = precision * elementary::power(search.usual / (reach * nearest * leap_.h), 2.0);
  if (quality.fair() && !stays_before_switches(search)) return;
  if (quality.fair()) quality.unseen = step_.unseen(search.grid > 0.0 ? search.grid : leap_.h / looked_at_between);
  search.done = quality.good() && clear;
  if (search.done || (over && quality.fair() && nearest >= least_margin && quality.error() < search.error)) {
    search.best = leap_;
    search.error = quality.error();
  }
  if (beyond) search.least = 2.0 * last;
  else if (!quality.good())
    search.least = search.base = std::max(0.6 * std::min(search.base, leap_.h), least_part * search.usual);
}

/// Else it is to be shorter, or there is none.
bool Crossing::stays_before_switches(Search& search) {
  const double until = switches_in_leap();
  if (!(until < leap_.h)) return true;
  double most = before_switch * until;
  if (search.grid > 0.0) most = std::floor(most / search.grid) * search.grid;
  search.smooth = most;
  search.least = search.base = most > least_part * search.usual ? most : INFINITY;
  return false;
}

/// Where in the leap the first one is, in s from its start; infinite: there is none.
double Crossing::switches_in_leap() {
  const double part = touches_.clear_until(*this, {leap_.t, leap_.h, leap_.y, leap_.y_new});
  return part < 1.0 ? part * leap_.h : INFINITY;
}

/// A small pivot alone is no sign: that of a long chain, or beside bodies of little mass, is small in every pose.
bool Crossing::in_singular_pose(double t, const VectorXd& y) const {
  const System& system = dynamics_.system();
  const VectorXd q = y.head(system.q_size());
  return examine_pose(system, {t, q, dynamics_.history()}, dynamics_.dropped().rows(), in_pose).singular;
}

void Crossing::throw_no_branch(double t) const {
  ErrorDetails details;
  details.time = t;
  throw SingularSystemError("no_branch",
                            "the mechanism is in a singular pose, where branches of motion meet, with velocities that "
                            "belong to none of them; give velocities of one branch, or another pose",
                            details);
}

/// Times from the start of a leap that converged, ascending; the first may be just before it, the last may be foreseen
/// by so many lengths beyond its end. Empty: there is none.
std::vector<double> Crossing::poses_in_leap(double beyond_it) {
  const auto value = [&](double at) {
    step_.state_at(at, y_);
    return poses_.value_at(leap_.t + at, y_);
  };
  std::vector<SingularValueAt> samples;
  const auto sample = [&](double at) { samples.push_back({at, value(at)}); };
  const auto sample_between = [&](double before, double after) {  // where the lines to zero meet
    const double left = value(before), right = value(after);
    samples.push_back({before, left});
    if (left > 0.0) sample(before + (after - before) * left / (left + right));
  };
  sample_between(0.0, step_.nodes()[0] * leap_.h);
  for (int i = 0; i < CollocationStep::stages; ++i) sample(step_.nodes()[i] * leap_.h);
  sample_between(step_.nodes()[CollocationStep::stages - 1] * leap_.h, leap_.h);
  samples.erase(samples.end() - 2);
  sample(leap_.h);
  std::vector<double> found;
  if (in_pose_ && starting_) found.push_back(0.0);
  const SingularValueAt &start = samples[0], &next = samples[1];
  const double behind = start.value * (next.at - start.at) / (next.value - start.value);  // one that was just passed
  if (found.empty() && next.value > start.value && behind < beside_pose * leap_.h) found.push_back(-behind);
  const double apart = same_pose * leap_.h;
  for (std::size_t k = 1; k + 1 < samples.size(); ++k) {
    const SingularValueAt &a = samples[k - 1], &b = samples[k], &c = samples[k + 1];
    if (!(b.value <= a.value && b.value < c.value)) continue;
    const SingularValueAt least = least_value(a, b, c, value);
    if (!vanishes(a, least, c)) continue;
    const SingularValueAt& first = samples[std::max<std::size_t>(k, 2) - 2];
    const SingularValueAt& last = samples[std::min(k + 2, samples.size() - 1)];
    for (const SingularValueAt& zero : zeros_around(least, first, last, value))
      if (found.empty() || zero.at > found.back() + apart) found.push_back(zero.at);
  }
  const SingularValueAt &before = *(samples.end() - 2), &end = samples.back();
  const double fall = (before.value - end.value) / (end.at - before.at), beyond = end.value / fall;
  if (fall > 0.0 && beyond < beyond_it * leap_.h) found.push_back(leap_.h + beyond);
  return found;
}

bool Crossing::look_back(double t, double h, const VectorXd& y) {
  if (!prepared_ || poses_.last() >= t - same_time * h) return false;
  const bool looked = least_.at == t;
  if (looked && fastest_ * h > coarse) return poses_.pass(t, least_.value, y, parts_to(t));
  const auto sample = dynamics_.watch().sample(t, same_time * h);
  if (!sample) return false;
  if (!(sample->root < looked_at * dynamics_.watch().root_of_level())) return poses_.pass(t, sample->root, y);
  const double least = looked ? least_.value : poses_.value_at(t, y);
  return poses_.pass(t, least, y) || !looked;
}

void Crossing::look_into_leap(double until) {
  if (!starting_) poses_.look_to(leap_.t, leap_.y);
  for (const double pose : leap_.poses)
    if ((pose > 0.0 || stepped_in_) && leap_.t + pose < until &&
        leap_.t + pose > poses_.last_listed() + same_pose * leap_.h) {
      step_.state_at(pose, y_);
      poses_.list(leap_.t + pose, y_);
    }
  step_.state_at(until - leap_.t, y_);
  poses_.restart(until > poses_.last_listed() + same_pose * leap_.h);
  poses_.pass(until, poses_.value_at(until, y_), y_);
}

bool Crossing::end(double t, const VectorXd& y) {
  if (prepared_) poses_.finish(t, y, parts_to(t));
  return prepared_;
}

}  // namespace linkwork
