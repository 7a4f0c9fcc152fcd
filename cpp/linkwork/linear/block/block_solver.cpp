#include "linkwork/linear/block/block_solver.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "linkwork/assembly/mass_ratios.hpp"
#include "linkwork/linear/block/ballast.hpp"
#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/linear/block/symbolic_factorization.hpp"
#include "linkwork/math/aligned.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

constexpr double singular_pivot = 1e-15;
constexpr double far_apart = 1e6, far_above = 1e4;  // masses; inertances, row by row
constexpr std::size_t cached = 1 << 16;             // doubles, half of a cache of 1 MB: the rest is for D
constexpr std::size_t uncached = 1 << 21;           // doubles, 16 MB: the rest is for D
constexpr std::size_t slack = 2 * lanes;            // vectors may reach past the last column

class BlockSolver final : public SaddleSolver {
 public:
  explicit BlockSolver(const InstructionSet& instructions) : kernels_(&kernels(instructions)) {}

  void analyze(const System& system, const Evaluation&) override {
    refuse_massless(system);
    begin(system, false);
  }

  bool analyze_as_it_is(const System& system, const Evaluation&, const std::vector<int>& light) override {
    begin(system, true);
    std::vector<char> in_branches(static_cast<std::size_t>(system.body_count()), 0);
    for (const TreeStep& step : symbolic_->steps) in_branches[step.body] = 1;
    return std::all_of(light.begin(), light.end(), [&](int body) { return in_branches[body] != 0; });
  }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    if (no_a_.size() == 0) {
      no_a_.setZero(system_->v_size());
      no_b_.setZero(system_->row_count());
    }
    factorize(at, e, no_a_, no_b_);
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    substitute_forward(a, b);
    substitute_backward(a, x, lambda);
    if (refined_) refine(a, b, x, lambda);
  }

  void factorize_and_solve(const Evaluation& at, const VectorXd& e, const ConstVector& a, const ConstVector& b,
                           MutableVector x, MutableVector lambda) override {
    factorize(at, e, a, b);
    substitute_backward(a, x, lambda);
    if (refined_) refine(a, b, x, lambda);
  }

  /// The order of elimination, which a small pivot has changed for good.
  void keep(Archive& archive) override {
    archive(delayed_, delays_, grounded_);
    if (archive.reading() && reordered()) factorize_symbolically();
  }

  bool reordered() const override { return delays_ > 0 || !grounded_; }
  bool shares_work() const override { return symbolic_->step_plan.shared || symbolic_->front_plan.shared; }
  std::int64_t factor_nonzeros() const override { return symbolic_->nonzeros; }
  std::optional<double> flops() const override { return symbolic_->flops; }
  std::optional<std::int64_t> factor_bytes() const override {
    const auto bytes = [](const auto&... vectors) { return (... + (vectors.size() * sizeof(vectors[0]))); };
    const SymbolicFactorization& s = *symbolic_;
    return static_cast<std::int64_t>(bytes(factors_, articulated_inertias_, panels_, contributions_, scratch_, pivots_,
                                           mass_factors_, s.steps, s.step_rows, s.fronts, s.relative_indices, s.bodies,
                                           s.vectors, s.runs, s.rows, s.mixed, s.hubs, s.couplings, s.unknowns));
  }

 private:
  void begin(const System& system, bool with_ballast) {
    system_ = &system;
    with_ballast_ = with_ballast;
    e_.resize(0);
    delayed_.clear();
    delays_ = 0;
    grounded_ = true;
    split_ = system.threads().threads() > 1;
    factorize_symbolically();
    no_a_.resize(0);
    far_apart_ = refined_ = masses_far_apart(system);
    if (!refined_ && !(inertance_ > far_above)) return;
    for (VectorXd* velocities : {&rest_a_, &change_x_}) velocities->setZero(system.v_size());
    for (VectorXd* rows : {&rest_b_, &change_lambda_}) rows->setZero(system.row_count());
  }

  /// All of them in this factorization: then nothing is a difference, however large they are; see turning_kernels.hpp.
  bool has_inerters_along_freedoms() const {
    const auto along = [&](const TreeStep& step) {
      return step.rows == 6 && step.scattered >= 0 && factors_[step.storage + sign_place(6)] != 0.0;
    };
    return std::count_if(symbolic_->steps.begin(), symbolic_->steps.end(), along) ==
           system_->row_count() - compliant_from_;
  }

  void refine(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) {
    for (int step = 0; step < most_refinements; ++step) {
      system_->multiply_mass(*at_, x, change_x_);
      rest_a_ = a - change_x_;
      system_->add_D_transposed(*at_, lambda, rest_a_);
      system_->multiply_D(*at_, x, change_lambda_);
      rest_b_ = b - change_lambda_;
      if (e_.size() > 0) rest_b_ -= e_.cwiseProduct(lambda);
      substitute_forward(rest_a_, rest_b_);
      substitute_backward(rest_a_, change_x_, change_lambda_);
      x += change_x_;
      lambda += change_lambda_;
      if (!goes_on_refining(x.cwiseAbs().maxCoeff(), change_x_.cwiseAbs().maxCoeff())) return;
    }
  }

  void substitute_forward(const ConstVector& a, const ConstVector& b) {
    run(symbolic_->step_plan, [&](const Data& data, const Task& task) {
      return kernels_->factor_branches(data, task.ranges.data(), count(task), a.data(), b.data());
    });
    run(symbolic_->front_plan, [&](const Data& data, const Task& task) {
      kernels_->forward_core(data, task.ranges.data(), count(task), a.data(), b.data());
      return SmallestPivot();
    });
  }

  void substitute_backward(const ConstVector& a, MutableVector x, MutableVector lambda) {
    for (const int row : dropped_) lambda[row] = 0.0;
    run_back(symbolic_->front_plan, [&](const Data& data, const Task& task) {
      kernels_->backward_core(data, task.ranges.data(), count(task), a.data(), x.data(), lambda.data());
    });
    run_back(symbolic_->step_plan, [&](const Data& data, const Task& task) {
      kernels_->backward_branches(data, task.ranges.data(), count(task), x.data(), lambda.data());
    });
  }

  static int count(const Task& task) { return static_cast<int>(task.ranges.size()); }

  /// The sweep of each task; the smallest pivot of all, as if the stages were done one after the other.
  template <class Sweep>
  SmallestPivot run(const WorkPlan& plan, const Sweep& sweep) {
    if (plan.is_empty()) return {};
    if (plan.is_one_task()) return sweep(data_, plan.stages[0][0]);
    SmallestPivot smallest;
    for (const Stage& stage : plan.stages) {
      found_.assign(stage.size(), {});
      run_stage(stage, [&](const Data& data, std::size_t task) { found_[task] = sweep(data, stage[task]); });
      for (const SmallestPivot& found : found_)
        if (found.ratio < smallest.ratio && !(smallest.ratio < data_.breakdown)) smallest = found;
    }
    return smallest;
  }

  template <class Sweep>
  void run_back(const WorkPlan& plan, const Sweep& sweep) {
    if (plan.is_empty()) return;
    if (plan.is_one_task()) return sweep(data_, plan.stages[0][0]);
    for (auto stage = plan.stages.rbegin(); stage != plan.stages.rend(); ++stage)
      run_stage(*stage, [&](const Data& data, std::size_t task) { sweep(data, (*stage)[task]); });
  }

  /// Tasks at the same time; where there are few, one after the other, and all threads at each large front.
  template <class Sweep>
  void run_stage(const Stage& stage, const Sweep& sweep) {
    ThreadPool& threads = system_->threads();
    if (stage.size() == 1 || (2 * static_cast<int>(stage.size()) <= threads.threads() && is_divisible(stage))) {
      for (std::size_t task = 0; task < stage.size(); ++task) sweep(data_, task);
      return;
    }
    threads.run(static_cast<int>(stage.size()),
                [&](int task, int worker) { sweep(data_for(worker), static_cast<std::size_t>(task)); });
  }

  static bool is_divisible(const Stage& stage) {
    double work = 0.0, divisible = 0.0;
    for (const Task& task : stage) {
      work += task.work;
      divisible += task.divisible;
    }
    return divisible > 0.5 * work;
  }

  static void help(void* pool, int count, void (*part)(const void*, int, int), const void* context) {
    static_cast<ThreadPool*>(pool)->run(count, [&](int k, int worker) { part(context, k, worker); });
  }

  /// With scratch memory that is the worker's own, and without helpers.
  Data data_for(int worker) const {
    Data data = data_;
    data.helpers = {};
    data.scratch = scratch_places_[worker];
    data.pivots = pivots_places_[worker];
    return data;
  }

  void place_scratch() {
    const auto threads = static_cast<std::size_t>(system_->threads().threads());
    const auto spread = [&](AlignedDoubles& memory, std::size_t size, std::vector<double*>& places) {
      size = (size + slack + lanes - 1) / lanes * lanes;
      memory.assign(threads * size, 0.0);
      places.clear();
      for (std::size_t worker = 0; worker < threads; ++worker) places.push_back(memory.data() + worker * size);
    };
    spread(scratch_, static_cast<std::size_t>(scratch_columns) * symbolic_->highest_front, scratch_places_);
    spread(pivots_, symbolic_->widest_front, pivots_places_);
    std::size_t most = 1;
    for (const WorkPlan* plan : {&symbolic_->step_plan, &symbolic_->front_plan})
      for (const Stage& stage : plan->stages) most = std::max(most, stage.size());
    found_.reserve(most);
  }

  static void refuse_massless(const System& system) {
    if (system.massless_bodies().empty()) return;
    const std::string name = system.model().body_name(system.massless_bodies().front());
    ErrorDetails details;
    details.bodies = {name};
    throw OptionError("massless_body",
                      "body '" + name +
                          "' has no mass or a singular inertia: linear solver 'block' needs a regular mass "
                          "matrix; use linear solver 'cholmod'",
                      details);
  }

  void factorize_symbolically() {
    if (delayed_.empty() && !split_)
      symbolic_ = kept_orders(*system_).analysis(*system_, dropped_, compliant_from_, grounded_);
    else
      symbolic_ =
          std::make_shared<SymbolicFactorization>(*system_, dropped_, compliant_from_, delayed_, split_, grounded_);
    look_for_interruption();
    factors_.assign(symbolic_->factor_size + slack, 0.0);
    articulated_inertias_.assign(
        static_cast<std::size_t>(symbolic_->articulated_inertia_count * articulated_inertia_size) + slack, 0.0);
    look_for_interruption();
    panels_.assign(symbolic_->panel_size + slack, 0.0);
    contributions_.assign(symbolic_->contribution_size + slack, 0.0);
    look_for_interruption();
    place_scratch();
    factorize_masses();
    if (with_ballast_) ballast_ = ballasts(system_->model(), symbolic_->steps, compliant_from_);
    else ballast_.clear();
    collect_data();
  }

  void factorize_masses() {
    mass_factors_.resize(symbolic_->mass_factor_count);
    for (const CoreBody& body : symbolic_->bodies)
      if (body.mass_factor >= 0) mass_factors_[body.mass_factor] = mass_factor(*system_, body.body);
  }

  /// With hubs: a joint that depends on others while the hubs after it are held is eliminated after
  /// the next of them. Holding a hub can make six rows dependent, not more. False: nothing to be done.
  bool delay_pivot(int row) {
    if (row < 0 || delays_ == 6 * symbolic_->hubs.size()) return false;
    const int hub = symbolic_->next_hub(row);
    if (hub < 0) return false;
    delays_ += 1;
    const int joint = system_->model().joint_of_row(row);
    std::erase_if(delayed_, [&](const auto& it) { return it.joint == joint; });
    delayed_.push_back({joint, hub});
    factorize_symbolically();
    return true;
  }

  /// From here on no body is eliminated with its joint on the ground, if this row is one's: it is violated by far, or
  /// yields. False: nothing to be done.
  bool let_go(int row) {
    if (!symbolic_->grounded_by(row)) return false;
    grounded_ = false;
    factorize_symbolically();
    return true;
  }

  /// Which of several breakdowns comes first depends on the tasks: it is that of several threads for one, too. False:
  /// it was so.
  bool split() {
    if (split_ || !shares_work()) return false;
    split_ = true;
    factorize_symbolically();
    return true;
  }

  void factorize(const Evaluation& at, const VectorXd& e, const ConstVector& a, const ConstVector& b) {
    take_compliance(e);
    at_ = &at;
    data_.D = at.D.data();
    meter_.add(system_->body_count());
    const SmallestPivot smallest = sweep(a, b);
    smallest_pivot_ = {smallest.ratio, smallest.row};
    const auto reorder = [&] { return let_go(smallest.row) || delay_pivot(smallest.row); };
    if (smallest.ratio < data_.breakdown && (split() || (std::isfinite(smallest.ratio) && reorder())))
      return factorize(at, e, a, b);
    if (inertance_ > far_above) refined_ = far_apart_ || !has_inerters_along_freedoms();
    if (!(smallest_pivot_.ratio > singular_pivot))
      detail::throw_singular(*system_, "block", smallest_pivot_, smallest_pivot_.row, e);
  }

  /// A copy, which later substitutions read; none of zeros, as they are where constraints do not yield.
  void take_compliance(const VectorXd& e) {
    const bool kept = e_.size() == e.size();
    if (kept && (e.size() == 0 || std::memcmp(e_.data(), e.data(), sizeof(double) * e.size()) == 0)) return;
    if ((e.array() != 0.0).any()) e_ = e;
    else e_.resize(0);
    data_.e = e_.size() > 0 ? e_.data() : nullptr;
    data_.compliant = compliant();
    if (e_.size() == 0) return;
    const auto yields = [&](const CoreBody& it) {
      return it.grounded() && (e_.segment(it.ground_row, ground_rows).array() != 0.0).any();
    };
    const auto found = std::find_if(symbolic_->bodies.begin(), symbolic_->bodies.end(), yields);
    if (found != symbolic_->bodies.end()) let_go(found->ground_row);
  }

  SmallestPivot sweep(const ConstVector& a, const ConstVector& b) {
    const SmallestPivot smallest = run(symbolic_->step_plan, [&](const Data& data, const Task& task) {
      return kernels_->factor_branches(data, task.ranges.data(), count(task), a.data(), b.data());
    });
    const SmallestPivot found = run(symbolic_->front_plan, [&](const Data& data, const Task& task) {
      return kernels_->factor_core(data, task.ranges.data(), count(task), a.data(), b.data());
    });
    return found.ratio < smallest.ratio && !(smallest.ratio < data_.breakdown) ? found : smallest;
  }

  void collect_data() {
    const SymbolicFactorization& s = *symbolic_;
    data_ = {.steps = s.steps.data(),
             .step_rows = s.step_rows.data(),
             .fronts = s.fronts.data(),
             .relative_indices = s.relative_indices.data(),
             .bodies = s.bodies.data(),
             .vectors = s.vectors.data(),
             .runs = s.runs.data(),
             .rows = s.rows.data(),
             .mixed = s.mixed.data(),
             .hubs = s.hubs.data(),
             .couplings = s.couplings.data(),
             .unknowns = s.unknowns.data(),
             .mass = system_->mass_blocks().data(),
             .mass_factors = mass_factors_.data(),
             .ballast = with_ballast_ ? ballast_.data() : nullptr,
             .D = data_.D,
             .e = e_.size() > 0 ? e_.data() : nullptr,
             .compliant = data_.compliant,
             .factors = factors_.data(),
             .articulated_inertias = articulated_inertias_.data(),
             .panels = panels_.data(),
             .contributions = contributions_.data(),
             .scratch = scratch_.data(),
             .pivots = pivots_.data(),
             .large = factors_.size() + panels_.size() > cached,
             .streamed = factors_.size() > uncached,
             .breakdown = s.breakdown(),
             .helpers = {}};
    if (split_) data_.helpers = {.pool = &system_->threads(), .run = &help, .scratch = scratch_places_.data()};
  }

  /// Whether rows that are not dropped have a compliance.
  bool compliant() const {
    if (e_.size() == 0) return false;
    const auto nonzero = [&](int row) { return e_[row] != 0.0; };
    return (e_.array() != 0.0).count() > std::count_if(dropped_.begin(), dropped_.end(), nonzero);
  }

  const System* system_ = nullptr;
  const Evaluation* at_ = nullptr;
  const Kernels* kernels_;
  std::shared_ptr<const SymbolicFactorization> symbolic_;
  std::vector<SymbolicFactorization::DelayedPivot> delayed_;
  std::size_t delays_ = 0;
  AlignedDoubles factors_, articulated_inertias_, panels_, contributions_, scratch_, pivots_;
  std::vector<double*> scratch_places_, pivots_places_;  ///< of each thread
  std::vector<SmallestPivot> found_;                     ///< by the tasks of a stage
  std::vector<MassFactor> mass_factors_;
  std::vector<Ballast> ballast_;
  VectorXd e_, no_a_, no_b_;
  bool refined_ = false, far_apart_ = false, split_ = false, with_ballast_ = false;
  bool grounded_ = true;  ///< see SymbolicFactorization
  VectorXd rest_a_, rest_b_, change_x_, change_lambda_;
  Data data_{};
  InterruptionMeter meter_;
};

}  // namespace

bool masses_far_apart(const System& system) {
  const MassRatios ratios(system);
  return ratios.mass > far_apart || ratios.moment > far_apart || ratios.inertance > far_above;
}

MassFactor mass_factor(const System& system, int body) {
  const auto J = system.inertia(body);
  const double L43 = J(1, 0) / J(0, 0), L53 = J(2, 0) / J(0, 0), d4 = J(1, 1) - L43 * J(1, 0);
  const double L54 = (J(2, 1) - L53 * J(1, 0)) / d4, d5 = J(2, 2) - L53 * J(2, 0) - L54 * L54 * d4;
  const double m = 1.0 / system.mass(body);
  return {L43, L53, L54, {m, m, m, 1.0 / J(0, 0), 1.0 / d4, 1.0 / d5}, L43 == 0.0 && L53 == 0.0 && L54 == 0.0};
}

std::unique_ptr<SaddleSolver> make_block_solver(const InstructionSet& instructions) {
  return std::make_unique<BlockSolver>(instructions);
}

}  // namespace linkwork::block
