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
  look_for_interruption();
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
  look_for_interruption();
  if (with_reactions_) add_reactions(t, y.head(nq), lambda);
  look_for_interruption();  // and not before the frame is there as a whole
  if (turns_) turns_->record(t, y.head(nq), y.segment(nq, nv));
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
  look_for_interruption();
}

void Recorder::pass(double t, const VectorXd& y) {
  const System& system = dynamics_.system();
  if (turns_) turns_->pass(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()));
}

void Recorder::correct_last(const VectorXd& y, const ConstVector& v_dot, const ConstVector& lambda) {
  const System& system = dynamics_.system();
  const double t = frames_.t.back();
  const std::size_t before = frames_.t.size() - 1;
  frames_.t.resize(before);
  frames_.q.resize(before * system.q_size());
  for (std::vector<double>* list : {&frames_.v, &frames_.v_dot}) list->resize(before * system.v_size());
  frames_.lambda.resize(before * system.row_count());
  for (std::vector<double>* list : {&frames_.kinetic, &frames_.potential, &frames_.work}) list->resize(before);
  frames_.violation.resize(3 * before);
  frames_.history.resize(before * dynamics_.evaluation().history.size());
  record(t, y, v_dot, lambda);
}

/// Of the frame that comes next: by the D of the step that is just here, where it is that of this very pose.
void Recorder::add_reactions(double t, const ConstVector& q, const ConstVector& lambda) {
  const System& system = dynamics_.system();
  const std::size_t joints = system.joint_count(), first = 3 * joints * frames_.t.size();
  for (std::vector<double>* list : {&frames_.reaction_force, &frames_.reaction_torque})
    list->resize(first + 3 * joints);
  const auto columns = [&](std::vector<double>& list) {
    return Eigen::Map<Eigen::Matrix3Xd>(list.data() + first, 3, system.joint_count());
  };
  auto force = columns(frames_.reaction_force), torque = columns(frames_.reaction_torque);
  if (dynamics_.has_D_of(t, q)) return dynamics_.reactions(lambda, force, torque);
  if (!anew_) anew_ = std::make_unique<Evaluation>(system.make_evaluation());
  const VectorXd rest = VectorXd::Zero(system.v_size());
  system.evaluate_constraints(t, q, rest, dynamics_.evaluation().history, *anew_);
  system.reactions(*anew_, q, lambda, force, torque);
}

}  // namespace linkwork
