#include "linkwork/ensemble/lane_solver.hpp"

#include <algorithm>

#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/formulation/watched_formulation.hpp"
#include "linkwork/linear/block/ballast.hpp"
#include "linkwork/linear/block/block_solver.hpp"

namespace linkwork {

LaneSolver::LaneSolver(const LaneStructure& structure, const InstructionSet& instructions)
    : structure_(structure),
      kernels_(lane_kernels(instructions)),
      elimination_(lane_elimination(instructions)),
      far_apart_(kernels_.width, 0) {
  if (!factorizes()) {
    size(inverse_mass_, 10l * structure_.bodies);
    return;
  }
  const block::SymbolicFactorization& symbolic = structure_.symbolic;
  size(mass_, 10l * structure_.bodies);
  size(mass_factors_, 9l * symbolic.mass_factor_count);
  size(ballast_, structure_.with_ballast ? 4l * structure_.bodies : 0);
  size(compliance_, structure_.multipliers());
  for (const int row : structure_.dropped)
    std::fill_n(compliance_.begin() + std::ptrdiff_t{row} * kernels_.width, kernels_.width, 1.0);
  size(factors_, symbolic.factor_size);
  size(articulated_inertias_, block::articulated_inertia_size * symbolic.articulated_inertia_count);
  size(panels_, symbolic.panel_size);
  size(contributions_, symbolic.contribution_size);
  int most_rows = 0;
  for (const block::CoreBody& body : symbolic.bodies) most_rows = std::max(most_rows, body.rows);
  size(scratch_, std::max(12 * most_rows, 8 * symbolic.highest_front + symbolic.widest_front));
  for (AlignedDoubles* one : {&smallest_, &going_on_, &largest_, &correction_}) size(*one, 1);
}

void LaneSolver::size(AlignedDoubles& numbers, std::ptrdiff_t count) const {
  numbers.assign(count * kernels_.width, 0.0);
}

void LaneSolver::load(int l, const Dynamics& mechanism) {
  if (!factorizes()) return load_inverse_mass(l, mechanism.system());
  const System& system = mechanism.formulation().factorized_system();
  const auto give = [&](const double* from, std::ptrdiff_t count, AlignedDoubles& to, std::ptrdiff_t first) {
    for (std::ptrdiff_t k = 0; k < count; ++k) to[(first + k) * kernels_.width + l] = from[k];
  };
  for (int body = 0; body < structure_.bodies; ++body) give(&system.mass_blocks()[body].m, 10, mass_, 10l * body);
  for (const block::CoreBody& body : structure_.symbolic.bodies) {
    if (body.mass_factor < 0) continue;
    const block::MassFactor factor = block::mass_factor(system, body.body);
    give(&factor.L43, 9, mass_factors_, 9l * body.mass_factor);
  }
  for (int k = 0; k < structure_.inerters; ++k) {
    const double yields = 1.0 / system.inerters().inertance(static_cast<std::size_t>(k));
    give(&yields, 1, compliance_, structure_.rows + k);
  }
  if (structure_.with_ballast) {
    const std::vector<block::Ballast> ballasts =
        block::ballasts(system.model(), structure_.symbolic.steps, structure_.rows);
    for (int body = 0; body < structure_.bodies; ++body) give(&ballasts[body].inverse_mass, 4, ballast_, 4l * body);
  }
  far_apart_[l] = block::masses_far_apart(system);
  if (!far_apart_[l] || !r_1_.empty()) return;
  for (AlignedDoubles* velocities : {&r_1_, &dx_}) size(*velocities, velocity_size * structure_.bodies);
  for (AlignedDoubles* rows : {&r_2_, &dlambda_}) size(*rows, structure_.multipliers());
}

void LaneSolver::load_inverse_mass(int l, const System& system) {
  for (int body = 0; body < structure_.bodies; ++body) {
    double* to = inverse_mass_.data() + 10l * body * kernels_.width + l;
    const Mat3<double> inverse = system.inverse_inertia(body);
    to[0] = system.inverse_mass(body);
    for (int k = 0; k < 9; ++k) to[(1l + k) * kernels_.width] = inverse(k / 3, k % 3);
  }
}

LaneData LaneSolver::data(const double* D) {
  const block::SymbolicFactorization& s = structure_.symbolic;
  return {.steps = s.steps.data(),
          .step_rows = s.step_rows.data(),
          .step_count = std::ssize(s.steps),
          .fronts = s.fronts.data(),
          .front_count = std::ssize(s.fronts),
          .mixed = s.mixed.data(),
          .hubs = s.hubs.data(),
          .couplings = s.couplings.data(),
          .relative_indices = s.relative_indices.data(),
          .bodies = s.bodies.data(),
          .rows = s.rows.data(),
          .row_positions = structure_.row_positions.data(),
          .row_forms = structure_.row_forms.data(),
          .unknowns = s.unknowns.data(),
          .compliance = compliance_.data(),
          .compliant = structure_.inerters > 0,
          .breakdown = s.breakdown(),
          .mass = mass_.data(),
          .mass_factors = mass_factors_.data(),
          .ballast = structure_.with_ballast ? ballast_.data() : nullptr,
          .D = D,
          .factors = factors_.data(),
          .articulated_inertias = articulated_inertias_.data(),
          .panels = panels_.data(),
          .contributions = contributions_.data(),
          .scratch = scratch_.data()};
}

void LaneSolver::leave_out(double* lambda) const {
  for (const int row : structure_.dropped)
    std::fill_n(lambda + std::ptrdiff_t{row} * kernels_.width, kernels_.width, 0.0);
}

void LaneSolver::factorize_and_solve(const Problem& problem) {
  if (!factorizes()) return solve(problem);
  const LaneData at = data(problem.D);
  elimination_.factor(at, problem.a, problem.b, smallest_.data());
  leave_out(problem.lambda);
  elimination_.backward(at, problem.a, problem.x, problem.lambda);
  refine(problem);
}

void LaneSolver::solve(const Problem& problem) {
  if (!factorizes()) return kernels_.accelerate_freely(structure_.bodies, inverse_mass_.data(), problem.a, problem.x);
  const LaneData at = data(problem.D);
  elimination_.forward(at, problem.a, problem.b);
  leave_out(problem.lambda);
  elimination_.backward(at, problem.a, problem.x, problem.lambda);
  refine(problem);
}

/// As the block solver does.
void LaneSolver::refine(const Problem& problem) {
  if (std::find(far_apart_.begin(), far_apart_.end(), true) == far_apart_.end()) return;
  const LaneData at = data(problem.D);
  const LaneEquations equations{.bodies = structure_.bodies,
                                .rows = structure_.multipliers(),
                                .blocks = structure_.blocks.data(),
                                .block_count = std::ssize(structure_.blocks),
                                .compliance = compliance_.data(),
                                .mass = mass_.data(),
                                .lengths = nullptr,
                                .D = problem.D};
  const int velocities = velocity_size * structure_.bodies;
  std::copy(far_apart_.begin(), far_apart_.end(), going_on_.begin());
  for (int step = 0; step < block::most_refinements; ++step) {
    kernels_.residuals(equations, problem.a, problem.b, problem.x, problem.lambda, r_1_.data(), r_2_.data());
    elimination_.forward(at, r_1_.data(), r_2_.data());
    leave_out(dlambda_.data());
    elimination_.backward(at, r_1_.data(), dx_.data(), dlambda_.data());
    kernels_.add(velocities, going_on_.data(), dx_.data(), problem.x);
    kernels_.add(structure_.multipliers(), going_on_.data(), dlambda_.data(), problem.lambda);
    kernels_.largest(velocities, problem.x, largest_.data());
    kernels_.largest(velocities, dx_.data(), correction_.data());
    bool any = false;
    for (int l = 0; l < kernels_.width; ++l) {
      if (!block::goes_on_refining(largest_[l], correction_[l])) going_on_[l] = 0.0;
      any = any || going_on_[l] != 0.0;
    }
    if (!any) return;
  }
}

}  // namespace linkwork
