#include "linkwork/ensemble/lane_refinement.hpp"

#include <algorithm>

#include "linkwork/constraints/natural_size.hpp"
#include "linkwork/ensemble/lane_structure.hpp"
#include "linkwork/formulation/watched_formulation.hpp"

namespace linkwork {

LaneRefinement::LaneRefinement(const LaneStructure& structure, const LaneKernels& kernels,
                               const std::vector<Dynamics*>& mechanisms)
    : structure_(structure), kernels_(kernels), mechanisms_(mechanisms), refined_(mechanisms.size(), 0) {
  for (std::size_t l = 0; l < mechanisms.size(); ++l) load(l);
}

void LaneRefinement::replace(int l, Dynamics& mechanism) {
  mechanisms_[l] = &mechanism;
  load(l);
}

void LaneRefinement::load(std::size_t l) {
  refined_[l] = structure_.connected() && mechanisms_[l]->formulation().refines();
  needed_ = std::find(refined_.begin(), refined_.end(), true) != refined_.end();
  if (!needed_) return;
  const std::ptrdiff_t width = kernels_.width;
  if (lengths_.empty()) {
    for (AlignedDoubles* velocities : {&r_1_, &dx_}) velocities->assign(velocity_size * structure_.bodies * width, 0.0);
    for (AlignedDoubles* rows : {&r_2_, &dlambda_}) rows->assign(structure_.multipliers() * width, 0.0);
    for (AlignedDoubles* one : {&going_on_, &other_}) one->assign(width, 0.0);
    for (AlignedDoubles* sizes : {&free_motion_, &size_, &correction_})
      sizes->assign(structure_.component_count * width, 0.0);
    scratch_.assign(2 * structure_.component_count * width, 0.0);
    lengths_.assign(structure_.bodies * width, 1.0);
  }
  for (std::size_t lane = 0; lane < mechanisms_.size(); ++lane) {
    const auto place = static_cast<std::ptrdiff_t>(lane);
    const Dynamics& mechanism = *mechanisms_[lane];
    other_[place] = mechanism.formulation().regularized();
    for (std::ptrdiff_t body = 0; body < structure_.bodies; ++body)
      lengths_[body * width + place] = mechanism.formulation().inertia().lengths()[body];
  }
}

void LaneRefinement::refine(const Inertia& inertia, const LaneSolver::Problem& problem, LaneSolver& nearby,
                            LaneGuard& guard) {
  const LaneEquations equations{.bodies = structure_.bodies,
                                .rows = structure_.rows,
                                .blocks = structure_.blocks.data(),
                                .block_count = structure_.joint_blocks,
                                .inerters = structure_.blocks.data() + structure_.joint_blocks,
                                .inerter_count = std::ssize(structure_.blocks) - structure_.joint_blocks,
                                .inertance = inertia.inertance,
                                .mass = inertia.mass,
                                .lengths = lengths_.data(),
                                .components = structure_.components.data(),
                                .component_count = structure_.component_count,
                                .D = problem.D};
  kernels_.free_motion(equations, other_.data(), problem.a, scratch_.data(), free_motion_.data());
  std::vector<Corrections> corrections;
  for (std::size_t l = 0; l < mechanisms_.size(); ++l) {
    corrections.emplace_back(other_[l] != 0.0 ? Inexactness::inertia : Inexactness::roundoff);
    going_on_[l] = guard.steps(static_cast<int>(l)) && refined_[l];
  }
  while (std::any_of(going_on_.begin(), going_on_.end(), [](double chosen) { return chosen != 0.0; })) {
    kernels_.residuals(equations, problem.a, problem.b, problem.x, problem.lambda, r_1_.data(), r_2_.data());
    nearby.solve({problem.D, r_1_.data(), r_2_.data(), dx_.data(), dlambda_.data()});
    kernels_.add(velocity_size * structure_.bodies, going_on_.data(), dx_.data(), problem.x);
    kernels_.add(structure_.rows, going_on_.data(), dlambda_.data(), problem.lambda);
    kernels_.motion(equations, problem.x, size_.data());
    kernels_.motion(equations, dx_.data(), correction_.data());
    judge(inertia.t, corrections, guard);
  }
}

double LaneRefinement::largest_correction(std::size_t l) const {
  double out = 0.0;
  for (std::size_t place = l; place < size_.size(); place += static_cast<std::size_t>(kernels_.width))
    out = std::max(out, NaturalSize::ratio(correction_[place], size_[place] + free_motion_[place]));
  return out;
}

void LaneRefinement::judge(const double* t, std::vector<Corrections>& corrections, LaneGuard& guard) {
  using Progress = Corrections::Progress;
  for (std::size_t l = 0; l < mechanisms_.size(); ++l) {
    if (going_on_[l] == 0.0) continue;
    const Progress progress = corrections[l].judge(largest_correction(l));
    if (progress == Progress::going_on) continue;
    going_on_[l] = 0.0;
    const int lane = static_cast<int>(l);
    if (progress == Progress::slow) guard.leave(lane, t[l], "very small inertias, which take conjugate gradients");
    if (progress == Progress::diverged)
      guard.leave(lane, t[l], other_[l] != 0.0 ? "a motion without inertia" : "corrections that do not converge");
  }
}

}  // namespace linkwork
