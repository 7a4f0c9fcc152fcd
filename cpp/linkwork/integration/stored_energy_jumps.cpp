#include "linkwork/integration/stored_energy_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/integration/hermite_step.hpp"

namespace linkwork {
namespace {

constexpr double roundoff = 1e-13;                                        // of values: a smaller jump is none
constexpr double beside = 16.0 * std::numeric_limits<double>::epsilon();  // of times, beyond both sides of a break

bool jumps(const TimeFunction& function, double before, double after) {
  const Signal<double> from = function.evaluate(before), to = function.evaluate(after);
  const double size = std::max(std::abs(from.value), std::abs(to.value));
  const double slope = std::max(std::abs(from.rate), std::abs(to.rate));
  return std::abs(to.value - from.value) > roundoff * size + 2.0 * slope * (after - before);
}

/// y with the signs of Euler parameters nearest to `like`: an integrator of the user's own may change them in a step.
VectorXd with_signs_of(const VectorXd& like, VectorXd y, int bodies) {
  for (int body = 0; body < bodies; ++body) {
    const int p = position_size * body + 3;
    if (like.segment<4>(p).dot(y.segment<4>(p)) < 0.0) y.segment<4>(p) *= -1.0;
  }
  return y;
}

}  // namespace

StoredEnergyJumps::StoredEnergyJumps(const System& system) : system_(system) {
  const Model& model = system.model();
  for (std::size_t k = 0; k < model.forces().size(); ++k) {
    const auto& parameters = force_kinds()[model.forces()[k].kind].info.parameters;
    const bool by_characteristic = std::any_of(parameters.begin(), parameters.end(),
                                               [](const auto& it) { return it.takes == Takes::characteristic; });
    Element found{static_cast<int>(k), {}};
    for (std::size_t p = 0; p < parameters.size(); ++p) {
      const int signal = model.force_parameters()[model.forces()[k].first_parameter + p].signal;
      if (signal < 0 || !(by_characteristic || parameters[p].takes == Takes::differentiable)) continue;
      const TimeFunctionPtr& function = model.signals()[static_cast<std::size_t>(signal)];
      if (function->of_time() && function->has_derivatives()) found.functions.push_back(function);
    }
    if (!found.functions.empty()) elements_.push_back(std::move(found));
  }
}

double StoredEnergyJumps::work(double before, double after, const VectorXd& y, const VectorXd& history) const {
  const auto q = y.head(system_.q_size()), v = y.segment(system_.q_size(), system_.v_size());
  double out = 0.0;
  for (const Element& it : elements_) {
    const auto its = [&](const TimeFunctionPtr& function) { return jumps(*function, before, after); };
    if (std::none_of(it.functions.begin(), it.functions.end(), its)) continue;
    ForceElement element(system_, it.force);
    const double stored = element.potential(before, q, v, history);
    out += element.potential(after, q, v, history) - stored;
  }
  return out;
}

double StoredEnergyJumps::work_in_step(const BreakPoints& breaks, double t, double t_new, const VectorXd& y,
                                       const VectorXd& y_new, const VectorXd& history) const {
  double out = 0.0;
  if (elements_.empty()) return out;
  const double first = breaks.next(breaks.before(t - beside * std::abs(t)));
  if (!(breaks.before(first) < t_new)) return out;
  const VectorXd end = with_signs_of(y, y_new, system_.body_count());
  const HermiteStep step(system_, y, end, t_new - t);
  VectorXd there(y.size());
  for (double it = first; breaks.before(it) < t_new; it = breaks.next(it)) {
    const double before = std::max(breaks.before(it), t), after = std::min(breaks.after(it), t_new);
    if (!(before < after)) continue;
    if (breaks.after(it) < t_new) step.interpolate(system_, std::clamp((it - t) / (t_new - t), 0.0, 1.0), there);
    else there = end;
    out += work(before, after, there, history);
  }
  return out;
}

}  // namespace linkwork
