#include "linkwork/integration/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double hardly = 1e-6;    // of its size: farther, and it may have moved, however softly it is held
constexpr double slowest = 1e-9;   // of the speed of a fall: a velocity at the beginning
constexpr double balanced = 1e-8;  // of what gravity does: forces that balance, as an equilibrium leaves them

constexpr double roundoff = 32.0 * std::numeric_limits<double>::epsilon();
constexpr double left_of_forces = 256.0 * std::numeric_limits<double>::epsilon();  // by roundoff, where they cancel

const KeptStep& earliest(const std::vector<const KeptStep*>& steps) {
  return **std::min_element(steps.begin(), steps.end(),
                            [](const KeptStep* a, const KeptStep* b) { return a->t < b->t; });
}

class RestSearch {
 public:
  RestSearch(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const StepParts& parts, double length)
      : dynamics_(dynamics),
        steps_(steps),
        parts_(parts),
        length_(length),
        axes_(MovingAxes::at_start(system(), earliest(steps))),
        pose_(earliest(steps).y) {
    axes_.see(earliest(steps).t, pose_);
    double end = earliest(steps).t;
    for (const KeptStep* step : steps) end = std::max(end, step->t + step->h);
    const double gravity = system().model().gravity().norm();
    rest_.speed = std::max(length / (end - earliest(steps).t), std::sqrt(gravity * length));
    for (int body = 0; body < system().body_count(); ++body)
      rest_.energy += 0.5 * system().mass(body) * rest_.speed * rest_.speed;
  }

  std::optional<Rest> result() {
    if (!begins_at_rest() || !stays() || !balances()) return {};
    return rest_;
  }

 private:
  const System& system() const { return dynamics_.system(); }

  bool begins_at_rest() {
    auto v = pose_.segment(system().q_size(), system().v_size());
    const double speed = fastest(v);
    v.setZero();
    return speed <= slowest * rest_.speed;
  }

  bool stays() {
    double farthest = 0.0;
    for (const KeptStep* step : steps_) {
      VectorXd seen = step->y_new;
      axes_.see(step->t + step->h, seen);
      StateDifference& moved = rest_.moved.emplace_back();
      moved.raise(system(), seen, pose_);
      farthest = seen.allFinite() ? std::max({farthest, moved.position / length_, moved.rotation}) : INFINITY;
    }
    return farthest <= hardly;
  }

  bool balances() {
    for (const KeptStep* step : steps_) {
      dynamics_.set_history(step->history);
      for (const Span& part : parts_.of(*step))
        if (!balances_at(part.from) || !balances_at(part.to)) return false;
    }
    return true;
  }

  bool balances_at(double t) {
    VectorXd y = pose_, v_dot(system().v_size()), lambda = VectorXd::Zero(system().row_count());
    axes_.carry(t, y);
    try {
      dynamics_.evaluate(t, y);
      if (!is_left_alone(y)) return false;
      dynamics_.accelerations(v_dot, lambda);
    } catch (const Error&) {
      return false;
    }
    const VectorXd least = roundoff_of(lambda).cwiseMax(balanced * rest_.speed * rest_.speed / length_);
    const ConnectedComponents& components = ConnectedComponents::of(system());
    for (int body = 0; body < system().body_count(); ++body)
      if (!(speed_of(v_dot, body) <= least[components.of_body(body)])) return false;
    return true;
  }

  /// Accelerations that roundoff leaves of forces that cancel, of each connected component: where the weight of a long
  /// row of bodies hangs on each joint, they are larger than those of an equilibrium that is not exact. From the body at
  /// which they are largest they spread, a rotation by the size of the component.
  VectorXd roundoff_of(const VectorXd& lambda) const {
    const Evaluation& at = dynamics_.evaluation();
    VectorXd forces = at.g.head(system().v_size()).cwiseAbs(), accelerations(forces.size());
    for (const ConstraintBlock& block : system().blocks())
      forces.segment<velocity_size>(velocity_size * block.body) +=
          block_of(at, block).cwiseAbs().transpose() * lambda.segment(block.row, block.rows).cwiseAbs();
    system().multiply_inverse_mass(forces, accelerations);
    const ConnectedComponents& components = ConnectedComponents::of(system());
    VectorXd size = VectorXd::Constant(components.count(), length_), linear = VectorXd::Zero(size.size()),
             turning = linear;
    std::vector<int> first(size.size(), -1);
    for (int body = 0; body < system().body_count(); ++body) {
      const int c = components.of_body(body);
      if (first[c] < 0) first[c] = body;
      size[c] = std::max(size[c], (place(body) - place(first[c])).norm());
      linear[c] = std::max(linear[c], accelerations.segment<3>(velocity_size * body).norm());
      turning[c] = std::max(turning[c], accelerations.segment<3>(velocity_size * body + 3).norm());
    }
    return left_of_forces * linear.cwiseMax(size.cwiseProduct(turning));
  }

  Vec3<double> place(int body) const { return pose_.segment<3>(position_size * body); }

  /// By drivers: constraints hold as well as at the beginning, and demand no other velocity.
  bool is_left_alone(const VectorXd& y) {
    const Evaluation& at = dynamics_.evaluation();
    if (Phi_.size() == 0) Phi_ = at.Phi;
    const double least = roundoff * (length_ + y.head(system().q_size()).cwiseAbs().maxCoeff());
    return largest(at.Phi - Phi_) <= least && largest(at.Phi_dot) <= slowest * rest_.speed * (1.0 + 1.0 / length_);
  }

  static double largest(const VectorXd& x) { return x.size() > 0 ? x.cwiseAbs().maxCoeff() : 0.0; }

  /// Largest of any body, of turning by the size.
  double fastest(const ConstVector& v) const {
    double largest = 0.0;
    for (int body = 0; body < system().body_count(); ++body) largest = std::max(largest, speed_of(v, body));
    return v.allFinite() ? largest : INFINITY;
  }

  double speed_of(const ConstVector& v, int body) const {
    const auto own = v.segment<velocity_size>(velocity_size * body);
    return std::max(own.head<3>().norm(), length_ * own.tail<3>().norm());
  }

  Dynamics& dynamics_;
  const std::vector<const KeptStep*>& steps_;
  const StepParts& parts_;
  double length_;
  MovingAxes axes_;
  VectorXd pose_;  ///< as the axes see it
  VectorXd Phi_;   ///< there, at first
  Rest rest_;
};

}  // namespace

std::optional<Rest> find_rest(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const StepParts& parts,
                              double length) {
  if (steps.empty() || dynamics.system().body_count() == 0) return {};
  return RestSearch(dynamics, steps, parts, length).result();
}

}  // namespace linkwork
