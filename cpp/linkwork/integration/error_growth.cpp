#include "linkwork/integration/error_growth.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/integration/energies_made.hpp"
#include "linkwork/integration/state_difference.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/math/rotation.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

constexpr double fewest_errors = 1.0, most_errors = 6.0;
constexpr double least = 1e-250;  // error that is one at all
constexpr double small = 1e-7;    // of lengths and speeds: perturbations that stand for a derivative
// From one state to the next, at most: of lengths, speeds and angles; rate of an error times the time between.
constexpr double near = 0.25, resolved = 0.6;
// Of its velocity, by how much that of a cubic may be another one; of the largest of all, which is none.
constexpr double smooth = 0.03, none = 1e-12;
// By how much two stages of a step may differ, relative to the error; far beyond the step is taken again in parts.
constexpr double usual_difference = 2e-3, fine_difference = 4e-5, too_far = 10.0;
constexpr double most_parts = 64.0, least_way = 0.1, least_density = 0.5;
constexpr double forgotten = 0.7;  // of the rate of an error, from one step to the next
constexpr double fast = 0.02;      // share of the largest kinetic energy so far
constexpr double at_all = 1e-12;   // of that of the largest speed: below, differences of energies are rounding
// Steps for each that the motion alone would ask for; evaluations in one, of each error as errors begin later.
constexpr double usual_density = 2.0, of_motion = 2.0, of_error = 2.4;
// Growth, relative to that of regular motion, from which it is followed farther, and from which it is found again in
// finer steps; by so many times the evaluations.
constexpr double suspicious = 4.0, doubtful = 20.0;
constexpr std::int64_t more = 5, most_of_bodies = 1'500'000;  // evaluations of one

/// An error of a state, in space: of each body dr, dphi, dv, and d omega in body axes.
struct Perturbation {
  std::size_t place = 0;   ///< among the errors that were asked for
  VectorXd way, velocity;  ///< (6n,) each
  VectorXd acceleration;   ///< what it makes of v_dot
  VectorXd largest;        ///< of each part, relative to the beginning, so far
  VectorXd first;          ///< size at the beginning
  VectorXd energy;         ///< likewise [J]
  double rate = 0.0;       ///< [1/s]
};

bool all_holonomic(const Model& model) {
  for (int k = 0; k < static_cast<int>(model.joints().size()); ++k)
    if (!model.special_joint(k) && joint_kinds()[model.joints()[k].kind].info.velocity_rows() > 0) return false;
  return true;
}

bool all_may_conserve(const System& system) {
  const std::vector<bool> parts = may_conserve(system);
  return system.inerters().empty() && std::all_of(parts.begin(), parts.end(), [](bool it) { return it; });
}

class GrowthSearch {
 public:
  GrowthSearch(Dynamics& dynamics, const StateLog& log, const MovingAxes& axes, const VectorXd& lengths,
               const VectorXd& speeds, double difference)
      : dynamics_(dynamics),
        system_(dynamics.system()),
        connected_(ConnectedParts::of(system_)),
        log_(log),
        axes_(axes),
        lengths_(lengths),
        speeds_(speeds),
        most_difference_(difference),
        conservative_(all_may_conserve(dynamics.system())),
        holonomic_(all_holonomic(dynamics.system().model())),
        other_v_dot_(system_.v_size()),
        lambda_(VectorXd::Zero(system_.row_count())),
        most_change_(VectorXd::Zero(lengths.size())) {
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      most_change_[part] += at_all / fast * system_.mass(body) * speeds[part] * speeds[part];
    }
  }

  struct Plan {
    std::size_t count;  ///< of errors to follow
    double until;       ///< [s]
  };

  /// What so many evaluations are enough for, as far as the motion tells.
  Plan plan(std::int64_t most) {
    const double steps = static_cast<double>(most) / usual_density, fewest = of_motion + of_error * fewest_errors;
    double taken = 0.0;
    std::size_t k = 0;
    while (k + 1 < log_.size() && taken * fewest < steps) {
      here_.y = log_.y(k);
      here_.t = log_.t(k);
      const std::size_t following = next_state(k, INFINITY);
      taken += std::max(std::ceil(distance(following)), 1.0);
      k = following;
    }
    const double count = (steps / std::max(taken, 1.0) - of_motion) / of_error;
    return {static_cast<std::size_t>(std::clamp(count, fewest_errors, most_errors)), log_.t(k)};
  }

  std::vector<ErrorGrowth> find(const std::vector<StepDifference>& errors, std::int64_t most) {
    most_ = most;
    std::vector<ErrorGrowth> out;
    try {
      follow(errors, out);
    } catch (const std::exception& error) {  // functions of the user's throw what they like
      if (is_interruption(error)) throw;
    }
    for (ErrorGrowth& it : out) it.until = reached_;
    for (const Perturbation& it : carried_) out[it.place].of_part = it.largest;
    return out;
  }

 private:
  struct Place {
    double t = 0.0;
    VectorXd y, v_dot;
    VectorXd violations, rates;  ///< of the rows
    VectorXd forces;
  };

  static Eigen::Index r_of(int body) { return position_size * static_cast<Eigen::Index>(body); }
  static Eigen::Index v_of(int body) { return velocity_size * static_cast<Eigen::Index>(body); }

  /// As far as the log and the evaluations go.
  void follow(const std::vector<StepDifference>& errors, std::vector<ErrorGrowth>& out) {
    std::size_t next = 0;
    if (!go_to(log_.t(0), log_.y(0), 0)) return;
    reached_ = here_.t;
    for (std::size_t k = 0;;) {
      for (; next < errors.size() && errors[next].t <= log_.t(k); ++next)
        if (begin(out.size(), errors[next])) out.push_back({errors[next].t, errors[next].t, carried_.back().largest});
      if (k + 1 == log_.size()) return;
      const std::size_t following = next_state(k, next < errors.size() ? errors[next].t : INFINITY);
      if (!carry(k, following)) return;
      k = following;
    }
  }

  /// With the accelerations there; memories as in state k of the log.
  bool go_to(double t, const VectorXd& y, std::size_t k) {
    look_for_interruption();
    here_.t = t;
    here_.y = y;
    dynamics_.set_history(log_.history(k));
    here_.v_dot.resize(system_.v_size());
    if (!accelerate(here_.y, here_.v_dot)) return false;
    here_.violations = dynamics_.evaluation().Phi;
    here_.rates = dynamics_.evaluation().Phi_dot;
    here_.forces = dynamics_.evaluation().g.head(system_.v_size());
    conservative_ = conservative_ && dynamics_.evaluation().power == 0.0;
    return true;
  }

  bool accelerate(const VectorXd& y, VectorXd& v_dot) {
    evaluations_ += 1;
    dynamics_.evaluate(here_.t, y);
    if (!on_the_same_sides(dynamics_.evaluation().switches)) return false;
    dynamics_.accelerations(v_dot, lambda_);
    return evaluations_ <= most_ && v_dot.allFinite();
  }

  /// As at the start: a contact or a stop may begin between two states that know of none.
  bool on_the_same_sides(const VectorXd& switches) {
    if (sides_.size() != switches.size()) sides_ = switches;
    for (Eigen::Index k = 0; k < switches.size(); ++k)
      if ((switches[k] > 0.0) != (sides_[k] > 0.0)) return false;
    return true;
  }

  /// Of each part: the largest of poses and of velocities.
  VectorXd size(const VectorXd& way, const VectorXd& velocity) const {
    VectorXd out = VectorXd::Zero(lengths_.size());
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      const double L = lengths_[part], V = speeds_[part];
      const Eigen::Index v = v_of(body);
      if (!(V > 0.0)) continue;
      out[part] = std::max({out[part], way.segment<3>(v).norm() / L, way.segment<3>(v + 3).norm(),
                            velocity.segment<3>(v).norm() / V, velocity.segment<3>(v + 3).norm() * L / V});
    }
    return out;
  }

  /// The state, moved along by so much.
  VectorXd moved(const VectorXd& way, const VectorXd& velocity, double by) const {
    VectorXd y = here_.y;
    for (int body = 0; body < system_.body_count(); ++body) {
      y.segment<3>(r_of(body)) += by * way.segment<3>(v_of(body));
      const Vec3<double> half = 0.5 * by * way.segment<3>(v_of(body) + 3);
      y.segment<4>(r_of(body) + 3) +=
          quaternion_product<double>({0.0, half[0], half[1], half[2]}, here_.y.segment<4>(r_of(body) + 3));
    }
    system_.normalize(y.head(system_.q_size()));
    y.segment(system_.q_size(), system_.v_size()) += by * velocity;
    return y;
  }

  /// What of `twist` the joints allow: nearest in the metric of the masses, so that D x = b.
  VectorXd allowed(const VectorXd& twist, const VectorXd& b) {
    VectorXd momenta(system_.v_size()), out(system_.v_size());
    system_.multiply_mass(dynamics_.evaluation(), twist, momenta);
    dynamics_.solve(momenta, b, out, lambda_);
    return out;
  }

  /// What rotates, from axes of bodies to those of space.
  void turn(VectorXd& twist) const {
    for (int body = 0; body < system_.body_count(); ++body) {
      const auto rotation = twist.segment<3>(v_of(body) + 3);
      twist.segment<3>(v_of(body) + 3) =
          (rotation_matrix<double>(here_.y.segment<4>(r_of(body) + 3)) * rotation).eval();
    }
  }

  /// As if it were one of the state where this is; false: there is none, or nothing is known of it.
  bool begin(std::size_t place, const StepDifference& error) {
    const Eigen::Index q_size = system_.q_size(), v_size = system_.v_size();
    Perturbation it;
    it.place = place;
    it.way.resize(v_size);
    it.velocity = error.run.segment(q_size, v_size) - error.exact.segment(q_size, v_size);
    for (int body = 0; body < system_.body_count(); ++body) {
      it.way.segment<3>(v_of(body)) = error.run.segment<3>(r_of(body)) - error.exact.segment<3>(r_of(body));
      it.way.segment<3>(v_of(body) + 3) =
          StateDifference::turn(error.run.segment<4>(r_of(body) + 3), error.exact.segment<4>(r_of(body) + 3));
    }
    take_violations_back(it);
    it.first = size(it.way, it.velocity);
    if (!is_some(it.first)) return false;
    it.largest = VectorXd::Ones(lengths_.size());
    it.energy = energies(it);
    if (evaluations_ > most_ || !find_acceleration(it)) return false;
    carried_.push_back(std::move(it));
    return true;
  }

  static bool is_some(const VectorXd& size) { return size.maxCoeff() > least && size.allFinite(); }

  /// Of the error, which stabilization does. Rows of velocities alone, of wheels that roll, say nothing of poses.
  void take_violations_back(Perturbation& it) {
    if (system_.row_count() == 0) return turn(it.way);
    evaluations_ += 3;
    dynamics_.evaluate(here_.t, here_.y);
    const VectorXd rates = dynamics_.evaluation().Phi_dot;
    if (holonomic_) it.way = allowed(it.way, VectorXd::Zero(system_.row_count()));
    turn(it.way);
    const double by = small / std::max(size(it.way, it.velocity).maxCoeff(), least);
    dynamics_.evaluate(here_.t, moved(it.way, VectorXd::Zero(system_.v_size()), by));
    const VectorXd b = (rates - dynamics_.evaluation().Phi_dot) / by;
    dynamics_.evaluate(here_.t, here_.y);
    it.velocity = allowed(it.velocity, b);
  }

  bool find_acceleration(Perturbation& it) {
    const double by = small / size(it.way, it.velocity).maxCoeff();
    if (!accelerate(moved(it.way, it.velocity, by), other_v_dot_)) return false;
    it.acceleration = (other_v_dot_ - here_.v_dot) / by;
    const double a = weighed(it.acceleration), v = weighed(it.velocity), x = weighed(it.way);
    const double rate = a > 0.0 ? a / std::sqrt(v * v + a * x) : 0.0;
    it.rate = std::max(rate, forgotten * it.rate);
    return true;
  }

  /// What steps of this length leave of the equations of the joints, which else grows with the square of time.
  void go_back_to_constraints(Perturbation& it) {
    const double by = small / size(it.way, it.velocity).maxCoeff();
    const VectorXd violations = (here_.violations - dynamics_.evaluation().Phi) / by;
    const VectorXd rates = (here_.rates - dynamics_.evaluation().Phi_dot) / by;
    const VectorXd none = VectorXd::Zero(system_.v_size());
    VectorXd x(system_.v_size());
    dynamics_.solve(none, violations, x, lambda_);
    turn(x);
    it.way += x;
    dynamics_.solve(none, rates, x, lambda_);
    it.velocity += x;
  }

  /// By which the error changes those of the parts, to the first order: g has the torque - omega x J omega, which does
  /// no work.
  VectorXd energies(const Perturbation& it) const {
    VectorXd out = VectorXd::Zero(lengths_.size());
    for (int body = 0; body < system_.body_count(); ++body)
      out[connected_.of_body(body)] += energy(body, it.way, it.velocity);
    return out;
  }

  double energy(int body, const VectorXd& way, const VectorXd& velocity) const {
    const Eigen::Index v = v_of(body), q = r_of(body) + 3;
    const Vec3<double> omega = here_.y.segment<3>(system_.q_size() + v + 3), spin = system_.inertia(body) * omega;
    const Vec3<double> torque =
        rotation_matrix<double>(here_.y.segment<4>(q)) * (here_.forces.segment<3>(v + 3) - spin.cross(omega));
    return system_.mass(body) * here_.y.segment<3>(system_.q_size() + v).dot(velocity.segment<3>(v)) +
           spin.dot(velocity.segment<3>(v + 3)) - here_.forces.segment<3>(v).dot(way.segment<3>(v)) -
           torque.dot(way.segment<3>(v + 3));
  }

  /// Where energy is a constant of the motion, so is what an error changes of it: else what steps of this length leave
  /// would become a motion out of time, again at each slow passage. By velocities along the motion, where it is fast.
  void go_back_to_energies(Perturbation& it) {
    if (!conservative_) return;
    const VectorXd velocity = here_.y.segment(system_.q_size(), system_.v_size());
    const VectorXd none = VectorXd::Zero(system_.v_size()), apart = it.energy - energies(it);
    VectorXd change = VectorXd::Zero(lengths_.size());
    for (int body = 0; body < system_.body_count(); ++body)
      change[connected_.of_body(body)] += energy(body, none, velocity);
    most_change_ = most_change_.cwiseMax(change);
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      if (change[part] > fast * most_change_[part])
        it.velocity.segment<6>(v_of(body)) += apart[part] / change[part] * velocity.segment<6>(v_of(body));
    }
  }

  double weighed(const VectorXd& x) const {
    double sum = 0.0;
    for (int body = 0; body < system_.body_count(); ++body) {
      const double L = lengths_[connected_.of_body(body)];
      sum += x.segment<3>(v_of(body)).squaredNorm() + L * L * x.segment<3>(v_of(body) + 3).squaredNorm();
    }
    return std::sqrt(sum);
  }

  /// How far state k is from this one, by what of it is resolved.
  double distance(std::size_t k) const {
    double rate = 0.0;
    for (const Perturbation& it : carried_) rate = std::max(rate, it.rate);
    double out = rate * (log_.t(k) - here_.t) / resolved;
    const Eigen::Map<const VectorXd> y = log_.y(k);
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      const Eigen::Index r = r_of(body), v = system_.q_size() + v_of(body);
      if (!(speeds_[part] > 0.0)) continue;
      Vec3<double> way = y.segment<3>(r) - here_.y.segment<3>(r);
      if (!axes_.part.empty()) way -= (log_.t(k) - here_.t) * axes_.velocity.col(part);
      out = std::max({out, way.norm() / (near * lengths_[part]),
                      2.0 * (y.segment<4>(r + 3) - here_.y.segment<4>(r + 3)).norm() / near,
                      (y.segment<3>(v) - here_.y.segment<3>(v)).norm() / (near * speeds_[part])});
    }
    return density_ * out;
  }

  /// The last one of the log, or up to a time, that is near enough.
  std::size_t next_state(std::size_t k, double until) const {
    std::size_t out = k + 1;
    while (out + 1 < log_.size() && log_.t(out) < until && distance(out + 1) <= 1.0 && is_smooth(k, out + 1)) ++out;
    return out;
  }

  /// Whether the cubic from state k, where this is, to another goes as the run did halfway: what is small beside what
  /// comes later counts by its own size.
  bool is_smooth(std::size_t k, std::size_t end) const {
    const std::size_t middle = k + (end - k) / 2;
    if (middle == k) return true;
    const double h = log_.t(end) - here_.t;
    const VectorXd last = log_.y(end), there = log_.y(middle);
    const VectorXd cubic = between(here_.y, last, h, (log_.t(middle) - here_.t) / h);
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      const Eigen::Index v = system_.q_size() + v_of(body);
      const Vec3<double> whole = axes_.part.empty() ? Vec3<double>::Zero() : Vec3<double>(axes_.velocity.col(part));
      const auto size = [&](const VectorXd& y) {
        return std::max((y.segment<3>(v) - whole).norm(), lengths_[part] * y.segment<3>(v + 3).norm());
      };
      const double off = std::max((cubic.segment<3>(v) - there.segment<3>(v)).norm(),
                                  lengths_[part] * (cubic.segment<3>(v + 3) - there.segment<3>(v + 3)).norm());
      const double least_speed = none * (speeds_[part] + whole.norm());
      if (off > smooth * std::max({size(here_.y), size(there), size(last)}) + least_speed) return false;
    }
    return true;
  }

  /// All of them on to a state of the log, by some between where it is far, or where stages differ too much.
  bool carry(std::size_t k, std::size_t following) {
    const double way = distance(following) / density_, h = log_.t(following) - here_.t;
    const Place first = here_;
    if (!go_to(log_.t(following), log_.y(following), following)) return false;
    const Place last = std::exchange(here_, first);
    double parts = std::max(std::ceil(density_ * way), 1.0), share = 0.0, worst = 0.0;
    while (share < 1.0) {
      if (!(parts <= most_parts)) return false;
      const double next = share + 1.5 / parts < 1.0 ? share + 1.0 / parts : 1.0;
      const auto at = [&](double s) { return s == 1.0 ? last.y : between(first, last, s); };
      const Place before = here_;
      std::vector<Perturbation> carried = carried_;
      if (!carry_to(first.t + h * next, at(next), at(0.5 * (share + next)), k)) return false;
      if (stages_apart_ > too_far * most_difference_) {
        here_ = before;
        carried_ = std::move(carried);
        parts *= 2.0;
        continue;
      }
      share = next;
      worst = std::max(worst, stages_apart_);
    }
    const double wanted = parts / std::max(way, least_way) * std::sqrt(worst / most_difference_);
    density_ = std::clamp(std::clamp(wanted, density_ / 2.0, density_ * 2.0), least_density, most_parts);
    return true;
  }

  /// Of the fifth degree in positions, as velocities and accelerations at both ends have it.
  VectorXd between(const Place& begin, const Place& end, double s) const {
    const double h = end.t - begin.t, s2 = s * s, s3 = s2 * s, s4 = s3 * s, s5 = s4 * s;
    const double way[] = {10 * s3 - 15 * s4 + 6 * s5, h * (s - 6 * s3 + 8 * s4 - 3 * s5),
                          h * h * (s2 - 3 * s3 + 3 * s4 - s5) / 2, h * (-4 * s3 + 7 * s4 - 3 * s5),
                          h * h * (s3 - 2 * s4 + s5) / 2};
    const double rate[] = {(30 * s2 - 60 * s3 + 30 * s4) / h, 1 - 18 * s2 + 32 * s3 - 15 * s4,
                           h * (2 * s - 9 * s2 + 12 * s3 - 5 * s4) / 2, -12 * s2 + 28 * s3 - 15 * s4,
                           h * (3 * s2 - 8 * s3 + 5 * s4) / 2};
    const auto sum = [](const double(&of)[5], const auto& whole, const auto& v0, const auto& a0, const auto& v1,
                        const auto& a1) {
      return (of[0] * whole + of[1] * v0 + of[2] * a0 + of[3] * v1 + of[4] * a1).eval();
    };
    VectorXd out = begin.y;
    for (int body = 0; body < system_.body_count(); ++body) {
      const Eigen::Index r = r_of(body), own = v_of(body), v = system_.q_size() + own;
      const Vec3<double> x = end.y.segment<3>(r) - begin.y.segment<3>(r), v0 = begin.y.segment<3>(v),
                         v1 = end.y.segment<3>(v), a0 = begin.v_dot.segment<3>(own), a1 = end.v_dot.segment<3>(own);
      out.segment<3>(r) += sum(way, x, v0, a0, v1, a1);
      out.segment<3>(v) = sum(rate, x, v0, a0, v1, a1);
      const Vec4<double> p0 = begin.y.segment<4>(r + 3), p1 = end.y.segment<4>(r + 3), turned = p1 - p0;
      const Vec4<double> rate0 = euler_parameter_rates<double>(p0, begin.y.segment<3>(v + 3)),
                         rate1 = euler_parameter_rates<double>(p1, end.y.segment<3>(v + 3));
      const Vec4<double> bent0 = second_rates(p0, rate0, begin, body), bent1 = second_rates(p1, rate1, end, body);
      const Vec4<double> p = p0 + sum(way, turned, rate0, bent0, rate1, bent1),
                         p_dot = sum(rate, turned, rate0, bent0, rate1, bent1);
      out.segment<4>(r + 3) = p;
      out.segment<3>(v + 3) =
          2.0 / p.squaredNorm() * quaternion_product<double>({p[0], -p[1], -p[2], -p[3]}, p_dot).tail<3>();
    }
    system_.normalize(out.head(system_.q_size()));
    return out;
  }

  /// Of Euler parameters.
  Vec4<double> second_rates(const Vec4<double>& p, const Vec4<double>& p_dot, const Place& at, int body) const {
    const Vec3<double> omega = at.y.segment<3>(system_.q_size() + v_of(body) + 3);
    return euler_parameter_rates<double>(p_dot, omega) +
           euler_parameter_rates<double>(p, at.v_dot.segment<3>(v_of(body) + 3));
  }

  /// Cubic in positions, as velocities at both ends have it.
  VectorXd between(const VectorXd& begin, const VectorXd& end, double h, double share) const {
    const double left = 1.0 - share;
    VectorXd out = left * begin + share * end;
    for (int body = 0; body < system_.body_count(); ++body) {
      const Eigen::Index r = r_of(body), v = system_.q_size() + v_of(body);
      const auto bend = [&](auto place, const auto& rate_at_begin, const auto& rate_at_end, const auto& way) {
        place += share * left * (left * (h * rate_at_begin - way) - share * (h * rate_at_end - way));
      };
      const Vec3<double> way = end.segment<3>(r) - begin.segment<3>(r);
      const Vec4<double> turned = end.segment<4>(r + 3) - begin.segment<4>(r + 3);
      bend(out.segment<3>(r), begin.segment<3>(v), end.segment<3>(v), way);
      bend(out.segment<4>(r + 3), euler_parameter_rates<double>(begin.segment<4>(r + 3), begin.segment<3>(v + 3)),
           euler_parameter_rates<double>(end.segment<4>(r + 3), end.segment<3>(v + 3)), turned);
      const Vec3<double> mean = 0.5 * (begin.segment<3>(v) + end.segment<3>(v));
      out.segment<3>(v) += 6.0 * share * left * (way / h - mean);
      const Vec3<double> rotation = StateDifference::turn(end.segment<4>(r + 3), begin.segment<4>(r + 3));
      const Vec3<double> mean_spin = 0.5 * (begin.segment<3>(v + 3) + end.segment<3>(v + 3));
      out.segment<3>(v + 3) += 6.0 * share * left * (rotation / h - mean_spin);
    }
    system_.normalize(out.head(system_.q_size()));
    return out;
  }

  /// By the classical Runge-Kutta method; `y` is the state there, `middle` that on the way.
  bool carry_to(double t, const VectorXd& y, const VectorXd& middle, std::size_t k) {
    const double h = t - here_.t;
    std::vector<Perturbation> sum = carried_, stage = carried_;
    const auto add = [&](double of_sum, double of_stage) {
      for (std::size_t n = 0; n < carried_.size(); ++n) {
        VectorXd rate = stage[n].velocity;
        turn(rate);
        sum[n].way += of_sum * h * rate;
        sum[n].velocity += of_sum * h * stage[n].acceleration;
        stage[n].way = carried_[n].way + of_stage * h * rate;
        stage[n].velocity = carried_[n].velocity + of_stage * h * stage[n].acceleration;
      }
    };
    const auto accelerate_stages = [&] {
      return std::all_of(stage.begin(), stage.end(), [this](Perturbation& it) { return find_acceleration(it); });
    };
    add(1.0 / 6.0, 0.5);
    if (!go_to(here_.t + 0.5 * h, middle, k) || !accelerate_stages()) return false;
    const std::vector<Perturbation> second = stage;
    add(1.0 / 3.0, 0.5);
    if (!accelerate_stages()) return false;
    stages_apart_ = 0.0;
    for (std::size_t n = 0; n < stage.size(); ++n)
      stages_apart_ = std::max(stages_apart_, difference(second[n], stage[n], h));
    add(1.0 / 3.0, 1.0);
    if (!go_to(t, y, k) || !accelerate_stages()) return false;
    add(1.0 / 6.0, 0.0);
    carried_ = std::move(sum);
    std::erase_if(carried_, [this](const Perturbation& it) { return !is_some(size(it.way, it.velocity)); });
    for (Perturbation& it : carried_) {
      if (!find_acceleration(it)) return false;
      if (system_.row_count() > 0) go_back_to_constraints(it);
      go_back_to_energies(it);
      note(it);
    }
    reached_ = t;
    return true;
  }

  /// Of two stages of a step, relative to the error.
  double difference(const Perturbation& a, const Perturbation& b, double h) const {
    VectorXd rate = b.velocity - a.velocity;
    turn(rate);
    return h * (size(rate, b.acceleration - a.acceleration).maxCoeff() / size(b.way, b.velocity).maxCoeff());
  }

  void note(Perturbation& it) const {
    const VectorXd now = size(it.way, it.velocity);
    for (Eigen::Index part = 0; part < now.size(); ++part)
      if (it.first[part] > 0.0) it.largest[part] = std::max(it.largest[part], now[part] / it.first[part]);
  }

  Dynamics& dynamics_;
  const System& system_;
  const ConnectedParts& connected_;
  const StateLog& log_;
  const MovingAxes& axes_;
  const VectorXd &lengths_, &speeds_;
  double most_difference_;
  bool conservative_, holonomic_;
  Place here_;
  double reached_ = 0.0;  ///< up to where errors were carried [s]
  VectorXd other_v_dot_, lambda_;
  VectorXd sides_;             ///< switches at the start
  VectorXd most_change_;       ///< of each part: twice the largest kinetic energy [J]
  double density_ = 1.0;       ///< of states on the way, by what `distance` takes for far
  double stages_apart_ = 0.0;  ///< of the last step
  std::int64_t evaluations_ = 0, most_ = 0;
  std::vector<Perturbation> carried_;
};

}  // namespace

namespace {

/// The largest growth relative to that of regular motion, in proportion to time.
double irregularity(const std::vector<ErrorGrowth>& found, const VectorXd& lengths, const VectorXd& speeds) {
  double out = 0.0;
  for (const ErrorGrowth& it : found)
    for (Eigen::Index part = 0; part < lengths.size(); ++part)
      out = std::max(out, it.of_part[part] / (1.0 + speeds[part] / lengths[part] * (it.until - it.t)));
  return out;
}

}  // namespace

std::vector<ErrorGrowth> find_error_growth(Dynamics& dynamics, const StateLog& log, const ErrorsToFollow& errors,
                                           const MovingAxes& axes, const VectorXd& lengths, const VectorXd& speeds,
                                           std::int64_t most_evaluations) {
  if (log.size() < 2) return {};
  std::vector<StepDifference> followed;
  const auto find = [&](double difference, std::int64_t most) {
    GrowthSearch search(dynamics, log, axes, lengths, speeds, difference);
    if (difference == usual_difference) {
      const auto [count, until] = search.plan(most);
      followed = errors(count, until);
    }
    return search.find(followed, most);
  };
  std::vector<ErrorGrowth> found = find(usual_difference, most_evaluations);
  if (found.empty()) return found;
  const double end = log.t(log.size() - 1);
  if (found.front().until < end && irregularity(found, lengths, speeds) > suspicious)
    found = find(usual_difference, more * most_evaluations);
  if (!(irregularity(found, lengths, speeds) > doubtful)) return found;
  const std::int64_t affordable = most_of_bodies / dynamics.system().body_count();
  std::vector<ErrorGrowth> again = find(fine_difference, std::min(more * more * most_evaluations, affordable));
  return again.size() == found.size() && again.front().until >= found.front().until ? again : found;
}

}  // namespace linkwork
