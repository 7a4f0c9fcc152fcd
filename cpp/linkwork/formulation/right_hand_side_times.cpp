#include "linkwork/formulation/right_hand_side_times.hpp"

#include <algorithm>
#include <limits>

#include "linkwork/constraints/redundancy_watch.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork {
namespace {

/// The parts of a right-hand side, with their results.
class RightHandSide {
 public:
  RightHandSide(Dynamics& dynamics, double t, const VectorXd& y)
      : dynamics_(dynamics),
        t_(t),
        y_(y),
        v_dot_(dynamics.system().v_size()),
        lambda_(dynamics.system().row_count()),
        force_(3, dynamics.system().joint_count()),
        torque_(3, dynamics.system().joint_count()) {}

  void evaluate() { dynamics_.evaluate(t_, y_); }
  void factorize() { dynamics_.factorize(); }
  /// As in a stage of an integrator: multipliers of redundant constraints are not distributed.
  void solve() {
    const Evaluation& at = dynamics_.evaluation();
    dynamics_.solve(at.g.head(dynamics_.system().v_size()), at.gamma, v_dot_, lambda_);
  }
  void whole() {
    evaluate();
    solve();
    reactions();
  }
  void reactions() {
    dynamics_.system().reactions(dynamics_.evaluation(), y_.head(dynamics_.system().q_size()), lambda_, force_,
                                 torque_);
  }

 private:
  Dynamics& dynamics_;
  double t_;
  VectorXd y_, v_dot_, lambda_;
  Eigen::Matrix3Xd force_, torque_;
};

template <class Part>
void timed(double& total, Part part) {
  const Stopwatch watch(total);
  part();
}

}  // namespace

RightHandSideTimes time_right_hand_sides(Dynamics& dynamics, double t, const VectorXd& y, int repeats) {
  RightHandSide f(dynamics, t, y);
  RightHandSideTimes times;
  const double assembled_before = dynamics.assemble_time();
  for (int k = 0; k < repeats; ++k) {
    timed(times.evaluate, [&] { f.evaluate(); });
    timed(times.factorize, [&] { f.factorize(); });
    timed(times.solve, [&] { f.solve(); });
    timed(times.reactions, [&] { f.reactions(); });
  }
  times.assemble = dynamics.assemble_time() - assembled_before;
  times.factorize -= times.assemble;
  timed(times.whole, [&] {
    for (int k = 0; k < repeats; ++k) f.whole();
  });
  return times;
}

void repeat_right_hand_side(Dynamics& dynamics, double t, const VectorXd& y, int repeats) {
  RightHandSide f(dynamics, t, y);
  for (int k = 0; k < repeats; ++k) f.whole();
}

double least_time_ahead(Dynamics& dynamics, double t, const VectorXd& y, double seconds) {
  const Unwatched unwatched(dynamics);
  VectorXd y_dot(dynamics.y_size());
  double least = std::numeric_limits<double>::infinity(), whole = 0.0;
  for (int k = 0; k < 2 || whole < seconds; ++k) {
    double one = 0.0;
    timed(one, [&] {
      dynamics.evaluate(t, y);
      dynamics.rates(y_dot);
    });
    least = std::min(least, one);
    whole += one;
  }
  return least;
}

double time_redundancy_watch(Dynamics& dynamics, double t, const VectorXd& y, int repeats) {
  const System& system = dynamics.system();
  RedundancyWatch watch(system, y.head(system.q_size()));
  const auto v = y.segment(system.q_size(), system.v_size());
  dynamics.evaluate(t, y);
  double time = 0.0;
  timed(time, [&] {
    bool any = false;
    for (int k = 0; k < repeats; ++k) {
      any = watch.suspicious(system, dynamics.evaluation(), dynamics.dropped(), v) || any;
      asm volatile("" : : "r"(any) : "memory");  // else once would be enough
    }
  });
  return time;
}

double time_analysis(const Dynamics& dynamics) {
  double time = 0.0;
  if (dynamics.system().row_count() == 0) return time;
  const Options& chosen = dynamics.options();
  const auto solver =
      make_saddle_solver(chosen.matrix_form, linear_solver_info(chosen.linear_solver), dynamics.system());
  block::kept_orders(dynamics.system()).forget();
  timed(time, [&] { solver->analyze(dynamics.formulation().inertia().system(), dynamics.evaluation()); });
  return time;
}

}  // namespace linkwork
