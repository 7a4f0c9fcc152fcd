#include "linkwork/integration/nonlinearity.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_states = 24;
constexpr std::size_t fewest_states = 8;  // else no mean is known
constexpr double exponents = 4.0;         // of periods by energies, at most so often odd + even^2

/// Of all parts at once. Accelerations are those at the mean state, at some of the others and their mirror images about
/// it, and half as far from it.
class Chords {
 public:
  Chords(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const MovingAxes& axes)
      : dynamics_(dynamics),
        system_(dynamics.system()),
        connected_(ConnectedParts::of(system_)),
        axes_(axes),
        linear_(VectorXd::Zero(connected_.count())),
        rotation_(linear_),
        odd_(linear_),
        even_(linear_),
        work_(linear_),
        odd_work_(linear_) {
    for (const KeptStep* step : steps)
      if (step->y.allFinite()) steps_.push_back(step);
    find_mean();
  }

  VectorXd result() {
    VectorXd out = VectorXd::Ones(linear_.size());
    if (steps_.size() < fewest_states || (closed_.array() > 0.0).all()) return out;
    const std::size_t every = (steps_.size() + most_states - 1) / most_states;
    for (std::size_t k = 0; k < steps_.size(); k += every) {
      look_for_interruption();
      if (!look_at(*steps_[k])) return out;
    }
    for (Eigen::Index part = 0; part < out.size(); ++part) {
      const double odd = std::max(odd_[part] / linear_[part], odd_work_[part] / work_[part]);
      const double even = even_[part] / linear_[part];
      const double found = std::max(exponents * (odd + even * even), rotation_[part] * rotation_[part]);
      if (closed_[part] == 0.0 && found < 1.0) out[part] = found;  // not where nothing accelerates: 0 / 0
    }
    return out;
  }

 private:
  VectorXd seen(const KeptStep& step) const {
    VectorXd y = step.y;
    axes_.see(step.t, y);
    for (int body = 0; mean_.size() > 0 && body < system_.body_count(); ++body)
      if (auto p = y.segment<4>(position_size * body + 3); p.dot(mean_.segment<4>(position_size * body + 3)) < 0.0)
        p = -p;
    return y;
  }

  void find_mean() {
    VectorXd sum;
    for (const KeptStep* step : steps_) {
      const VectorXd y = seen(*step);
      if (mean_.size() == 0) mean_ = y, sum = VectorXd::Zero(y.size());
      sum += y;
    }
    if (steps_.empty()) return;
    mean_ = sum / static_cast<double>(steps_.size());
    normalize(mean_);
    close_parts();
  }

  void normalize(VectorXd& y) const {
    for (int body = 0; body < system_.body_count(); ++body) y.segment<4>(position_size * body + 3).normalize();
  }

  /// Those with forces of which a few states do not tell.
  void close_parts() {
    const Model& model = system_.model();
    closed_ = VectorXd::Zero(linear_.size());
    const auto close = [&](int i, int j) {
      if (i != ground || j != ground) closed_[connected_.of_bodies(i, j)] = 1.0;
    };
    for (const Element& force : model.forces())
      for (std::size_t p = 0; p < force_kinds()[static_cast<std::size_t>(force.kind)].info.parameters.size(); ++p)
        if (const int signal = model.force_parameters()[force.first_parameter + p].signal;
            signal >= 0 && !model.signals()[static_cast<std::size_t>(signal)]->of_time() &&
            !model.signals()[static_cast<std::size_t>(signal)]->integral())
          close(force.i, force.j);
    for (const JointForce& force : model.joint_forces()) close(force.i, force.j);
    for (const SwitchOwner& it : owners_of_switches(model)) {
      const Element& force = model.forces()[static_cast<std::size_t>(it.element)];
      close(force.i, force.j);
    }
    for (Eigen::Index k = 0; k < system_.history_size(); ++k) closed_[connected_.of_history(system_, k)] = 1.0;
    if (!model.user_forces().empty()) closed_.setOnes();  // on whichever bodies
  }

  /// Accelerations so far from the mean state, relative to that step; false: there are none.
  bool accelerate(const KeptStep& step, const VectorXd& apart, double share, VectorXd& v_dot) {
    VectorXd y = mean_ + share * apart, lambda = VectorXd::Zero(system_.row_count());
    normalize(y);
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

  bool look_at(const KeptStep& step) {
    const VectorXd apart = seen(step) - mean_;
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
    VectorXd work = VectorXd::Zero(linear_.size()), odd_work = work;
    for (int body = 0; body < system_.body_count(); ++body) {
      const int part = connected_.of_body(body);
      const Eigen::Index v = velocity_size * static_cast<Eigen::Index>(body),
                         x = position_size * static_cast<Eigen::Index>(body);
      const double length = std::sqrt(system_.inertia(body).trace() / std::max(system_.mass(body), least_mass));
      const auto size = [&](const VectorXd& of) {
        return std::max(of.segment<3>(v).norm(), length * of.segment<3>(v + 3).norm());
      };
      linear_[part] = std::max(linear_[part], size(linear));
      odd_[part] = std::max(odd_[part], size(odd));
      even_[part] = std::max(even_[part], size(even));
      const Vec3<double> turned = turned_by(apart.segment<4>(x + 3), mean_.segment<4>(x + 3));
      rotation_[part] = std::max(rotation_[part], 2.0 * apart.segment<4>(x + 3).norm());
      const auto along = [&](const VectorXd& of) {
        return system_.mass(body) * of.segment<3>(v).dot(apart.segment<3>(x)) +
               turned.dot(system_.inertia(body) * of.segment<3>(v + 3));
      };
      work[part] += along(linear);
      odd_work[part] += std::abs(along(odd));
    }
    work_ = work_.cwiseMax(work.cwiseAbs());
    odd_work_ = odd_work_.cwiseMax(odd_work);
  }

  /// Rotation vector of a small difference of Euler parameters, in axes of the body.
  static Vec3<double> turned_by(const Vec4<double>& dp, const Vec4<double>& p) {
    const Vec3<double> e = p.tail<3>(), de = dp.tail<3>();
    return 2.0 * (p[0] * de - dp[0] * e - e.cross(de));
  }

  static constexpr double least_mass = 1e-300;

  Dynamics& dynamics_;
  const System& system_;
  const ConnectedParts& connected_;
  const MovingAxes& axes_;
  std::vector<const KeptStep*> steps_;
  VectorXd mean_;
  VectorXd closed_;  ///< 1: nobody looks there
  // Largest of each part:
  VectorXd linear_, rotation_, odd_, even_, work_, odd_work_;
};

}  // namespace

VectorXd find_nonlinearity(Dynamics& dynamics, const std::vector<const KeptStep*>& steps, const MovingAxes& axes) {
  return Chords(dynamics, steps, axes).result();
}

}  // namespace linkwork
