#include "linkwork/linear/block/block_solver.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/linear/block/symbolic_factorization.hpp"
#include "linkwork/math/aligned.hpp"
#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"

namespace linkwork::block {
namespace {

constexpr double singular_pivot = 1e-15;
constexpr double small_pivot = 1e-8;  // beyond it the pivot of a joint is delayed to a hub, if there is one
constexpr double far_apart = 1e6, refined_enough = 1e-13;
constexpr int most_refinements = 5;
constexpr std::size_t cached = 1 << 16;   // doubles, half of a cache of 1 MB: the rest is for D
constexpr std::size_t slack = 2 * lanes;  // vectors may reach past the last column

class BlockSolver final : public SaddleSolver {
 public:
  explicit BlockSolver(const InstructionSet& instructions) : kernels_(&kernels(instructions)) {}

  void analyze(const System& system, const Evaluation&) override {
    system_ = &system;
    refuse_massless();
    e_.resize(0);
    delayed_.clear();
    delays_ = 0;
    factorize_symbolically();
    no_a_.resize(0);
    refined_ = masses_far_apart(system);
    if (!refined_) return;
    for (VectorXd* velocities : {&rest_a_, &change_x_}) velocities->setZero(system.v_size());
    for (VectorXd* rows : {&rest_b_, &change_lambda_}) rows->setZero(system.row_count());
  }

  void factorize(const Evaluation& at, const VectorXd& e) override {
    if (no_a_.size() == 0) {
      no_a_.setZero(system_->v_size());
      no_b_.setZero(system_->row_count());
    }
    factorize(at, e, no_a_, no_b_);
  }

  void solve(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) override {
    kernels_->forward(data_, a.data(), b.data());
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
    archive(delayed_, delays_);
    if (archive.reading() && !delayed_.empty()) factorize_symbolically();
  }

  std::int64_t factor_nonzeros() const override { return symbolic_->nonzeros; }
  std::optional<double> flops() const override { return symbolic_->flops; }
  std::optional<std::int64_t> factor_bytes() const override {
    const auto bytes = [](const auto&... vectors) { return (... + (vectors.size() * sizeof(vectors[0]))); };
    const SymbolicFactorization& s = *symbolic_;
    return static_cast<std::int64_t>(bytes(factors_, articulated_inertias_, panels_, contributions_, scratch_, pivots_,
                                           mass_factors_, s.steps, s.fronts, s.relative_indices, s.bodies, s.vectors,
                                           s.runs, s.rows, s.mixed, s.hubs, s.couplings, s.unknowns));
  }

 private:
  /// Light bodies between heavy ones cost digits, which the residual brings back.
  static bool masses_far_apart(const System& system) {
    double least[2] = {INFINITY, INFINITY}, most[2] = {0.0, 0.0};
    for (int body = 0; body < system.body_count(); ++body) {
      const double size[2] = {system.mass(body), system.inertia(body).diagonal().maxCoeff()};
      for (int k = 0; k < 2; ++k) {
        least[k] = std::min(least[k], size[k]);
        most[k] = std::max(most[k], size[k]);
      }
    }
    return most[0] > far_apart * least[0] || most[1] > far_apart * least[1];
  }

  void refine(const ConstVector& a, const ConstVector& b, MutableVector x, MutableVector lambda) {
    for (int step = 0; step < most_refinements; ++step) {
      system_->multiply_mass(x, change_x_);
      rest_a_ = a - change_x_;
      system_->add_D_transposed(*at_, lambda, rest_a_);
      system_->multiply_D(*at_, x, change_lambda_);
      rest_b_ = b - change_lambda_ - e_.cwiseProduct(lambda);
      kernels_->forward(data_, rest_a_.data(), rest_b_.data());
      substitute_backward(rest_a_, change_x_, change_lambda_);
      x += change_x_;
      lambda += change_lambda_;
      if (!(change_x_.cwiseAbs().maxCoeff() > refined_enough * x.cwiseAbs().maxCoeff())) return;
    }
  }

  void substitute_backward(const ConstVector& a, MutableVector x, MutableVector lambda) const {
    for (const int row : dropped_) lambda[row] = 0.0;
    kernels_->backward(data_, a.data(), x.data(), lambda.data());
  }

  void refuse_massless() const {
    if (system_->massless_bodies().empty()) return;
    const std::string name = system_->model().body_name(system_->massless_bodies().front());
    ErrorDetails details;
    details.bodies = {name};
    throw OptionError("massless_body",
                      "body '" + name +
                          "' has no mass or a singular inertia: linear solver 'block' needs a regular mass "
                          "matrix; use linear solver 'cholmod'",
                      details);
  }

  void factorize_symbolically() {
    symbolic_ = std::make_unique<SymbolicFactorization>(*system_, dropped_, delayed_);
    look_for_interruption();
    factors_.assign(symbolic_->factor_size + slack, 0.0);
    articulated_inertias_.assign(
        static_cast<std::size_t>(symbolic_->articulated_inertia_count * articulated_inertia_size) + slack, 0.0);
    look_for_interruption();
    panels_.assign(symbolic_->panel_size + slack, 0.0);
    contributions_.assign(symbolic_->contribution_size + slack, 0.0);
    look_for_interruption();
    scratch_.assign(scratch_columns * symbolic_->highest_front, 0.0);
    pivots_.assign(symbolic_->widest_front + slack, 0.0);
    factorize_masses();
  }

  void factorize_masses() {
    mass_factors_.resize(symbolic_->mass_factor_count);
    for (const CoreBody& body : symbolic_->bodies) {
      if (body.mass_factor < 0) continue;
      const auto J = system_->inertia(body.body);
      const double L43 = J(1, 0) / J(0, 0), L53 = J(2, 0) / J(0, 0), d4 = J(1, 1) - L43 * J(1, 0);
      const double L54 = (J(2, 1) - L53 * J(1, 0)) / d4, d5 = J(2, 2) - L53 * J(2, 0) - L54 * L54 * d4;
      const double m = 1.0 / system_->mass(body.body);
      mass_factors_[body.mass_factor] = {
          L43, L53, L54, {m, m, m, 1.0 / J(0, 0), 1.0 / d4, 1.0 / d5}, L43 == 0.0 && L53 == 0.0 && L54 == 0.0};
    }
  }

  /// With hubs: a joint that depends on others while the hubs after it are held is eliminated after
  /// the next of them. Holding a hub can make six rows dependent, not more. False: nothing to be done.
  bool delay_pivot(int row) {
    if (row < 0 || delays_ == 6 * symbolic_->hubs.size()) return false;
    const int hub = symbolic_->next_hub(row);
    if (hub < 0) return false;
    delays_ += 1;
    const int joint = system_->model().joint_of_row(row);
    const auto found = std::find_if(delayed_.begin(), delayed_.end(), [&](auto& it) { return it.joint == joint; });
    if (found == delayed_.end()) delayed_.push_back({joint, hub});
    else found->hub = hub;
    factorize_symbolically();
    return true;
  }

  void factorize(const Evaluation& at, const VectorXd& e, const ConstVector& a, const ConstVector& b) {
    if (e_.size() != e.size() || e_ != e) {
      e_ = e;
      compliant_ = compliant();
    }
    at_ = &at;
    meter_.add(system_->body_count());
    collect_data(at);
    const SmallestPivot smallest = kernels_->factor(data_, a.data(), b.data());
    smallest_pivot_ = {smallest.ratio, smallest.row};
    if (smallest.ratio < data_.breakdown && std::isfinite(smallest.ratio) && delay_pivot(smallest.row))
      return factorize(at, e, a, b);
    if (!(smallest_pivot_.ratio > singular_pivot))
      detail::throw_singular(*system_, "block", smallest_pivot_, smallest_pivot_.row);
  }

  void collect_data(const Evaluation& at) {
    const SymbolicFactorization& s = *symbolic_;
    data_ = {.steps = s.steps.data(),
             .step_count = std::ssize(s.steps),
             .fronts = s.fronts.data(),
             .front_count = std::ssize(s.fronts),
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
             .D = at.D.data(),
             .e = e_.data(),
             .compliant = compliant_,
             .factors = factors_.data(),
             .articulated_inertias = articulated_inertias_.data(),
             .panels = panels_.data(),
             .contributions = contributions_.data(),
             .scratch = scratch_.data(),
             .pivots = pivots_.data(),
             .large = factors_.size() + panels_.size() > cached,
             .breakdown = s.hubs.empty() ? singular_pivot : small_pivot};
  }

  /// Whether rows that are not dropped have a compliance.
  bool compliant() const {
    const auto nonzero = [&](int row) { return e_[row] != 0.0; };
    return (e_.array() != 0.0).count() > std::count_if(dropped_.begin(), dropped_.end(), nonzero);
  }

  const System* system_ = nullptr;
  const Evaluation* at_ = nullptr;
  const Kernels* kernels_;
  std::unique_ptr<SymbolicFactorization> symbolic_;
  std::vector<SymbolicFactorization::DelayedPivot> delayed_;
  std::size_t delays_ = 0;
  AlignedDoubles factors_, articulated_inertias_, panels_, contributions_, scratch_, pivots_;
  std::vector<MassFactor> mass_factors_;
  VectorXd e_, no_a_, no_b_;
  bool refined_ = false, compliant_ = false;
  VectorXd rest_a_, rest_b_, change_x_, change_lambda_;
  Data data_{};
  InterruptionMeter meter_;
};

}  // namespace

std::unique_ptr<SaddleSolver> make_block_solver(const InstructionSet& instructions) {
  return std::make_unique<BlockSolver>(instructions);
}

}  // namespace linkwork::block
