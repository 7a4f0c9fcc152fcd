#include "linkwork/integration/nonlinearity.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/integration/energies_made.hpp"
#include "linkwork/integration/state_difference.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/model/joint_kind.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_states = 24;
constexpr std::size_t fewest_states = 8;  // else no mean is known
constexpr double margin = 8.0;            // above exponents of periods by energies, and paces of exchange
constexpr double unstable = 0.2;          // of the work by which states come back: else some may be leaving

/// Of all parts at once.
class NonlinearitySearch {
 public:
  NonlinearitySearch(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const MovingAxes& axes,
                     const VectorXd& lengths)
      : dynamics_(dynamics),
        system_(dynamics.system()),
        connected_(ConnectedParts::of(system_)),
        axes_(axes),
        lengths_(lengths),
        open_(may_conserve(system_)),
        freedoms_(open_.size(), 0),
        largest_(open_.size()) {
    std::vector<const KeptStep*> finite;
    for (const KeptStep* step : steps)
      if (step->y.allFinite()) finite.push_back(step);
    if (finite.size() < fewest_states) return;
    find_mean(finite);
    const std::size_t every = finite.size() / most_states | 1;  // odd: now one, now the other step of a part of the run
    for (std::size_t k = 0; k < finite.size(); k += every) steps_.push_back(finite[k]);
  }

  VectorXd result(const std::vector<int>& redundant) {
    VectorXd out = VectorXd::Ones(static_cast<Eigen::Index>(open_.size()));
    if (steps_.empty()) return out;
    leave_out_memories();
    leave_out_rolling();
    leave_out_rotations();
    leave_out_work();
    for (const KeptStep* step : steps_) {
      if (std::find(open_.begin(), open_.end(), true) == open_.end()) return out;
      look_for_interruption();
      if (!look_at(*step)) return out;
    }
    count_freedoms(redundant);
    for (std::size_t part = 0; part < open_.size(); ++part)
      if (open_[part]) out[static_cast<Eigen::Index>(part)] = std::min(1.0, of_part(part));
    return out;
  }

 private:
  /// Of a part, over these states.
  struct Largest {
    double rotation = 0.0;
    double linear = 0.0, odd = 0.0, even = 0.0;                 ///< accelerations
    double linear_work = 0.0, odd_work = 0.0, even_work = 0.0;  ///< what these do on the way back to the mean
    double pushed = 0.0;                                        ///< and on the way from there, where they do
  };

  double of_part(std::size_t part) const {
    const Largest& it = largest_[part];
    if (it.pushed > unstable * it.linear_work) return 1.0;
    const double odd = std::max(it.odd / it.linear, it.odd_work / it.linear_work);
    const double even = std::max(it.even / it.linear, it.even_work / it.linear_work);
    const double found = margin * (odd + (freedoms_[part] == 1 ? even * even : even));
    return found >= 0.0 ? std::max(found, it.rotation * it.rotation) : 1.0;  // 0 / 0: nothing accelerates
  }

  static Eigen::Index place_of_p(int body) { return position_size * static_cast<Eigen::Index>(body) + 3; }

  VectorXd seen(const KeptStep& step, const VectorXd& near) const {
    VectorXd y = step.y;
    axes_.see(step.t, y);
    for (int body = 0; body < system_.body_count(); ++body)
      if (auto p = y.segment<4>(place_of_p(body)); p.dot(near.segment<4>(place_of_p(body))) < 0.0) p = -p;
    return y;
  }

  void find_mean(const std::vector<const KeptStep*>& steps) {
    const VectorXd& first = steps.front()->y;
    mean_.setZero(first.size());
    for (const KeptStep* step : steps) mean_ += seen(*step, first) / static_cast<double>(steps.size());
    for (int body = 0; body < system_.body_count(); ++body)
      if (auto p = mean_.segment<4>(place_of_p(body)); p.norm() < 0.5) p = first.segment<4>(place_of_p(body));
    system_.normalize(mean_.head(system_.q_size()));
  }

  void leave_out_memories() {
    for (Eigen::Index k = 0; k < system_.history_size(); ++k) open_[connected_.of_history(system_, k)] = false;
  }

  void leave_out_rolling() {
    const Model& model = system_.model();
    for (int k = 0; k < system_.joint_count(); ++k) {
      const Element& joint = model.joints()[k];
      if (!model.special_joint(k) && joint_kinds()[joint.kind].info.velocity_rows() > 0)
        open_[connected_.of_bodies(joint.i, joint.j)] = false;
    }
  }

  void leave_out_rotations() {
    for (const KeptStep* step : steps_) {
      const VectorXd apart = seen(*step, mean_) - mean_;
      for (int body = 0; body < system_.body_count(); ++body) {
        double& rotation = largest_[connected_.of_body(body)].rotation;
        rotation = std::max(rotation, 2.0 * apart.segment<4>(place_of_p(body)).norm());
        if (rotation >= 1.0) open_[connected_.of_body(body)] = false;
      }
    }
  }

  void leave_out_work() {
    const std::vector<Element>& forces = system_.model().forces();
    for (std::size_t f = 0; f < forces.size(); ++f) {
      if (forces[f].i == ground && forces[f].j == ground) continue;
      const int part = connected_.of_bodies(forces[f].i, forces[f].j);
      if (!open_[part]) continue;
      look_for_interruption();
      ForceElement element(system_, static_cast<int>(f), -1);
      for (const KeptStep* step : steps_) {
        const auto q = step->y.head(system_.q_size()), v = step->y.segment(system_.q_size(), system_.v_size());
        if (element.energy(step->t, q, v, step->history).power != 0.0) open_[part] = false;
      }
    }
  }

  void count_freedoms(const std::vector<int>& redundant) {
    for (int body = 0; body < system_.body_count(); ++body) freedoms_[connected_.of_body(body)] += velocity_size;
    for (int row = 0; row < system_.row_count(); ++row) freedoms_[connected_.of_row(row)] -= 1;
    for (const int row : redundant) freedoms_[connected_.of_row(row)] += 1;
  }

  /// Accelerations so far from the mean state, relative to that step; false: there are none.
  bool accelerate(const KeptStep& step, const VectorXd& apart, double share, VectorXd& v_dot) {
    VectorXd y = mean_ + share * apart, lambda = VectorXd::Zero(system_.row_count());
    system_.normalize(y.head(system_.q_size()));
    axes_.carry(step.t, y);
    v_dot.resize(system_.v_size());
    try {
      dynamics_.set_history(step.history);
      dynamics_.evaluate(step.t, y);
      dynamics_.accelerations(v_dot, lambda);
    } catch (const Error&) {
      return false;
    }
    return v_dot.allFinite();
  }

  /// At the mean state, at this one and at its mirror image about the mean, and half as far from it.
  bool look_at(const KeptStep& step) {
    const VectorXd apart = seen(step, mean_) - mean_;
    VectorXd there, mirrored, half, half_mirrored, mean;
    if (!accelerate(step, apart, 1.0, there) || !accelerate(step, apart, -1.0, mirrored) ||
        !accelerate(step, apart, 0.5, half) || !accelerate(step, apart, -0.5, half_mirrored) ||
        !accelerate(step, apart, 0.0, mean))
      return false;
    const VectorXd linear = (there - mirrored) / 2.0, odd = linear - (half - half_mirrored);
    const VectorXd even = (there + mirrored) / 2.0 - mean;
    weigh(apart, linear, odd, even);
    return true;
  }

  /// Where small bodies vibrate fast, what they accelerate hides what large ones do: these show in the work.
  void weigh(const VectorXd& apart, const VectorXd& linear, const VectorXd& odd, const VectorXd& even) {
    VectorXd work = VectorXd::Zero(lengths_.size()), odd_work = work, even_work = work;
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      const Eigen::Index v = velocity_size * static_cast<Eigen::Index>(body);
      const auto size = [&](const VectorXd& of) {
        return std::max(of.segment<3>(v).norm(), lengths_[part] * of.segment<3>(v + 3).norm());
      };
      Largest& it = largest_[part];
      it.linear = std::max(it.linear, size(linear));
      it.odd = std::max(it.odd, size(odd));
      it.even = std::max(it.even, size(even));
      const Vec3<double> way = apart.segment<3>(place_of_p(body) - 3);
      const Vec4<double> p = mean_.segment<4>(place_of_p(body));
      const Vec3<double> turned = StateDifference::turn(p + apart.segment<4>(place_of_p(body)), p);
      const auto along = [&](const VectorXd& of) {
        return system_.mass(body) * of.segment<3>(v).dot(way) +
               turned.dot(system_.inertia(body) * of.segment<3>(v + 3));
      };
      work[part] += along(linear);
      odd_work[part] += std::abs(along(odd));
      even_work[part] += std::abs(along(even));
    }
    note_work(work, odd_work, even_work);
  }

  void note_work(const VectorXd& work, const VectorXd& odd_work, const VectorXd& even_work) {
    for (std::size_t part = 0; part < open_.size(); ++part) {
      const auto k = static_cast<Eigen::Index>(part);
      Largest& it = largest_[part];
      it.pushed = std::max(it.pushed, work[k]);
      it.linear_work = std::max(it.linear_work, -work[k]);
      it.odd_work = std::max(it.odd_work, odd_work[k]);
      it.even_work = std::max(it.even_work, even_work[k]);
    }
  }

  Dynamics& dynamics_;
  const System& system_;
  const ConnectedParts& connected_;
  const MovingAxes& axes_;
  const VectorXd& lengths_;
  std::vector<const KeptStep*> steps_;
  VectorXd mean_;
  // Of each part:
  std::vector<bool> open_;  ///< not known to be 1
  std::vector<int> freedoms_;
  std::vector<Largest> largest_;
};

}  // namespace

VectorXd find_nonlinearity(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const MovingAxes& axes,
                           const VectorXd& lengths, const std::vector<int>& redundant) {
  return NonlinearitySearch(dynamics, steps, axes, lengths).result(redundant);
}

}  // namespace linkwork
