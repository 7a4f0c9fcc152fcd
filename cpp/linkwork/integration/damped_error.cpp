#include "linkwork/integration/damped_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "linkwork/assembly/connected_components.hpp"

namespace linkwork {
namespace {

constexpr double soon = 0.5;  // of itself, that a velocity loses within a step
constexpr double most = 0.5;  // of the square of an error, by M: less is none that forces take back
// Where forces are looked at, along the error from the one state: at the other, and beyond it on both sides.
constexpr double places[] = {-1.0, -8.0, 8.0};

bool has_forces(const Model& model) {
  return !model.forces().empty() || !model.joint_forces().empty() || !model.user_forces().empty();
}

// What forces take is odd in the velocities, unlike what comes of inertia, so that half the difference of accelerations
// at v and -v is looked at. Forces that only take energy give an error e of the velocities the acceleration
// a = -M^-1 C e, C symmetric and not negative, apart from what they also depend on. Of modes with the rates c_k,
// orthogonal by M, the fast one is
//   e_fast = -a / c,   c = -(a . a) / (e . a)   by M,
// which leaves the slow ones where they are: the best that is along a. Of several fast ones a part of all is left, too.
// These are differences, not derivatives: friction that is saturated takes back no more than it can. It has the same
// force at two states that slip to the same side, and stops both: its rate is that between these and one that slips to
// the other, s e away, where 2 mu N h / m is not much less than that.
class Separation {
 public:
  Separation(Dynamics& dynamics, double t, double h, const VectorXd& a, const VectorXd& b)
      : system_(dynamics.system()), parts_(ConnectedParts::of(system_)), h_(h), out_(parts_.count()) {
    e_ = (a - b).segment(system_.q_size(), system_.v_size());
    fast_.setZero(e_.size());
    for (const double place : places) differences_.push_back(acceleration(dynamics, t, a, place));
    const VectorXd here = acceleration(dynamics, t, a, 0.0);
    for (std::size_t k = 0; k < differences_.size(); ++k) differences_[k] = (differences_[k] - here) / places[k];
  }

  std::vector<DampedError> result() {
    rates_.setZero(parts_.count());
    for (const VectorXd& difference : differences_) look_along(difference);
    if (rates_.isZero(0.0)) return {};
    for (int body = 0; body < system_.body_count(); ++body) separate(body, rates_[part(body)]);
    return std::move(out_);
  }

 private:
  int part(int body) const { return parts_.of_body(body); }

  VectorXd acceleration(Dynamics& dynamics, double t, VectorXd y, double place) const {
    VectorXd v_dot(system_.v_size()), reversed(system_.v_size()), lambda = VectorXd::Zero(system_.row_count());
    auto v = y.segment(system_.q_size(), system_.v_size());
    v += place * e_;
    dynamics.evaluate(t, y);
    dynamics.accelerations(v_dot, lambda);
    v = -v;
    dynamics.evaluate(t, y);
    dynamics.accelerations(reversed, lambda);
    return 0.5 * (v_dot - reversed);
  }

  /// Finds c and e_fast of parts that take it back soon, where no difference before has shown that.
  void look_along(const VectorXd& a) {
    VectorXd squared = VectorXd::Zero(rates_.size()), along = squared, rates = squared, whole = squared;
    for (int body = 0; body < system_.body_count(); ++body) {
      squared[part(body)] += product(body, a, a);
      along[part(body)] += product(body, e_, a);
      whole[part(body)] += product(body, e_, e_);
    }
    for (Eigen::Index k = 0; k < rates_.size(); ++k) {
      const double rate = -squared[k] / along[k];
      const bool fades = along[k] < 0.0 && std::isfinite(rate) && rate * h_ >= soon;
      if (rates_[k] == 0.0 && fades && along[k] * along[k] >= most * squared[k] * whole[k]) rates[k] = rate;
    }
    for (int body = 0; body < system_.body_count(); ++body)
      if (const double rate = rates[part(body)]; rate > 0.0)
        fast_.segment<6>(velocity_size * body) = -a.segment<6>(velocity_size * body) / rate;
    rates_ += rates;
  }

  void separate(int body, double rate) {
    DampedError& out = out_[part(body)];
    const Eigen::Matrix<double, 6, 1> fast = fast_.segment<6>(velocity_size * body);
    const Eigen::Matrix<double, 6, 1> slow = e_.segment<6>(velocity_size * body) - fast;
    if (rate > 0.0) {
      out.lasting.raise({fast.head<3>().norm() / rate, fast.tail<3>().norm() / rate, 0.0, 0.0});
      const double share = std::min(rate * h_, 1.0);
      out.fading.raise({0.0, 0.0, fast.head<3>().norm() / share, fast.tail<3>().norm() / share});
    }
    out.lasting.raise({0.0, 0.0, slow.head<3>().norm(), slow.tail<3>().norm()});
  }

  double product(int body, const VectorXd& a, const VectorXd& b) const {
    const Eigen::Index v = velocity_size * body;
    return system_.mass(body) * a.segment<3>(v).dot(b.segment<3>(v)) +
           a.segment<3>(v + 3).dot(system_.inertia(body) * b.segment<3>(v + 3));
  }

  const System& system_;
  const ConnectedParts& parts_;
  double h_;
  VectorXd e_, fast_;
  std::vector<VectorXd> differences_;  ///< a of e, as it is at each of the places
  VectorXd rates_;                     ///< c of each part [1/s], 0 where nothing is taken back so soon
  std::vector<DampedError> out_;
};

}  // namespace

std::vector<DampedError> find_damped_errors(Dynamics& dynamics, double t, double h, const VectorXd& a,
                                            const VectorXd& b) {
  const System& system = dynamics.system();
  if (!has_forces(system.model())) return {};
  if ((a - b).segment(system.q_size(), system.v_size()).isZero(0.0)) return {};
  dynamics.evaluate(t, a);
  if (dynamics.evaluation().power == 0.0) return {};
  return Separation(dynamics, t, h, a, b).result();
}

}  // namespace linkwork
