#include "linkwork/formulation/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "linkwork/constraints/least_constrained_motion.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/formulation/not_finite.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/memory.hpp"
#include "linkwork/math/names.hpp"
#include "linkwork/math/pieces.hpp"
#include "linkwork/math/stopwatch.hpp"
#include "linkwork/math/thread_pool.hpp"

namespace linkwork {
namespace {

constexpr int dense_rows = 32;      // up to this size a dense factorization is faster than any sparse one
constexpr int large_model = 10000;  // bodies from which memory counts
constexpr int timed_bodies = 20;    // below, a look at the clock takes as long as an evaluation: few of them are timed
constexpr int timed_evaluations = 17;  // the first ones, then one in so many: not always the same stage of a step
constexpr int most_refinements = 20;

/// The matrix of the formulation: as asked for, or one that suits the linear solver.
std::string choose_form(const FormulationInfo& info, const Options& options, bool redundant) {
  const bool given = options.matrix_form != "auto", one = info.forms.size() == 1;
  if (given && std::find(info.forms.begin(), info.forms.end(), options.matrix_form) == info.forms.end()) {
    const std::string choices =
        one ? "it has one form only; leave matrix_form at 'auto'" : "choose from: " + joined(info.forms);
    throw OptionError("matrix_form", "matrix_form '" + options.matrix_form + "' is not one of formulation '" +
                                         info.name + "'; " + choices);
  }
  if (given) return options.matrix_form;
  const auto of_kind = [&](bool definite) {
    const auto is = [&](const std::string& form) { return matrix_form(form).definite == definite; };
    const auto found = std::find_if(info.forms.begin(), info.forms.end(), is);
    return found == info.forms.end() ? info.forms.front() : *found;
  };
  if (options.linear_solver == "auto") return of_kind(false);
  const LinearSolverInfo& solver = linear_solver_info(options.linear_solver);
  return of_kind(!solver.make_saddle && (redundant || solver.positive_definite || solver.dense));
}

/// Solvers of the blocks themselves need a regular mass matrix, and take redundant rows in every form that they have.
/// Else a dense one where the matrix is small, or the first of the list that can; a dense one where no other can.
std::string choose_solver(const std::string& form, const FormulationInfo& info, const Options& options,
                          const System& system) {
  if (options.linear_solver != "auto") return options.linear_solver;
  const bool regular = system.massless_bodies().empty() || info.regularizes_inertia;
  const MatrixForm& unknowns = matrix_form(form);
  const int size = unknowns.velocities * system.v_size() + unknowns.multipliers * system.row_count();
  const auto suits = [&](const LinearSolverInfo& solver) {
    const bool best = solver.make_saddle ? regular : solver.dense == (size <= dense_rows);
    return best && solver.available() && can_solve(form, solver) && !(options.deterministic && solver.blas);
  };
  const auto& all = linear_solvers();
  auto found = std::find_if(all.begin(), all.end(), suits);
  if (found == all.end()) found = std::find_if(all.begin(), all.end(), [](const auto& it) { return it.dense; });
  return found->name;
}

}  // namespace

Dynamics::Dynamics(const Model& model, const Options& options, const Dynamics* like, const OnePath&)
    : options_(resolve(options)),
      system_(model),
      kind_(stabilization_info(options_.stabilization).kind),
      at_(system_.make_evaluation()) {
  use_threads();
  const FormulationInfo& info = formulation_info(options_.formulation);
  look_for_interruption();
  find_rank(like);
  look_for_interruption();
  options_.matrix_form = choose_form(info, options_, !rank_.redundant_rows.empty());
  options_.linear_solver = choose_solver(options_.matrix_form, info, options_, system_);
  lambda_.setZero(system_.row_count());
  now_.y = initial_y();
  now_.history = system_.initial_history();
  system_.evaluate(0.0, now_.y.head(system_.q_size()), now_.y.segment(system_.q_size(), system_.v_size()), now_.history,
                   at_);
  now_.history = initial_history_ = at_.history;
  check_masses();
  check_kkt();
  const LinearSolverInfo& solver = linear_solver_info(options_.linear_solver);
  check_deterministic();
  look_for_interruption();
  formulation_ = std::make_unique<WatchedFormulation>(
      system_, at_, now_, info.make(make_saddle_solver(options_.matrix_form, solver, system_), options_),
      DroppedRows(system_, rank_.redundant_rows));
  look_for_interruption();
  if (!unconnected()) formulation_->start(info.needs_full_rank, info.needs_full_rank || solver.make_saddle);
  settle_threads();
  if (unconnected()) return;
  if (!formulation_->watched() && options_.on_singular != "pass")
    throw OptionError("unwatched", "on_singular '" + options_.on_singular + "': formulation '" + info.name +
                                       "' with linear solver '" + options_.linear_solver +
                                       "' has no pivots that tell a singular pose; use linear solver 'block', or "
                                       "on_singular 'pass'");
  if (!rank_.singular_rows.empty()) formulation_->watch().start(1.0);
  if (system_.body_count() <= large_model) return;
  look_for_interruption();
  return_free_memory();
}

Dynamics::~Dynamics() = default;

/// Of two by other instructions the last bits differ.
void Dynamics::find_rank(const Dynamics* like) {
  if (like && like->options_.deterministic == options_.deterministic && same_geometry(like->system_, system_)) {
    rank_ = like->rank_;
    return block::share_orders(like->system_, system_);
  }
  rank_ = examine_rank(system_, at_);
  if (rank_.redundant_rows.empty()) rank_.q.resize(0);  // for their groups
}

void Dynamics::use_threads() {
  const int threads = options_.threads ? *options_.threads : usable_cores();
  if (threads > 1) system_.use(std::make_shared<ThreadPool>(threads));
}

/// None but the caller's where there is too little work to share. The options say how many there are.
void Dynamics::settle_threads() {
  const bool solver_shares = !unconnected() && formulation_->saddle().shares_work();
  options_.threads = system_.shares_work() || solver_shares ? system_.threads().threads() : 1;
  if (*options_.threads == 1 && system_.threads().threads() > 1) system_.use(std::make_shared<ThreadPool>());
}

void Dynamics::check_masses() const {
  if (system_.massless_bodies().empty()) return;
  const double roundoff = roundoff_of_positions(system_, now_.y.head(system_.q_size()));
  const std::vector<int> free = free_massless_bodies(system_, at_, std::max(rank_tolerance, roundoff));
  if (free.empty()) return;
  ErrorDetails details;
  details.bodies = {system_.model().body_name(free.front())};
  throw SingularSystemError("free_massless_body",
                            "body '" + details.bodies.front() +
                                "' has a motion without inertia that no joint resists, " +
                                describe_least_constrained_motion(system_, at_, free.front()) +
                                "; give it mass and inertia, or hold it by joints",
                            details);
}

void Dynamics::check_deterministic() const {
  if (!options_.deterministic || !linear_solver_info(options_.linear_solver).blas) return;
  throw OptionError("deterministic", "deterministic: linear solver '" + options_.linear_solver +
                                         "' uses BLAS, which has other bits on other processors; use linear solver "
                                         "'block', 'klu', 'eigen_ldlt' or 'dense'");
}

/// The kkt matrix of the sparse and dense solvers has no place for E, and so none for dropped rows.
void Dynamics::check_kkt() const {
  if (rank_.redundant_rows.empty() || matrix_form(options_.matrix_form).definite ||
      linear_solver_info(options_.linear_solver).make_saddle)
    return;
  throw OptionError("redundant_kkt", "matrix_form 'kkt' with linear solver '" + options_.linear_solver +
                                         "' takes no redundant constraints, and " +
                                         std::to_string(rank_.redundant_rows.size()) + " of " +
                                         std::to_string(rank_.rows) +
                                         " equations are (see linkwork check); use matrix_form 'schur', or linear "
                                         "solver 'block'");
}

void Dynamics::set_history(const ConstVector& history) {
  if (history.size() != now_.history.size())
    throw OptionError("history", "the mechanism has " + std::to_string(now_.history.size()) +
                                     " history variables, not " + std::to_string(history.size()));
  now_.history = history;
}

DynamicsStatistics Dynamics::statistics() const {
  DynamicsStatistics out = statistics_;
  out.factorizations = formulation_->factorizations();
  out.smallest_pivot = formulation_->smallest_pivot();
  return out;
}

VectorXd Dynamics::initial_y() const {
  VectorXd y(y_size());
  y << system_.model().initial_q(), system_.model().initial_v(), 0.0;
  return y;
}

FactorizationCost Dynamics::factorization_cost() const {
  if (unconnected()) return {.flops = 0.0, .bytes = 0};
  const SaddleSolver& saddle = formulation_->saddle();
  std::int64_t kkt_nonzeros = 21 * std::int64_t{system_.body_count()};  // half of [M D^T; D 0] by blocks
  for (const ConstraintBlock& block : system_.blocks()) kkt_nonzeros += 6 * std::int64_t{block.rows};
  return {.matrix_nonzeros = saddle.matrix_nonzeros().value_or(kkt_nonzeros),
          .factor_nonzeros = saddle.factor_nonzeros(),
          .flops = saddle.flops(),
          .bytes = saddle.factor_bytes()};
}

const IterationStatistics& Dynamics::iterations() const { return formulation_->formulation().iterations(); }

const SingularWatch& Dynamics::watch() const { return formulation_->watch(); }

const DroppedRows& Dynamics::dropped() const { return formulation_->dropped(); }

double Dynamics::assemble_time() const { return formulation_->saddle().assemble_time(); }

/// How many evaluations the time of this one stands for.
int Dynamics::evaluations_on_the_clock() const {
  if (statistics_.evaluations < timed_evaluations || system_.body_count() >= timed_bodies) return 1;
  return statistics_.evaluations % timed_evaluations == 0 ? timed_evaluations : 0;
}

void Dynamics::evaluate(double t, const ConstVector& y, int stage) {
  meter_.add(system_.body_count());
  observe_now();
  now_.t = t;
  now_.stage = stage;
  now_.y.resize(y.size());
  in_pieces(system_.threads(), y.size(),
            [&](Eigen::Index first, Eigen::Index count) { now_.y.segment(first, count) = y.segment(first, count); });
  clocked_ = evaluations_on_the_clock();
  {
    const Stopwatch watch(statistics_.evaluate_time, clocked_);
    system_.evaluate(t, now_.y.head(system_.q_size()), now_.y.segment(system_.q_size(), system_.v_size()), now_.history,
                     at_);
    statistics_.evaluations += 1;
  }
  formulation_->begin();
  if (looks_for_switches()) look_for_switches(at_.switches);
  if (traces_) look_for_nan(true);
}

Evaluation& Dynamics::begin_elsewhere(double t, const ConstVector& y) {
  observe_now();
  now_.t = t;
  now_.stage = 1;
  now_.y = y;
  formulation_->begin_elsewhere();
  return at_;
}

void Dynamics::require_accuracy(double relative) {
  if (!unconnected()) formulation_->require_accuracy(relative);
}

void Dynamics::factorize() {
  if (unconnected() || formulation_->factorized()) return;
  const Stopwatch watch(statistics_.factorize_time, clocked_);
  formulation_->factorize(at_);
}

void Dynamics::observe(std::function<void()> look) {
  if (formulation_->factorized() || unconnected()) return look();
  observer_ = std::move(look);
}

void Dynamics::observe_now() {
  if (observer_) std::exchange(observer_, {})();
}

void Dynamics::keep(Archive& archive) {
  RowChoice choice = formulation_->row_choice();
  archive(choice);
  if (archive.reading() && !std::isnan(choice.t)) {
    if (choice.y.size() != y_size()) throw OptionError("start", "start: what it has to go on from is of another model");
    set_history(choice.history);
    evaluate(choice.t, choice.y);
    formulation_->repeat_choice(choice.rows);
  }
  archive(now_.history, sides_, switched_, held_, held_u_, first_part_, *formulation_);
}

Dynamics::Place Dynamics::place() const {
  return {.t = now_.t, .y = now_.y, .factorized = formulation_->factorized(), .fallback = formulation_->fallback()};
}

void Dynamics::return_to(const Place& place) {
  formulation_->look(true);
  evaluate(place.t, place.y);
  if (place.factorized) factorize();
  if (place.fallback && !formulation_->fallback()) formulation_->fall_back();
  formulation_->look(false);
}

void Dynamics::take_sides(double least) {
  sides_.resize(at_.switches.size(), 0);
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (const double value = at_.switches[static_cast<Eigen::Index>(k)]; std::abs(value) > least)
      sides_[k] = value > 0.0;
}

void Dynamics::look_for_switches(const VectorXd& switches) {
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (const double value = switches[static_cast<Eigen::Index>(k)];
        value != 0.0 && (value > 0.0) != (sides_[k] != 0)) {
      if (!std::exchange(switched_, true)) elsewhere_ = {};
      if (std::abs(value) > elsewhere_.by) elsewhere_ = {static_cast<int>(k), std::abs(value)};
    }
}

void Dynamics::solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  find_solution(a, b, v_dot, lambda);
  if (observer_) observe_now();
}

void Dynamics::find_solution(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  meter_.add(system_.body_count());
  statistics_.solves += 1;
  if (unconnected()) return system_.multiply_inverse_mass(a, v_dot);
  if (!formulation_->factorized()) {
    const Stopwatch watch(statistics_.factorize_time, clocked_);
    return formulation_->factorize_and_solve(at_, a, b, v_dot, lambda);
  }
  const Stopwatch watch(statistics_.solve_time, clocked_);
  formulation_->solve(a, b, v_dot, lambda);
}

void Dynamics::accelerations(MutableVector v_dot, MutableVector lambda) {
  solve(at_.g.head(system_.v_size()), at_.gamma, v_dot, lambda);
  formulation_->distribute(lambda);
}

/// Whatever the formulation solves of them: the penalty method's own solution, too, becomes that of (12.3).
void Dynamics::refined_accelerations(MutableVector v_dot, MutableVector lambda) {
  const auto g = at_.g.head(system_.v_size());
  const auto nearby = [this](const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector multipliers) {
    solve(a, b, x, multipliers);
  };
  solve(g, at_.gamma, v_dot, lambda);
  if (unconnected()) return;
  Refinement refinement(system_);
  double last = INFINITY;
  for (int k = 0; k < most_refinements; ++k) {
    refinement.correct(at_, g, at_.gamma, v_dot, lambda, nearby);
    const double change = refinement.dx().norm();
    if (!(change < 0.5 * last)) break;
    last = change;
  }
  formulation_->distribute(lambda);
}

void Dynamics::acceleration_residual(const ConstVector& v_dot, MutableVector residual) {
  formulation_->dropped().put_back(at_);
  system_.multiply_D(at_, v_dot, residual);
  residual -= at_.gamma;
  formulation_->dropped().take_out(at_);
}

/// Bits, as zeros have signs. The D of special joints may go by their history, which goes on where a state is accepted.
bool Dynamics::has_D_of(double t, const ConstVector& q) const {
  const auto same = [](const double* a, const double* b, Eigen::Index count) {
    return std::memcmp(a, b, sizeof(double) * static_cast<std::size_t>(count)) == 0;
  };
  if (formulation_->elsewhere() || system_.has_special_joints()) return false;
  if (system_.time_dependent_constraints() && !same(&t, &now_.t, 1)) return false;
  return now_.y.size() == y_size() && q.size() == system_.q_size() && same(q.data(), now_.y.data(), q.size());
}

void Dynamics::reactions(const ConstVector& lambda, Eigen::Ref<Eigen::Matrix3Xd> force,
                         Eigen::Ref<Eigen::Matrix3Xd> torque) {
  formulation_->dropped().put_back(at_);
  system_.reactions(at_, now_.y.head(system_.q_size()), lambda, force, torque);
  formulation_->dropped().take_out(at_);
}

Gains Dynamics::gains_or(Gains defaults) const {
  return {options_.baumgarte_alpha.value_or(defaults.alpha), options_.baumgarte_beta.value_or(defaults.beta)};
}

void Dynamics::begin_zero_order_hold(Gains gains, double h) {
  if (!sampled() || (held_ && first_part_ > 0.0)) return;
  const double share = first_part_ > 0.0 ? first_part_ : share_of_correction(h, correction_length_);
  if (share < 1.0) gains = {gains.alpha * share, gains.beta * share};
  gains = gains_or(gains);
  held_u_ = -2.0 * gains.alpha * at_.Phi_dot - gains.beta * gains.beta * at_.Phi;
  held_ = true;
}

void Dynamics::add_correction(double h, MutableVector y) {
  if (!sampled() || unconnected()) return;
  const Gains gains = gains_or({0.5 / h, 1.0 / h});
  const VectorXd none = VectorXd::Zero(system_.v_size());
  x_.resize(system_.v_size());
  b_ = -2.0 * gains.alpha * h * at_.Phi_dot;
  solve(none, b_, x_, lambda_);
  y.segment(system_.q_size(), system_.v_size()) += x_;
  b_ = -gains.beta * gains.beta * h * h * at_.Phi;
  solve(none, b_, x_, lambda_);
  VectorXd dq(system_.q_size());
  system_.position_rates(now_.y.head(system_.q_size()), x_, dq);
  y.head(system_.q_size()) += dq;
}

void Dynamics::rates(MutableVector y_dot) {
  const bool continuous = kind_ == StabilizationKind::baumgarte;
  if (!continuous && !held_) return rates(at_.gamma, y_dot);
  const Gains gains = continuous ? gains_or({}) : Gains{};
  b_.resize(system_.row_count());
  in_pieces(system_.threads(), b_.size(), [&](Eigen::Index first, Eigen::Index count) {
    const auto of = [&](const VectorXd& rows) { return rows.segment(first, count); };
    auto b = b_.segment(first, count);
    b = of(at_.gamma);
    if (continuous) b -= 2.0 * gains.alpha * of(at_.Phi_dot) + gains.beta * gains.beta * of(at_.Phi);  // (12.8)
    else b += of(held_u_);
  });
  rates(b_, y_dot);
}

/// With b for gamma.
void Dynamics::rates(const ConstVector& b, MutableVector y_dot) {
  auto v_dot = y_dot.segment(system_.q_size(), system_.v_size());
  solve(at_.g.head(system_.v_size()), b, v_dot, lambda_);
  if (traces_) look_for_nan(v_dot.allFinite() && lambda_.allFinite());
  add_rates_of_position(lambda_, y_dot);
}

void Dynamics::rates(const ConstVector& v_dot, const ConstVector& lambda, MutableVector y_dot) const {
  in_pieces(system_.threads(), system_.v_size(), [&](Eigen::Index first, Eigen::Index count) {
    y_dot.segment(system_.q_size() + first, count) = v_dot.segment(first, count);
  });
  add_rates_of_position(lambda, y_dot);
}

/// And of the work. The power of the constraints is v^T D^T lambda = lambda . (Phi_dot - Phi_t): -lambda . Phi_t for
/// driven ones.
void Dynamics::add_rates_of_position(const ConstVector& lambda, MutableVector y_dot) const {
  const int nq = system_.q_size(), nv = system_.v_size();
  system_.position_rates(now_.y.head(nq), now_.y.segment(nq, nv), y_dot.head(nq));
  y_dot[nq + nv] = at_.power - system_.power_of_drivers(at_, lambda);
}

Busy::Busy(const Dynamics& dynamics) : dynamics_(dynamics), path_(dynamics.options().deterministic) {
  if (dynamics.busy_.test_and_set(std::memory_order_acquire))
    throw BusyError("busy",
                    "this System is at work, in another thread or for a function that calls it: it works for one "
                    "caller at a time, so make a System for each");
}

Unwatched::Unwatched(Dynamics& dynamics) : dynamics_(dynamics) { dynamics_.formulation().watch_evaluations(false); }

Unwatched::~Unwatched() { dynamics_.formulation().watch_evaluations(true); }

void Dynamics::look_for_nan(bool solution_is_finite) const {
  const bool finite = solution_is_finite && now_.y.allFinite() && at_.g.allFinite() && at_.Phi.allFinite() &&
                      at_.Phi_dot.allFinite() && at_.gamma.allFinite() && std::isfinite(at_.power);
  if (!finite) throw_not_finite(system_, now_.y, now_.t, now_.stage);
}

}  // namespace linkwork
