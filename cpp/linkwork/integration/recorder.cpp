#include "linkwork/integration/recorder.hpp"

#include "linkwork/formulation/not_finite.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

double largest(const VectorXd& values) { return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0.0; }

void append(std::vector<double>& list, const ConstVector& values) {
  list.insert(list.end(), values.data(), values.data() + values.size());
}

}  // namespace

Recorder::Recorder(Dynamics& dynamics)
    : dynamics_(dynamics),
      v_dot_(VectorXd::Zero(dynamics.system().v_size())),
      lambda_(VectorXd::Zero(dynamics.system().row_count())),
      residual_(dynamics.system().row_count()) {}

void Recorder::record(double t, const VectorXd& y) {
  dynamics_.accelerations(v_dot_, lambda_);
  record(t, y, v_dot_, lambda_);
}

void Recorder::record_in_step(double t, const VectorXd& y) {
  waiting_t_ = t;
  waiting_y_ = y;
  dynamics_.observe([this, here = std::weak_ptr<char>(here_)] {
    if (!here.expired()) record(waiting_t_, waiting_y_);
  });
}

void Recorder::finish() {
  try {
    dynamics_.observe_now();
  } catch (const Error&) {  // there is no acceleration, which was the reason to end
  }
}

void Recorder::record(double t, const VectorXd& y, const ConstVector& v_dot, const ConstVector& lambda) {
  const System& system = dynamics_.system();
  const int nq = system.q_size(), nv = system.v_size();
  if (!v_dot.allFinite() || !lambda.allFinite()) throw_not_finite(system, y, t);
  const Evaluation& at = dynamics_.evaluation();
  dynamics_.acceleration_residual(v_dot, residual_);
  if (t <= silent_until_) return;
  frames_.t.push_back(t);
  append(frames_.q, y.head(nq));
  append(frames_.v, y.segment(nq, nv));
  append(frames_.v_dot, v_dot);
  append(frames_.lambda, lambda);
  frames_.kinetic.push_back(system.kinetic_energy(at, y.segment(nq, nv)));
  frames_.potential.push_back(at.potential);
  frames_.work.push_back(y[nq + nv]);
  for (const VectorXd* rows : {&at.Phi, &at.Phi_dot, static_cast<const VectorXd*>(&residual_)})
    frames_.violation.push_back(largest(*rows));
  append(frames_.history, at.history);
}

}  // namespace linkwork
