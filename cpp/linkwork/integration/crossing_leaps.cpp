#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/integration/crossing.hpp"
#include "linkwork/math/elementary.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/names.hpp"

/// How long leaps are, and what is in them.
namespace linkwork {
namespace {

constexpr double least_part = 0.1;      // of a usual leap, for those over a motion that varies more
constexpr double drifted = 1e-3;        // farthest that a run that steps into a pose is off the constraints [rad]
constexpr double least_margin = 0.006;  // of nodes from the pose, relative to the leap, where nothing better is found
constexpr double in_pose_from = 0.03;   // the same: where such a node is left out if it must be there
constexpr double few_digits = 1e-3;     // [rad] from a pose: where a run begins, nodes so near to it are left out
constexpr double most_growth = 1.6;     // of a motion in a leap from its start: log of the factor
constexpr double same_pose = 1e-2;      // relative to a leap
constexpr double farther = 1e-3;        // the same, of nodes from poses: what makes a length the better one
constexpr int most_attempts = 12;
// Of the length, where a leap does not converge: a node may be in the pose, or the leap too long.
constexpr double other_lengths[most_attempts] = {0.85, 1.15, 0.7, 0.6, 0.5, 1.3, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15};
constexpr double precision = 1e-16;         // of solutions, relative to the square of the angle to the pose
constexpr double part_of_blur = 0.05;       // for that, far from the origin
constexpr double looked_at_between = 36.0;  // times, where steps are adaptive: the eight nodes are not all that counts
constexpr double beside_pose = 0.05;        // of a leap: so near nothing is projected
constexpr double too_far = 1.5;             // of the usual distance to the pose: steps go on before the leap
constexpr double part_of_way = 0.8;         // to a foreseen pose
constexpr std::size_t named = 8;            // joints in an error
constexpr double near_pose_passed = 0.1;    // rows that near each other, where usual steps pass a pose
constexpr double before_switch = 0.9;       // of the way to where a contact or a stop begins or ends

}  // namespace

/// Of the nodes from the poses, relative to the length.
double Crossing::nearest_node(const std::vector<double>& poses, double h, int left_out) const {
  double nearest = INFINITY;
  for (int i = 0; i < CollocationStep::stages; ++i)
    if (i != left_out)
      for (const double pose : poses) nearest = std::min(nearest, std::abs(step_.nodes()[i] - pose / h));
  return nearest;
}

/// The one that is left out: the first of a slow start, or where the length cannot be chosen, as the run ends there.
int Crossing::node_in_pose(const Search& search, double h) const {
  if (starting_ && starts_with_node_in_pose(search, h)) return 0;
  if (h < std::min(search.most, search.smooth)) return CollocationStep::none;
  for (int i = 0; i < CollocationStep::stages; ++i)
    for (const double pose : search.poses)
      if (std::abs(step_.nodes()[i] - pose / h) < in_pose_from) return i;
  return CollocationStep::none;
}

/// A slow start leaves a pose by little up to the first node.
bool Crossing::starts_with_node_in_pose(const Search& search, double h) const {
  return std::any_of(search.poses.begin(), search.poses.end(),
                     [&](double pose) { return step_.way(pose, step_.nodes()[0] * h) < few_digits; });
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
  if (in_it) step_.begin_in_pose(t, y, stepped_in_ ? drifted : 0.0, starting_ && in_pose_ ? departing_ : VectorXd());
  const Unwatched unwatched(dynamics_);
  if (!in_it && !step_.begin(t, y, !beside)) return false;
  if (beside_ > 0.0) return leap_beside(most, usual_length(v));
  const VectorXd& v_dot = step_.start_accelerations();
  double usual = usual_length(leap_.y.segment(dynamics_.system().q_size(), v_dot.size()), v_dot);
  if (starting_ && std::isfinite(usual)) usual = std::min(usual, most_growth / step_.growth_to(std::min(usual, most)));
  const double pose = starting_ ? 0.0 : foreseen;
  Search search{t, grid, most, usual, {pose}, std::max({usual, 2.0 * pose, grid > 0.0 ? h : 0.0})};
  search.base = search.least;
  search.too_far = too_far * near_enough(usual, h, !(grid > 0.0)) + h;
  known_ = -INFINITY;
  if (!try_lengths(search)) {
    if (known_ > t && !(grid > 0.0)) most_step_ = known_ - t - before_pose * usual;
    else if (!search.done && std::isinf(search.smooth)) begin_passage(t, y, foreseen);
    return false;
  }
  leap_ = std::move(search.best);
  leap_.followed = leap_.h;
  dynamics_.formulation().watch().forget_trend();
  forget_looks();
  passage_.forget();
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
bool Crossing::try_lengths(Search& search) {
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
  if (starting_ && in_pose_ && decided_ && std::isinf(search.smooth)) throw_not_left(search.t);
  return false;
}

/// A leap that converged: the best so far, or what the next one should be.
void Crossing::weigh(Search& search, CollocationStep::Quality quality) {
  search.ahead = true;
  search.failures = 1;
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
  const double roundoff = std::max(precision, part_of_blur * step_.blur());
  quality.roundoff = roundoff * elementary::power(search.usual / (reach * nearest * leap_.h), 2.0);
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

void Crossing::throw_in_this_pose(double t, const char* code, const std::string& does, const std::string& why,
                                  const std::string& where) const {
  ErrorDetails details;
  details.time = t;
  for (const int joint : joints_) details.joints.push_back(dynamics_.system().model().joint_name(joint));
  const std::string of = details.joints.empty() ? "" : " of " + quoted(details.joints, ", ", named);
  throw SingularSystemError(code, "the mechanism " + does + " " + where + " a singular pose" + of + ", " + why,
                            details);
}

void Crossing::throw_no_branch(double t) const {
  throw_in_this_pose(t, "no_branch", "is",
                     "where branches of motion meet, with velocities that belong to none of them; give velocities of "
                     "one branch, or another pose");
}

void Crossing::throw_not_left(double t) const {
  throw_in_this_pose(t, "singular_pose", "is",
                     "and its motion along the branch of its velocities could not be followed; begin before or behind "
                     "that pose");
}

void Crossing::throw_left_branch(double t, const ResolvedMotion& motion, bool resolved) {
  const System& system = dynamics_.system();
  const VectorXd q = motion.nearest_y().head(system.q_size());
  const TimedPose nearest{motion.nearest_t(), q, dynamics_.history()};
  joints_ = examine_pose(system, nearest, dynamics_.dropped().rows(), near_pose_passed).joints;
  if (!resolved)
    throw_in_this_pose(t, "singular_pose", "went over to another branch",
                       "which no leap led over; begin elsewhere, or give another step or other tolerances",
                       motion.in_pose() ? "in" : "beside");
  throw_in_this_pose(t, "singular_pose", "left its motion",
                     "which bends there within a step; give a shorter step or smaller tolerances", "beside");
}

void Crossing::throw_several_motions(double t) const {
  throw_in_this_pose(t, "several_motions", "rests",
                     "where branches of motion meet: several motions are possible from rest there; turn it a little "
                     "along the branch that is meant, or give velocities of that branch");
}

void Crossing::throw_no_motion(double t) const {
  throw_in_this_pose(t, "no_motion", "rests",
                     "where it can move by infinitesimal amounts only, and forces act along these: no finite reactions "
                     "hold it; give it other dimensions or another pose, or a bushing for a joint");
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

}  // namespace linkwork
