#include "linkwork/integration/rest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/integration/moving_axes.hpp"
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

/// Of all parts at once: what is seen of one says nothing about another.
class RestSearch {
 public:
  RestSearch(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const StepParts& parts,
             const VectorXd& lengths)
      : dynamics_(dynamics),
        connected_(ConnectedParts::of(dynamics.system())),
        steps_(steps),
        parts_(parts),
        lengths_(lengths),
        axes_(MovingAxes::at_start(system(), earliest(steps))),
        pose_(earliest(steps).y),
        found_(static_cast<std::size_t>(lengths.size()), Rest()) {
    double end = earliest(steps).t;
    for (const KeptStep* step : steps) end = std::max(end, step->t + step->h);
    const double gravity = system().model().gravity().norm();
    speeds_ = lengths.unaryExpr(
        [&](double length) { return std::max(length / (end - earliest(steps).t), std::sqrt(gravity * length)); });
    for (Eigen::Index part = 0; part < speeds_.size(); ++part)  // axes that are as good as at rest stand still
      if (axes_.velocity.col(part).norm() <= slowest * speeds_[part]) axes_.velocity.col(part).setZero();
    axes_.see(earliest(steps).t, pose_);
  }

  std::vector<std::optional<Rest>> result() {
    keep_what_begins_at_rest();
    keep_what_stays();
    keep_what_balances();
    for (int body = 0; body < system().body_count(); ++body) {
      const int part = connected_.of_body(body);
      if (!found_[part]) continue;
      found_[part]->speed = speeds_[part];
      found_[part]->energy += 0.5 * system().mass(body) * speeds_[part] * speeds_[part];
    }
    return std::move(found_);
  }

 private:
  const System& system() const { return dynamics_.system(); }
  bool any() const {
    return std::any_of(found_.begin(), found_.end(), [](const auto& it) { return it.has_value(); });
  }

  void keep_what_begins_at_rest() {
    auto v = pose_.segment(system().q_size(), system().v_size());
    keep_slow(v, slowest * speeds_);
    v.setZero();
  }

  void keep_what_stays() {
    for (const KeptStep* step : steps_) {
      VectorXd seen = step->y_new;
      axes_.see(step->t + step->h, seen);
      const DifferencesOfParts moved = differences(system(), seen, pose_);
      for (std::size_t part = 0; part < found_.size(); ++part) {
        if (!found_[part]) continue;
        const double way =
            std::max(moved[part].position / lengths_[static_cast<Eigen::Index>(part)], moved[part].rotation);
        if (seen.allFinite() && way <= hardly) found_[part]->moved.push_back(moved[part]);
        else found_[part].reset();
      }
    }
  }

  void keep_what_balances() {
    for (const KeptStep* step : steps_) {
      dynamics_.set_history(step->history);
      for (const StepSpan& part : parts_.of(step->t, step->h))
        for (const double t : {part.at(0.0), part.at(1.0)})
          if (any()) keep_what_balances(t);
    }
  }

  void keep_what_balances(double t) {
    VectorXd y = pose_, v_dot(system().v_size()), lambda = VectorXd::Zero(system().row_count());
    axes_.carry(t, y);
    try {
      dynamics_.evaluate(t, y);
      keep_what_is_left_alone(y);
      dynamics_.accelerations(v_dot, lambda);
    } catch (const Error&) {
      return found_.assign(found_.size(), std::nullopt);
    }
    keep_slow(v_dot, roundoff_of(lambda).cwiseMax(balanced * speeds_.cwiseAbs2().cwiseQuotient(lengths_)));
  }

  /// Accelerations that roundoff leaves of forces that cancel, of each part: where the weight of a long row of bodies
  /// hangs on each joint, they are larger than those of an equilibrium that is not exact. From the body at which they
  /// are largest they spread, a rotation by the size of the part.
  VectorXd roundoff_of(const VectorXd& lambda) const {
    const Evaluation& at = dynamics_.evaluation();
    VectorXd forces = at.g.head(system().v_size()).cwiseAbs(), accelerations(forces.size());
    for (const ConstraintBlock& block : system().blocks())
      forces.segment<velocity_size>(velocity_size * block.body) +=
          block_of(at, block).cwiseAbs().transpose() * lambda.segment(block.row, block.rows).cwiseAbs();
    system().multiply_inverse_mass(forces, accelerations);
    VectorXd size = lengths_, linear = VectorXd::Zero(size.size()), turning = linear;
    std::vector<int> first(size.size(), -1);
    for (int body = 0; body < system().body_count(); ++body) {
      const int part = connected_.of_body(body);
      if (first[part] < 0) first[part] = body;
      size[part] = std::max(size[part], (place(body) - place(first[part])).norm());
      linear[part] = std::max(linear[part], accelerations.segment<3>(velocity_size * body).norm());
      turning[part] = std::max(turning[part], accelerations.segment<3>(velocity_size * body + 3).norm());
    }
    return left_of_forces * linear.cwiseMax(size.cwiseProduct(turning));
  }

  Vec3<double> place(int body) const { return pose_.segment<3>(position_size * body); }

  /// By drivers: constraints hold as well as at the beginning, and demand no other velocity.
  void keep_what_is_left_alone(const VectorXd& y) {
    const Evaluation& at = dynamics_.evaluation();
    if (Phi_.size() == 0) Phi_ = at.Phi;
    VectorXd farthest = VectorXd::Zero(lengths_.size());
    for (int body = 0; body < system().body_count(); ++body) {
      double& own = farthest[connected_.of_body(body)];
      own = std::max(own, y.segment<position_size>(position_size * body).cwiseAbs().maxCoeff());
    }
    for (Eigen::Index row = 0; row < at.Phi.size(); ++row) {
      const int part = connected_.of_row(row);
      const double least = roundoff * (lengths_[part] + farthest[part]);
      const bool left = std::abs(at.Phi[row] - Phi_[row]) <= least &&
                        std::abs(at.Phi_dot[row]) <= slowest * speeds_[part] * (1.0 + 1.0 / lengths_[part]);
      if (!left) found_[part].reset();
    }
  }

  /// Parts no body of which has more than these limits, of turning by the size.
  void keep_slow(const ConstVector& v, const VectorXd& limits) {
    for (int body = 0; body < system().body_count(); ++body) {
      const int part = connected_.of_body(body);
      const auto of_body = v.segment<velocity_size>(velocity_size * body);
      const double rate = std::max(of_body.head<3>().norm(), lengths_[part] * of_body.tail<3>().norm());
      if (!of_body.allFinite() || !(rate <= limits[part])) found_[part].reset();
    }
  }

  Dynamics& dynamics_;
  const ConnectedParts& connected_;
  const std::vector<const KeptStep*>& steps_;
  const StepParts& parts_;
  VectorXd lengths_, speeds_;
  MovingAxes axes_;
  VectorXd pose_;  ///< as the axes see it
  VectorXd Phi_;   ///< there, at first
  std::vector<std::optional<Rest>> found_;
};

}  // namespace

std::vector<std::optional<Rest>> find_rest(Dynamics& dynamics, const std::vector<const KeptStep*>& steps,
                                           const StepParts& parts, const VectorXd& lengths) {
  if (steps.empty()) return std::vector<std::optional<Rest>>(static_cast<std::size_t>(lengths.size()));
  return RestSearch(dynamics, steps, parts, lengths).result();
}

}  // namespace linkwork
