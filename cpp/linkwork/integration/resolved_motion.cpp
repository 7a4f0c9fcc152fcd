#include "linkwork/integration/resolved_motion.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double part_of_sigma = 0.1;    // of sigma: the way of a step
constexpr double most_turn = 0.1;        // of any body in a step [rad]
constexpr double most_fall = 0.5;        // of sigma in a step
constexpr double off_the_mean = 1e-2;    // of the velocities: by what those of a step are off the mean acceleration
constexpr double least_of_usual = 1e-4;  // of the usual one
constexpr double in_the_way = 1e-6;      // sigma of a pose
constexpr double of_blur = 10.0;         // of the root of the positions' roundoff: sigma in which they tell no branch
constexpr int most_resolved_steps = 4000;

}  // namespace

bool ResolvedMotion::follow(double t, const VectorXd& y, double t_end) {
  t_ = nearest_t_ = t;
  y_ = nearest_y_ = y;
  least_ = INFINITY;
  v_dot_.resize(dynamics_.system().v_size());
  lambda_.resize(dynamics_.system().row_count());
  const Unwatched unwatched(dynamics_);
  try {
    return go(t_end);
  } catch (const OptionError&) {
    throw;
  } catch (const Error&) {
    return false;
  }
}

bool ResolvedMotion::go(double t_end) {
  evaluate(t_, y_, rates_);
  sigma_ = dynamics_.formulation().least_singular_value();
  note_nearest();
  double shorter = 1.0;
  for (int k = 0; k < most_resolved_steps && !in_pose() && shorter > least_of_usual; ++k) {
    const double h = shorter * usual_step();
    const bool last = !(t_ + h < t_end);
    if (!step(last ? t_end - t_ : h)) {
      shorter *= 0.5;
      continue;
    }
    if (last) return true;
    shorter = std::min(2.0 * shorter, 1.0);
  }
  return false;
}

/// The classical method of fourth order, of rates that depend on a state by the one on the constraints next to it.
bool ResolvedMotion::step(double h) {
  VectorXd sum = rates_, k = rates_;
  for (const double at : {0.5, 0.5, 1.0}) {
    stage_ = y_ + at * h * k;
    evaluate(t_ + at * h, stage_, k);
    sum += (at < 1.0 ? 2.0 : 1.0) * k;
  }
  t_new_ = t_ + h;
  y_new_ = y_ + h / 6.0 * sum;
  evaluate(t_new_, y_new_, rates_new_);
  sigma_new_ = dynamics_.formulation().least_singular_value();
  const auto of_velocities = [&](const VectorXd& x) { return x.segment(dynamics_.system().q_size(), v_dot_.size()); };
  const VectorXd v = of_velocities(y_), v_new = of_velocities(y_new_);
  const VectorXd off = v_new - v - 0.5 * h * (of_velocities(rates_) + of_velocities(rates_new_));
  if (!(step_.size(off) <= off_the_mean * std::max(step_.size(v), step_.size(v_new)))) return false;
  if (!(sigma_new_ >= most_fall * sigma_)) return false;
  t_ = t_new_;
  sigma_ = sigma_new_;
  std::swap(y_, y_new_);
  std::swap(rates_, rates_new_);
  note_nearest();
  return true;
}

/// At y, which is taken to the constraints.
void ResolvedMotion::evaluate(double t, VectorXd& y, VectorXd& rates) {
  dynamics_.system().normalize(y.head(dynamics_.system().q_size()));
  step_.project(t, y);
  dynamics_.evaluate(t, y);
  dynamics_.refined_accelerations(v_dot_, lambda_);
  rates.resize(y.size());
  dynamics_.rates(v_dot_, lambda_, rates);
}

void ResolvedMotion::note_nearest() {
  if (sigma_ >= least_) return;
  least_ = sigma_;
  nearest_t_ = t_;
  nearest_y_ = y_;
}

double ResolvedMotion::usual_step() const {
  const System& system = dynamics_.system();
  const auto v = y_.segment(system.q_size(), system.v_size());
  double fastest = 0.0;
  for (int body = 0; body < system.body_count(); ++body) fastest = std::max(fastest, v.segment<3>(6 * body + 3).norm());
  return std::min(part_of_sigma * sigma_ / step_.size(v), most_turn / fastest);
}

bool ResolvedMotion::in_pose() const { return sigma_ <= std::max(in_the_way, of_blur * std::sqrt(step_.blur())); }

}  // namespace linkwork
