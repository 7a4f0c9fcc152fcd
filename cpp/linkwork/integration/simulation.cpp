#include "linkwork/integration/simulation.hpp"

#include <chrono>
#include <cmath>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double same_time = 1e-9;  // relative to the step: roundoff of t_end / step

double largest(const VectorXd& values) { return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0; }

void append(std::vector<double>& list, const ConstVector& values) {
  list.insert(list.end(), values.data(), values.data() + values.size());
}

}  // namespace

Simulation::Simulation(Dynamics& dynamics, std::unique_ptr<Integrator> integrator, const Schedule& schedule)
    : dynamics_(dynamics), integrator_(std::move(integrator)), schedule_(schedule), y_(dynamics.initial_y()) {
  if (!(schedule.step > 0.0) || !std::isfinite(schedule.step))
    throw OptionError("step", "step must be positive and finite");
  if (!(schedule.t_end >= 0.0) || !std::isfinite(schedule.t_end))
    throw OptionError("t_end", "t_end must be finite and not negative");
  if (schedule.record_every < 1) throw OptionError("record_every", "record_every must be at least 1");
  const double steps = std::ceil(schedule.t_end / schedule.step - same_time);
  if (steps > 1e15) throw OptionError("step", "t_end / step is more than 1e15 steps; use a larger step");
  steps_total_ = static_cast<std::int64_t>(steps);
  v_dot_.setZero(dynamics.system().v_size());
  lambda_.setZero(dynamics.system().row_count());
  y_dot_.resize(y_.size());
  if (integrator_) integrator_->start(static_cast<int>(y_.size()));
}

double Simulation::time_of(std::int64_t step) const {
  return step >= steps_total_ ? schedule_.t_end : static_cast<double>(step) * schedule_.step;
}

bool Simulation::recording_due() const {
  return steps_done_ == steps_total_ || steps_done_ % schedule_.record_every == 0;
}

Frames Simulation::advance(std::int64_t max_frames, double max_seconds) {
  const auto start = std::chrono::steady_clock::now();
  const auto out_of_time = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > max_seconds;
  };
  while (!finished_ && static_cast<std::int64_t>(frames_.t.size()) < max_frames) {
    const double h = begin_step();
    if (h > 0.0) {
      try {
        integrator_->step(dynamics_, t(), h, y_);
      } catch (Error& error) {
        if (std::isnan(error.details.time)) error.details.time = t();  // else the time of a stage
        error.details.step = h;
        throw;
      }
      finish_step();
    }
    if (out_of_time()) break;
  }
  return take_frames();
}

double Simulation::begin_step() {
  if (finished_) return 0.0;
  try {
    evaluate_and_record();
  } catch (Error& error) {
    error.details.time = t();
    throw;
  }
  finished_ = steps_done_ == steps_total_;
  return finished_ ? 0.0 : next_step();
}

void Simulation::evaluate_and_record() {
  if (evaluated_) return;
  dynamics_.evaluate(t(), y_);
  evaluated_ = true;
  if (!integrator_) add_work();
  if (!recording_due()) return;
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  dynamics_.accelerations(v_dot_, lambda_);
  if (!v_dot_.allFinite() || !lambda_.allFinite()) throw_not_finite(system, y_, t());
  const Evaluation& at = dynamics_.evaluation();
  VectorXd residual(system.row_count());
  dynamics_.acceleration_residual(v_dot_, residual);
  frames_.t.push_back(t());
  append(frames_.q, y_.head(nq));
  append(frames_.v, y_.segment(nq, nv));
  append(frames_.v_dot, v_dot_);
  append(frames_.lambda, lambda_);
  frames_.kinetic.push_back(system.kinetic_energy(y_.segment(nq, nv)));
  frames_.potential.push_back(at.potential);
  frames_.work.push_back(y_[nq + nv]);
  for (const VectorXd* rows : {&at.Phi, &at.Phi_dot, static_cast<const VectorXd*>(&residual)})
    frames_.violation.push_back(largest(*rows));
}

void Simulation::finish_step() {
  if (!y_.allFinite()) {
    try {
      throw_not_finite(dynamics_.system(), y_, t());
    } catch (Error& error) {
      error.details.time = time_of(steps_done_ + 1);
      error.details.step = next_step();
      throw;
    }
  }
  dynamics_.system().normalize(y_.head(dynamics_.system().q_size()));
  steps_done_ += 1;
  evaluated_ = false;
}

// The work of an integrator of the user's own, which returns only q and v, is a sum by the trapezoidal rule.
void Simulation::add_work() {
  dynamics_.rates(y_dot_);
  const double power = y_dot_.tail<1>()[0], h = t() - last_t_;
  if (steps_done_ > 0) y_.tail<1>()[0] += 0.5 * h * (last_power_ + power);
  last_power_ = power;
  last_t_ = t();
  dynamics_.hold_correction(deadbeat_gains(0.5, next_step()));
}

void Simulation::accept(const ConstVector& q_and_v) {
  const Eigen::Index size = y_.size() - 1;
  if (q_and_v.size() != size)
    throw OptionError("integrator", "the integrator returned " + std::to_string(q_and_v.size()) + " numbers, not " +
                                        std::to_string(size));
  dynamics_.release_correction();
  y_.head(size) = q_and_v;
  finish_step();
}

}  // namespace linkwork
