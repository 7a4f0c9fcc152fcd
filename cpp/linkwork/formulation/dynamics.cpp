#include "linkwork/formulation/dynamics.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/least_held_motion.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/memory.hpp"
#include "linkwork/math/stopwatch.hpp"

namespace linkwork {
namespace {

constexpr int dense_rows = 32;       // up to this size a dense factorization is faster than any sparse one
constexpr int polled_bodies = 1000;  // below, an evaluation is too short to be worth interrupting
constexpr int large_model = 10000;   // bodies from which memory counts
constexpr int timed_bodies = 20;     // below, a look at the clock takes as long as an evaluation: few of them are timed
constexpr int timed_evaluations = 17;   // the first ones, then one in so many: not always the same stage of a step
constexpr double crossed_pivot = 1e-6;  // in a singular pose that is known to some 1e-4 rad
constexpr double well_chosen = 0.1;     // root of the smallest pivot, relative to the usual one
constexpr double better = 1.5;          // times the root of the smallest pivot, for other redundant rows
constexpr int most_refinements = 20;
constexpr int first_iterations = 4, more_iterations = 2;  // toward the least singular value
constexpr double news = 0.1;                              // part of a vector in any direction
constexpr double broken = -1.0;                           // for a pivot of a factorization that broke down
constexpr double diverged = 1e50;  // velocities of which nothing else is to blame for what follows
constexpr auto poll_interval = std::chrono::milliseconds(50);

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
  return out;
}

/// The matrix of the formulation: as asked for, or the first that the linear solver can factorize.
std::string choose_form(const FormulationInfo& info, const Options& options, bool redundant) {
  const bool given = options.system != "auto";
  if (given && std::find(info.forms.begin(), info.forms.end(), options.system) == info.forms.end()) {
    const std::string choices =
        info.forms.size() > 1 ? "choose from: " + joined(info.forms) : "it has one form only; leave system at 'auto'";
    throw OptionError("system",
                      "system '" + options.system + "' is not one of formulation '" + info.name + "'; " + choices);
  }
  if (given) return options.system;
  if (info.name != "standard") return info.forms.front();
  if (options.linear_solver == "auto") return "kkt";
  const LinearSolverInfo& solver = linear_solver_info(options.linear_solver);
  if (solver.make_saddle) return "kkt";
  return redundant || solver.positive_definite || solver.name == "dense" ? "schur" : "kkt";
}

/// "block" needs a regular mass matrix, which `standard` provides, and takes redundant rows in every form that it has.
std::string choose_solver(const std::string& form, const Options& options, const System& system) {
  if (options.linear_solver != "auto") return linear_solver_info(options.linear_solver).name;
  const bool regular = system.massless_bodies().empty() || options.formulation == "standard";
  if (form != "schur" && regular) return "block";
  const int size = form == "schur" ? system.row_count() : system.v_size() + (form == "kkt" ? system.row_count() : 0);
  if (size <= dense_rows) return "dense";
  return form == "kkt" ? first_available({"umfpack", "klu"}) : first_available({"cholmod", "eigen_ldlt"});
}

}  // namespace

Dynamics::Dynamics(const Model& model, const Options& options)
    : options_(options),
      system_(model),
      kind_(stabilization_kind(options.stabilization)),
      at_(system_.make_evaluation()) {
  const FormulationInfo& info = formulation_info(options.formulation);
  check_options(options);
  rank_ = examine_rank(system_);
  dropped_ = DroppedRows(system_, rank_.redundant_rows);
  options_.system = choose_form(info, options, !dropped_.empty());
  options_.linear_solver = choose_solver(options_.system, options, system_);
  for (VectorXd* rows : {&b_, &lambda_}) rows->setZero(system_.row_count());
  for (VectorXd* velocities : {&x_, &v_dot_}) velocities->setZero(system_.v_size());
  y_ = initial_y();
  history_ = system_.initial_history();
  system_.evaluate(0.0, y_.head(system_.q_size()), y_.segment(system_.q_size(), system_.v_size()), history_, at_);
  history_ = initial_history_ = at_.history;
  check_masses();
  check_kkt();
  formulation_ = info.make(make_saddle_solver(options_.system, linear_solver_info(options_.linear_solver)), options_);
  if (system_.row_count() == 0) return;
  inertia_ = std::make_unique<FilledInertia>(system_, at_);
  const ConstraintRows rows{row_mobility(inertia_->system(), at_), dropped_.rows(), inertia_.get()};
  minimum_norm_ = MinimumNorm(system_, rows.mobility, dropped_);
  dropped_.take_out(at_);
  scale_rows(rows.mobility);
  formulation_->analyze(system_, at_, rows);
  rank_needed_ = info.needs_full_rank;
  watched_ = rank_needed_ || linear_solver_info(options_.linear_solver).make_saddle;
  if (!watched_ && options_.on_singular != "pass")
    throw OptionError("unwatched", "on_singular '" + options_.on_singular + "': formulation '" + info.name +
                                       "' with linear solver '" + options_.linear_solver +
                                       "' has no pivots that tell a singular pose; use linear solver 'block', or "
                                       "on_singular 'pass'");
  if (!rank_.singular_rows.empty()) watch_.start(1.0);
  if (system_.body_count() > large_model) return_free_memory();
}

void Dynamics::check_masses() const {
  if (system_.massless_bodies().empty()) return;
  const std::vector<int> free = free_massless_bodies(system_, at_);
  if (free.empty()) return;
  ErrorDetails details;
  details.bodies = {system_.model().body_name(free.front())};
  throw SingularSystemError(
      "free_massless_body",
      "body '" + details.bodies.front() + "' has a motion without inertia that no joint resists, " +
          describe_least_held_motion(system_, at_, free.front()) + "; give it mass and inertia, or hold it by joints",
      details);
}

/// The kkt matrix of the sparse and dense solvers has no place for E, and so none for dropped rows.
void Dynamics::check_kkt() const {
  if (dropped_.empty() || options_.system != "kkt" || linear_solver_info(options_.linear_solver).make_saddle) return;
  throw OptionError("redundant_kkt", "system 'kkt' with linear solver '" + options_.linear_solver +
                                         "' takes no redundant constraints, and " + std::to_string(dropped_.count()) +
                                         " of " + std::to_string(rank_.rows) +
                                         " equations are (see linkwork check); use system 'schur', or linear solver "
                                         "'block'");
}

void Dynamics::set_history(const ConstVector& history) {
  if (history.size() != history_.size())
    throw OptionError("history", "the mechanism has " + std::to_string(history_.size()) + " history variables, not " +
                                     std::to_string(history.size()));
  history_ = history;
}

VectorXd Dynamics::initial_y() const {
  VectorXd y(y_size());
  y << system_.model().initial_q(), system_.model().initial_v(), 0.0;
  return y;
}

FactorizationCost Dynamics::factorization_cost() const {
  if (system_.row_count() == 0) return {0, 0, 0.0, 0};
  const SaddleSolver& saddle = formulation_->saddle();
  std::int64_t kkt_nonzeros = 21 * std::int64_t{system_.body_count()};  // half of [M D^T; D 0] by blocks
  for (const ConstraintBlock& block : system_.blocks()) kkt_nonzeros += 6 * std::int64_t{block.rows};
  return {saddle.matrix_nonzeros().value_or(kkt_nonzeros), saddle.factor_nonzeros(), saddle.flops(),
          saddle.factor_bytes()};
}

double Dynamics::assemble_time() const { return formulation_->saddle().assemble_time(); }

void Dynamics::poll() {
  if (!interrupt_ || system_.body_count() < polled_bodies) return;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_poll_ < poll_interval) return;
  last_poll_ = now;
  interrupt_();
}

/// How many evaluations the time of this one stands for.
int Dynamics::evaluations_on_the_clock() const {
  if (statistics_.evaluations < timed_evaluations || system_.body_count() >= timed_bodies) return 1;
  return statistics_.evaluations % timed_evaluations == 0 ? timed_evaluations : 0;
}

void Dynamics::evaluate(double t, const ConstVector& y, int stage) {
  poll();
  observe_now();
  t_ = t;
  stage_ = stage;
  y_ = y;
  clocked_ = evaluations_on_the_clock();
  {
    const Stopwatch watch(statistics_.evaluate_time, clocked_);
    system_.evaluate(t, y_.head(system_.q_size()), y_.segment(system_.q_size(), system_.v_size()), history_, at_);
    statistics_.evaluations += 1;
  }
  dropped_.take_out(at_);
  factorized_ = taken_over_ = false;
  if (!sides_.empty()) look_for_switches();
  if (traces_) look_for_nan(false);
}

void Dynamics::factorize() {
  if (system_.row_count() > 0 && !factorized_) count_factorization([&] { formulation_->factorize(at_); });
}

/// False where `factorize` was not the last word: a solution that it found is none.
template <class Work>
bool Dynamics::count_factorization(Work factorize) {
  const Stopwatch watch(statistics_.factorize_time, clocked_);
  const double pivot = try_factorization(factorize);
  factorized_ = true;
  statistics_.factorizations += 1;
  statistics_.smallest_pivot = std::min(statistics_.smallest_pivot, std::max(pivot, 0.0));
  if (!watched_ || !watching_) return true;
  if (looking_) return look_at(pivot);
  watch_.note(t_, pivot);
  return watch_.usual(pivot) || inspect(pivot);
}

/// The smallest pivot; -1 where the matrix is singular. A state that is not finite makes it so: say which it is.
template <class Work>
double Dynamics::try_factorization(Work factorize) {
  try {
    factorize();
  } catch (const SingularSystemError&) {
    const bool pivots = std::isfinite(formulation_->saddle().smallest_pivot());
    if (!pivots || !y_.allFinite() || !at_.Phi.allFinite() || !at_.Phi_dot.allFinite())
      throw_not_finite(system_, y_, t_, stage_);
    if (!rank_needed_ || !watching_ || (!looking_ && !watch_.open() && examine_here(broken).rows.empty())) throw;
    return broken;
  }
  return formulation_->saddle().smallest_pivot();
}

PoseExamination Dynamics::examine_here(double pivot) const {
  const VectorXd q = y_.head(system_.q_size());
  return examine_pose(system_, {t_, q, history_}, dropped_.rows(), watch_.near(pivot));
}

/// A small pivot, or any inside a passage. False where the factorization is another one than before.
bool Dynamics::inspect(double pivot) {
  if (watch_.open()) {
    watch_.go_on(pivot);
  } else {
    PoseExamination found = examine_here(pivot);
    if (found.rows.empty()) {
      watch_.suspect_less();
      return true;
    }
    if (!found.better_choice.empty()) {
      watch_.change_rows(t_, pivot, std::move(found.joints));
      change_redundant_rows(std::move(found.better_choice));
      return false;
    }
    watch_.begin(t_, pivot, std::move(found.joints));
  }
  if (!rank_needed_ || !watch_.untrustworthy(pivot)) return true;
  take_over();
  watch_.take_over();
  return false;
}

void Dynamics::scale_rows(const VectorXd& mobility) {
  row_scale_ = mobility.cwiseSqrt();
  dropped_.take_from(row_scale_);
  some_.resize(row_scale_.size());
  for (Eigen::Index k = 0; k < some_.size(); ++k) some_[k] = std::cos(1.0 + 2.4 * static_cast<double>(k));
  least_singular_.resize(0);
}

// With S = D M^-1 D^T, scaled by s = diag(S)^1/2 of the start, u <- s S^-1 s u; the quotient u^T s^-1 S s^-1 u =
// lambda^T D x, where lambda = S^-1 s u and x = M^-1 D^T lambda, is not touched by penalties in the factorization. The
// last u may be without any part of a vector that has become the least one: a little of all is added.
double Dynamics::least_singular_value() {
  VectorXd& u = least_singular_;
  const bool begins = u.size() == 0;
  if (begins) u.setZero(row_scale_.size());
  u += news / std::sqrt(static_cast<double>(u.size())) * some_;
  const VectorXd none = VectorXd::Zero(system_.v_size());
  double quotient = 0.0;
  try {
    factorize();
    for (int k = 0; k < (begins ? first_iterations : more_iterations); ++k) {
      b_ = row_scale_.cwiseProduct(u);
      formulation_->saddle().solve(none, b_, x_, lambda_);
      u = row_scale_.cwiseProduct(lambda_);
      const double length = u.norm();
      u /= length;
      system_.multiply_mass(x_, v_dot_);
      quotient = x_.dot(v_dot_) / (length * length);
    }
  } catch (const SingularSystemError&) {
    quotient = 0.0;
  }
  if (u.allFinite() && std::isfinite(quotient)) return std::sqrt(std::max(quotient, 0.0));
  u.resize(0);
  return 0.0;
}

/// Takes the choice where it makes the root of the smallest pivot at least so large.
bool Dynamics::choose_rows(std::vector<int> rows, std::vector<int> joints, double least_root) {
  const std::vector<int> before = dropped_.rows();
  if (rows.empty() || rows == before) return false;
  const double pivot = formulation_->saddle().smallest_pivot();
  const auto root_with = [this](std::vector<int> choice) {
    try {
      change_redundant_rows(std::move(choice));
      return root_of_pivot();
    } catch (const SingularSystemError&) {
      return -1.0;  // either may be singular, in a singular pose
    }
  };
  if (!(root_with(std::move(rows)) >= least_root)) {
    factorized_ = root_with(before) >= 0.0;
    return false;
  }
  watch_.change_rows(t_, pivot, std::move(joints));
  return true;
}

bool Dynamics::improve_rows() {
  if (dropped_.empty()) return false;
  factorize();
  const VectorXd q = y_.head(system_.q_size());
  std::vector<int> rows = choose_redundant_rows(system_, {t_, q, history_}, dropped_.rows()), joints;
  for (const int row : dropped_.rows())
    if (!std::binary_search(rows.begin(), rows.end(), row))
      if (const int joint = system_.model().joint_of_row(row); joints.empty() || joints.back() != joint)
        joints.push_back(joint);
  if (!choose_rows(std::move(rows), std::move(joints), better * root_of_pivot())) return false;
  watch_.forget_trend();
  return true;
}

bool Dynamics::cross(const VectorXd& y, double pivot) {
  const VectorXd q = y.head(system_.q_size());
  PoseExamination found =
      examine_pose(system_, {t_, q, history_}, dropped_.rows(), watch_.near(std::max(pivot, crossed_pivot)));
  if (found.rows.empty()) return false;
  if (choose_rows(std::move(found.better_choice), found.joints, well_chosen * watch_.root_of_level())) return false;
  if (!found.singular) return false;
  watch_.cross(t_, pivot, std::move(found.joints));
  return true;
}

void Dynamics::change_redundant_rows(std::vector<int> rows) {
  dropped_.put_back(at_);
  dropped_ = DroppedRows(system_, std::move(rows));
  const ConstraintRows now{row_mobility(inertia_->system(), at_), dropped_.rows(), inertia_.get()};
  minimum_norm_ = MinimumNorm(system_, now.mobility, dropped_);
  dropped_.take_out(at_);
  scale_rows(now.mobility);
  formulation_->analyze(system_, at_, now);
  formulation_->factorize(at_);
}

void Dynamics::change_redundant_rows(std::vector<int> rows, std::vector<int> joints) {
  watch_.change_rows(t_, formulation_->saddle().smallest_pivot(), std::move(joints));
  change_redundant_rows(std::move(rows));
  factorized_ = true;
  taken_over_ = false;
}

void Dynamics::take_over() {
  if (!tolerant_) tolerant_ = std::make_unique<RankTolerant>(system_, *inertia_);
  tolerant_->factorize(at_);
  taken_over_ = true;
}

/// As `inspect`, for an observer: the watch does not hear of it.
bool Dynamics::look_at(double pivot) {
  if (!rank_needed_ || !watch_.untrustworthy(pivot)) return true;
  take_over();
  return false;
}

void Dynamics::observe(std::function<void()> look) {
  if (factorized_ || system_.row_count() == 0) return look();
  observer_ = std::move(look);
}

void Dynamics::observe_now() {
  if (observer_) std::exchange(observer_, {})();
}

void Dynamics::return_to(const Place& place) {
  looking_ = true;
  evaluate(place.t, place.y);
  if (place.factorized) factorize();
  if (place.taken_over && !taken_over_) take_over();
  looking_ = false;
}

void Dynamics::take_sides() {
  sides_.resize(static_cast<std::size_t>(at_.switches.size()), 0);
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (const double value = at_.switches[static_cast<Eigen::Index>(k)]; value != 0.0) sides_[k] = value > 0.0;
}

void Dynamics::look_for_switches() {
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (const double value = at_.switches[static_cast<Eigen::Index>(k)];
        value != 0.0 && (value > 0.0) != (sides_[k] != 0))
      switched_ = true;
}

void Dynamics::solve(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  find_solution(a, b, v_dot, lambda);
  if (observer_) observe_now();
}

void Dynamics::find_solution(const ConstVector& a, const ConstVector& b, MutableVector v_dot, MutableVector lambda) {
  statistics_.solves += 1;
  if (system_.row_count() == 0) return system_.multiply_inverse_mass(a, v_dot);
  if (!factorized_ && count_factorization([&] { formulation_->factorize_and_solve(at_, a, kept(b), v_dot, lambda); }))
    return;
  const Stopwatch watch(statistics_.solve_time, clocked_);
  active().solve(a, kept(b), v_dot, lambda);
}

ConstVector Dynamics::kept(const ConstVector& b) {
  if (dropped_.empty()) return b;
  kept_b_ = b;
  dropped_.take_from(kept_b_);
  return kept_b_;
}

void Dynamics::accelerations(MutableVector v_dot, MutableVector lambda) {
  solve(at_.g.head(system_.v_size()), at_.gamma, v_dot, lambda);
  if (!dropped_.empty()) minimum_norm_.distribute(dropped_, active(), lambda);
}

// With the residuals r_1 = g - M v_dot + D^T lambda and r_2 = gamma - D v_dot the corrections satisfy
//   M dv - D^T dlambda = r_1,   D dv = r_2,
// whatever the formulation solves of it: the penalty method's own solution, too, becomes that of (12.3).
void Dynamics::refined_accelerations(MutableVector v_dot, MutableVector lambda) {
  const int nv = system_.v_size();
  const auto g = at_.g.head(nv);
  solve(g, at_.gamma, v_dot, lambda);
  if (system_.row_count() == 0) return;
  VectorXd r_1(nv), r_2(system_.row_count()), dv(nv), dlambda(system_.row_count());
  double last = INFINITY;
  for (int k = 0; k < most_refinements; ++k) {
    system_.multiply_mass(v_dot, dv);
    r_1 = g - dv;
    system_.add_D_transposed(at_, lambda, r_1);
    system_.multiply_D(at_, v_dot, r_2);
    r_2 = at_.gamma - r_2;
    solve(r_1, r_2, dv, dlambda);
    const double change = dv.norm();
    if (!(change < 0.5 * last)) break;
    v_dot += dv;
    lambda += dlambda;
    last = change;
  }
  if (!dropped_.empty()) minimum_norm_.distribute(dropped_, active(), lambda);
}

void Dynamics::acceleration_residual(const ConstVector& v_dot, MutableVector residual) {
  dropped_.put_back(at_);
  system_.multiply_D(at_, v_dot, residual);
  residual -= at_.gamma;
  dropped_.take_out(at_);
}

Gains Dynamics::gains_or(Gains defaults) const {
  return {options_.baumgarte_alpha.value_or(defaults.alpha), options_.baumgarte_beta.value_or(defaults.beta)};
}

void Dynamics::hold_correction(Gains gains) {
  if (!sampled() || (held_ && parts_ > 0)) return;
  if (parts_ > 0) gains = {gains.alpha / parts_, gains.beta / parts_};
  gains = gains_or(gains);
  held_u_ = -2.0 * gains.alpha * at_.Phi_dot - gains.beta * gains.beta * at_.Phi;
  held_ = true;
}

void Dynamics::add_correction(double h, MutableVector y) {
  if (!sampled() || system_.row_count() == 0) return;
  const Gains gains = gains_or({0.5 / h, 1.0 / h});
  const VectorXd none = VectorXd::Zero(system_.v_size());
  b_ = -2.0 * gains.alpha * h * at_.Phi_dot;
  solve(none, b_, x_, lambda_);
  y.segment(system_.q_size(), system_.v_size()) += x_;
  b_ = -gains.beta * gains.beta * h * h * at_.Phi;
  solve(none, b_, x_, lambda_);
  VectorXd dq(system_.q_size());
  system_.position_rates(y_.head(system_.q_size()), x_, dq);
  y.head(system_.q_size()) += dq;
}

void Dynamics::rates(MutableVector y_dot) {
  b_ = at_.gamma;
  if (kind_ == StabilizationKind::baumgarte) {
    const Gains gains = gains_or(textbook_gains);
    b_ -= 2.0 * gains.alpha * at_.Phi_dot + gains.beta * gains.beta * at_.Phi;
  } else if (held_) {
    b_ += held_u_;
  }
  solve(at_.g.head(system_.v_size()), b_, v_dot_, lambda_);
  if (traces_) look_for_nan(true);
  rates(v_dot_, lambda_, y_dot);
}

// The power of the constraints is v^T D^T lambda = lambda . (Phi_dot - Phi_t): -lambda . Phi_t for driven ones.
void Dynamics::rates(const ConstVector& v_dot, const ConstVector& lambda, MutableVector y_dot) const {
  const int nq = system_.q_size(), nv = system_.v_size();
  system_.position_rates(y_.head(nq), y_.segment(nq, nv), y_dot.head(nq));
  y_dot.segment(nq, nv) = v_dot;
  y_dot[nq + nv] = at_.power - (system_.time_dependent_constraints() ? lambda.dot(at_.Phi_t) : 0.0);
}

void Dynamics::look_for_nan(bool accelerations) const {
  bool finite = y_.allFinite() && at_.g.allFinite() && at_.Phi.allFinite() && at_.Phi_dot.allFinite() &&
                at_.gamma.allFinite() && std::isfinite(at_.power);
  if (accelerations) finite = finite && v_dot_.allFinite() && lambda_.allFinite();
  if (!finite) throw_not_finite(system_, y_, t_, stage_);
}

namespace {

/// The first joint with an equation that is not finite, or -1.
int joint_not_finite(const System& system, const Evaluation& at) {
  for (int row = 0; row < system.row_count(); ++row)
    if (!std::isfinite(at.Phi[row]) || !std::isfinite(at.Phi_dot[row]) || !std::isfinite(at.gamma[row]))
      return system.model().joint_of_row(row);
  return -1;
}

/// The bodies of one force element and nothing else, as a model with that force; their numbers in the whole.
Model alone(const Model& model, const Element& force, std::vector<int>& bodies) {
  Model out(Vec3<double>::Zero());
  const auto place = [&](int body) {
    if (body == ground) return ground;
    const auto found = std::find(bodies.begin(), bodies.end(), body);
    if (found != bodies.end()) return static_cast<int>(found - bodies.begin());
    bodies.push_back(body);
    return out.add_body(model.body_name(body), model.bodies()[static_cast<std::size_t>(body)]);
  };
  const int i = place(force.i), j = place(force.j);
  for (const TimeFunctionPtr& signal : model.signals()) out.add_signal(signal);
  const KindInfo& info = force_kinds()[static_cast<std::size_t>(force.kind)].info;
  const auto first = model.force_parameters().begin() + static_cast<std::ptrdiff_t>(force.first_parameter);
  out.add_force(info.name, "force", i, j, force.at,
                {first, first + static_cast<std::ptrdiff_t>(info.parameters.size())});
  return out;
}

/// The first of the user's own forces that is not finite, or -1.
int user_force_not_finite(const System& system, double t, const VectorXd& y) {
  const auto& forces = system.model().user_forces();
  for (std::size_t k = 0; k < forces.size(); ++k) {
    VectorXd g = VectorXd::Zero(system.v_size());
    forces[k]->add(t, system.body_count(), y.data(), y.data() + system.q_size(), g.data());
    if (!g.allFinite()) return static_cast<int>(k);
  }
  return -1;
}

/// The first of the user's own laws along coordinates that is not finite, or -1.
int joint_force_not_finite(const System& system, double t, const VectorXd& y) {
  const auto q = y.head(system.q_size()), v = y.segment(system.q_size(), system.v_size());
  for (std::size_t k = 0; k < system.model().joint_forces().size(); ++k) {
    HistoryVariable<double> variable;
    if (!std::isfinite(system.joint_force(k, t, q, v, variable).power)) return static_cast<int>(k);
  }
  return -1;
}

/// The first force element that gives something not finite, or -1.
int force_not_finite(const System& system, double t, const VectorXd& y) {
  for (std::size_t k = 0; k < system.model().forces().size(); ++k) {
    std::vector<int> bodies;
    const System one(alone(system.model(), system.model().forces()[k], bodies));
    VectorXd q(one.q_size()), v(one.v_size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      const auto place = static_cast<Eigen::Index>(b);
      q.segment<7>(7 * place) = y.segment<7>(7 * bodies[b]);
      v.segment<6>(6 * place) = y.segment<6>(system.q_size() + 6 * bodies[b]);
    }
    Evaluation at = one.make_evaluation();
    one.evaluate(t, q, v, one.initial_history(), at);
    if (!at.g.head(one.v_size()).allFinite() || !std::isfinite(at.power)) return static_cast<int>(k);
  }
  return -1;
}

}  // namespace

void throw_not_finite(const System& system, const VectorXd& y, double t, int stage) {
  const Model& model = system.model();
  ErrorDetails details;
  details.time = t;
  details.stage = stage;
  for (int body = 0; body < system.body_count() && details.bodies.empty(); ++body)
    if (!y.segment<7>(7 * body).allFinite() || !y.segment<6>(system.q_size() + 6 * body).allFinite())
      details.bodies = {model.body_name(body)};
  const std::string when = stage > 1 ? " in stage " + std::to_string(stage) + " of a step" : "";
  Eigen::Index fastest = 0;
  const double speed = y.segment(system.q_size(), system.v_size()).cwiseAbs().maxCoeff(&fastest);
  if (details.bodies.empty() && speed < diverged) {
    Evaluation at = system.make_evaluation();
    system.evaluate(t, y.head(system.q_size()), y.segment(system.q_size(), system.v_size()), system.initial_history(),
                    at);
    if (const int joint = joint_not_finite(system, at); joint >= 0) {
      details.joints = {model.joint_name(joint)};
      throw NotFiniteError("not_finite",
                           "joint '" + details.joints.front() + "': its equations became infinite or undefined" + when +
                               "; see what drives it, or use a smaller step",
                           details);
    }
    int force = force_not_finite(system, t, y);
    if (force >= 0) details.forces = {model.force_names().name(force)};
    else if (force = user_force_not_finite(system, t, y); force >= 0)
      details.forces = {model.user_force_name(static_cast<std::size_t>(force))};
    else if (force = joint_force_not_finite(system, t, y); force >= 0)
      details.forces = {model.joint_forces()[static_cast<std::size_t>(force)].name};
    if (force >= 0) {
      throw NotFiniteError("not_finite",
                           "force '" + details.forces.front() + "' became infinite or undefined" + when +
                               "; see its parameters and its functions of time, or use a smaller step",
                           details);
    }
  }
  if (details.bodies.empty()) details.bodies = {model.body_name(static_cast<int>(fastest / velocity_size))};
  throw NotFiniteError("not_finite",
                       "body '" + details.bodies.front() + "' became infinite or undefined" + when +
                           ": the run diverged; use a smaller step, or see whether the mechanism locks in this pose",
                       details);
}

}  // namespace linkwork
