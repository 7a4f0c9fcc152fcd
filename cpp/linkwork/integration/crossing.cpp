#include "linkwork/integration/crossing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/constraints/closed_loops.hpp"
#include "linkwork/constraints/displacement.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double fastest = 0.8;  // of a leap [rad]: what any body turns
constexpr double near = 0.3;     // of the usual least singular value, or root of the smallest pivot: else none is due
constexpr double near_at_start = 0.1;                         // that root, before there is a usual one
constexpr double roundoff = 1e-7;                             // that root, where nothing is left of a pivot
constexpr double way_at_start = 0.03, change_at_start = 0.1;  // [rad], and of the root there, relative, toward a pose
constexpr double passed_at_start = 2.0;                       // the same, where that way leads over the pose
constexpr double left_behind = 0.05;                          // [rad] so far behind the start a pose does not matter
constexpr double least_usual = 0.15;  // the usual value of both, for runs that begin near a pose
constexpr double in_pose = 1e-5;      // at the start: rows that near each other, and only a leap leads out of it
constexpr double looked_at = 0.2;     // of the usual root: nearer, pivots do not tell when a pose is passed
constexpr double look_part = 0.1;     // rad to the next look, where the least singular value is the usual one
constexpr double coarse = 0.02;       // a step in which a body turns so far [rad] may pass a pose that no pivot shows
constexpr double coarsest = 0.1, most_parts = 20;  // of the way between states that are looked at [rad]
constexpr double resolved = 1e-15;        // of the square of the least singular value: changes by less are none
constexpr double fallen = 0.4;            // part of either, for another look at redundant rows
constexpr double steps_before = 15.0;     // so many fixed steps before the pose a usual one is no longer taken
constexpr double farthest = 2.0;          // usual leaps: no pose is foreseen beyond
constexpr double part_of_foreseen = 0.5;  // way to a pose that usual steps go, as it may be nearer
constexpr double most_of_way = 0.75;      // that they may have gone where it was not foreseen
constexpr double short_steps = 4.0;       // of which a leap beside the pose is worth so many
constexpr double same_time = 1e-9;        // relative to the step
constexpr double other_pace = 0.2;        // change of the rate with which a pose that was found is not relied on
constexpr double touching = 1e-12;        // depths, relative to the length

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
    least = std::min(least, time_of(way, step_.rate(body, v), step_.rate(body, v_dot)));
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
  Speeds out;
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    const bool in_loop = in_loops_[static_cast<std::size_t>(body)];
    const Vec3<double> axis = step_.rotors().col(body), r_dot = v.segment<3>(6 * body);
    Vec3<double> omega = v.segment<3>(6 * body + 3);
    omega -= axis * axis.dot(omega);
    double* const squares = in_loop ? out.inside : out.outside;
    squares[0] = std::max(squares[0], r_dot.squaredNorm());
    squares[1] = std::max(squares[1], omega.squaredNorm());
    if (!in_loop) continue;
    out.linear = std::max(out.linear, r_dot.cwiseAbs().maxCoeff());
    out.angular = std::max(out.angular, omega.cwiseAbs().maxCoeff());
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
  if (in_pose_) {
    poses_.list(t, y);
    depart(t, y);
  }
  return near_pose;
}

/// Where pivots tell no poses, the one of the model is known.
void Crossing::begin_unwatched(double t, const VectorXd& y) {
  if (std::exchange(fresh_, false) && !dynamics_.rank().singular_rows.empty() && in_singular_pose(t, y)) depart(t, y);
}

/// Looks where the mechanism can go from a singular pose, in which `dynamics` is evaluated.
void Crossing::depart(double t, const VectorXd& y) {
  const System& system = dynamics_.system();
  const VectorXd q = y.head(system.q_size());
  DepartureSearch search(system, dynamics_.dropped().rows(), {t, q, dynamics_.history()});
  const VectorXd v = y.segment(system.q_size(), system.v_size());
  Departure found = search.find(v, dynamics_.evaluation().g.head(system.v_size()));
  if (found.kind == Departure::Kind::of_no_branch) throw_no_branch(t);
  if (found.kind == Departure::Kind::several_motions) throw_several_motions(t);
  if (found.kind == Departure::Kind::no_motion) throw_no_motion(t);
  departing_ = std::move(found.v_dot);
  decided_ = found.decided;
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

/// Of the components of the motions in loops, on which poses depend [rad/s].
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
  if (!prepared_) {
    begin_unwatched(t, y);
    return false;
  }
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
  check_passage(t, state);
  const bool falls = (falls_to_ < INFINITY || speeds.none()) &&  // else no distance is near enough
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

/// Velocities of bodies in loops, relative to the length; a rotor's own rotation is none.
VectorXd Crossing::of_loops(const ConstVector& v) const {
  VectorXd out = VectorXd::Zero(v.size());
  for (int body = 0; body < dynamics_.system().body_count(); ++body) {
    if (!in_loops_[static_cast<std::size_t>(body)]) continue;
    const Vec3<double> axis = step_.rotors().col(body), omega = v.segment<3>(6 * body + 3);
    out.segment<3>(6 * body) = v.segment<3>(6 * body) / step_.length();
    out.segment<3>(6 * body + 3) = omega - axis * axis.dot(omega);
  }
  return out;
}

void Crossing::begin_passage(double t, const VectorXd& y, double ahead) {
  const VectorXd v = of_loops(y.segment(dynamics_.system().q_size(), dynamics_.system().v_size()));
  passage_.begin(t, y, v, std::isfinite(ahead) ? std::abs(ahead) * fastest_ : 0.0);
}

/// Where usual steps have come away from a pose.
void Crossing::check_passage(double t, Arrival& state) {
  passage_.go_on(t, fastest_);
  if (!passage_.over()) return;
  const System& system = dynamics_.system();
  const VectorXd v = of_loops(state.arrive().segment(system.q_size(), system.v_size()));
  VectorXd v_dot(system.v_size()), lambda(system.row_count());
  dynamics_.accelerations(v_dot, lambda);
  if (passage_.left_branch(v, of_loops(v_dot))) compare_with_motion(t, v);
  passage_.forget();
}

/// With these velocities after the passage: the motion of a mechanism that passes a singular pose at a distance bends
/// as if it went over to another branch.
void Crossing::compare_with_motion(double t, const VectorXd& v) {
  const Dynamics::Place place = dynamics_.place();
  ResolvedMotion motion(dynamics_, step_);
  const bool resolved = motion.follow(passage_.begun(), passage_.y(), t);
  const auto its_v = motion.y().segment(dynamics_.system().q_size(), v.size());
  if (!resolved || Passage::differ(v, of_loops(its_v))) throw_left_branch(t, motion, resolved);
  dynamics_.return_to(place);
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
  archive(known_, known_rate_, approached_, leaves_, ended_.at, ended_.value, poses_, passage_);
  if (leaping) archive(leap_);
}

/// A small pivot alone is no sign: that of a long chain, or beside bodies of little mass, is small in every pose.
bool Crossing::in_singular_pose(double t, const VectorXd& y) {
  const System& system = dynamics_.system();
  const VectorXd q = y.head(system.q_size());
  PoseExamination found = examine_pose(system, {t, q, dynamics_.history()}, dynamics_.dropped().rows(), in_pose);
  joints_ = std::move(found.joints);
  return found.singular;
}

bool Crossing::look_back(double t, double h, const VectorXd& y) {
  if (!prepared_ || poses_.last() >= t - same_time * h) return false;
  const bool looked = least_.at == t;
  if (looked && fastest_ * h > coarse) return poses_.pass(t, least_.value, y, parts_to(t));
  const auto sample = dynamics_.watch().sample(t, same_time * h);
  if (!sample) return false;
  if (!(sample->root < looked_at * dynamics_.watch().root_of_level()) &&
      !(looked && dynamics_.formulation().in_parts()))
    return poses_.pass(t, sample->root, y);
  const double least = looked ? least_.value : poses_.value_at(t, y);
  return poses_.pass(t, least, y) || !looked;
}

bool Crossing::end(double t, const VectorXd& y) {
  if (prepared_) poses_.finish(t, y, parts_to(t));
  return prepared_;
}

}  // namespace linkwork
