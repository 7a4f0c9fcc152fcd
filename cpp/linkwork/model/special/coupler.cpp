#include "linkwork/model/special/coupler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linkwork/math/error.hpp"
#include "linkwork/model/history.hpp"
#include "linkwork/model/primitives.hpp"

namespace linkwork {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int most_turns = 100;
constexpr double same = 3e-6;  // [rad] relative to the factors

/// Of a joint. ModelError: there is no such joint, or no such coordinate of it.
const FreeCoordinate* coordinate_of(const Model& model, const CoupledCoordinate& given) {
  if (given.joint < 0 || given.joint >= static_cast<int>(model.joints().size()))
    throw ModelError("unknown_joint", "coupler: joint index " + std::to_string(given.joint) + " does not exist");
  const Element& joint = model.joints()[given.joint];
  const FreeCoordinate* found = find_coordinate(joint_info(joint.kind), given.name);
  if (!found)
    throw ModelError("coordinate",
                     "coupler: joint '" + model.joint_name(given.joint) + "' has no coordinate '" + given.name + "'");
  return found;
}

/// Place of a body in the list, to which it is added where it is missing.
std::size_t place_of(int body, std::vector<int>& bodies) {
  const auto found = std::find(bodies.begin(), bodies.end(), body);
  if (found == bodies.end()) bodies.push_back(body);
  return static_cast<std::size_t>(std::find(bodies.begin(), bodies.end(), body) - bodies.begin());
}

void add(double factor, const double* row, double* to) {
  for (int c = 0; c < velocity_size; ++c) to[c] += factor * row[c];
}

}  // namespace

KindInfo coupler_joint() {
  return {
      .name = "coupler",
      .rows = 1,
      .placement = "coordinates",
      .parameters = {{"offset", "rad or m", "sum of factors times coordinates", Takes::differentiable, {.usual = 0.0}}},
      .equations = {{"relation of joint coordinates"}},
      .documentation =
          "Linear relation between free coordinates of joints, such as a belt, a differential, or a finger that "
          "follows another: sum factor x coordinate = `offset`, a number or a function of time."};
}

Coupler::Coupler(const Model& model, const std::vector<CoupledCoordinate>& given) {
  if (given.empty()) throw ModelError("coordinate", "coupler: it has no coordinates");
  for (const CoupledCoordinate& it : given) {
    const FreeCoordinate* coordinate = coordinate_of(model, it);
    if (!std::isfinite(it.factor) || it.factor == 0.0)
      throw ModelError("factor", "coupler: the factor of '" + model.joint_name(it.joint) + "' is " +
                                     std::to_string(it.factor) + " and must be finite and not zero");
    const Element& joint = model.joints()[it.joint];
    const std::size_t i = place_of(joint.i, bodies_), j = place_of(joint.j, bodies_);
    terms_.push_back({.i = i,
                      .j = j,
                      .at = joint.at,
                      .coordinate = coordinate,
                      .factor = it.factor,
                      .history = coordinate->angle() ? angles_++ : -1});
  }
}

// Phi = sum f_k x_k - offset, with angles continued over full turns.
void Coupler::evaluate(const BodyState<double>* bodies, const Signal<double>* parameters, const SpecialHistory& history,
                       const SpecialRows& out) const {
  Equation<double> row;
  const bool begins = angles_ > 0 && std::isnan(history.last[0]);
  out.Phi[0] = -parameters[0].value;
  out.Phi_t[0] = -parameters[0].rate;
  out.gamma[0] = parameters[0].acceleration;
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const Term& term = terms_[k];
    term.coordinate->evaluate(term.at, bodies[term.i], bodies[term.j], row);
    if (term.history >= 0) {
      row.Phi = continued(row.Phi, begins ? 0.0 : history.last[term.history]);
      history.next[term.history] = row.Phi;
      history.rate[term.history] = row.rate(bodies[term.i], bodies[term.j]);
    }
    out.Phi[0] += term.factor * row.Phi;
    out.gamma[0] += term.factor * row.gamma;
    add(term.factor, row.D_i, out.D + velocity_size * term.i);
    add(term.factor, row.D_j, out.D + velocity_size * term.j);
  }
  if (begins) out.Phi[0] = choose_turns(out.Phi[0], history.next);
}

SpecialJointPtr Coupler::seen_from(const Vec3<double>& origin) const {
  auto out = std::make_shared<Coupler>(*this);
  for (Term& term : out->terms_) term.at = linkwork::seen_from(origin, term.at, bodies_[term.i], bodies_[term.j]);
  return out;
}

/// At the first pose, such as the last one of another run: the fewest turns of two of the angles with which the
/// relation holds, and what is left of its violation, which with a ratio near to a whole number is small without them,
/// too. None where it never holds: such a pose is to be corrected. None either where all angles are zero, as in the pose in which joints are made: there nothing has
/// turned yet, and an offset that is not met is a mistake.
double Coupler::choose_turns(double violation, double* turns) const {
  std::vector<std::size_t> angles;
  double sum = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < terms_.size(); ++k)
    if (terms_[k].coordinate->angle()) {
      angles.push_back(k);
      sum += std::abs(terms_[k].factor);
      largest = std::max(largest, std::abs(turns[terms_[k].history]));
    }
  const auto holds = [&](double rest) { return std::abs(rest) <= same * sum; };
  if (angles.empty() || largest <= same || holds(violation)) return violation;
  const std::size_t a = angles[0], b = angles[angles.size() > 1 ? 1 : 0];
  const double f_a = turn * terms_[a].factor, f_b = turn * terms_[b].factor;
  for (int n = 0; n <= (a == b ? 0 : most_turns); ++n)
    for (const double n_a : {double(n), double(-n)}) {
      const double n_b = -std::round((violation + n_a * f_a) / f_b);
      const double rest = violation + n_a * f_a + n_b * f_b;
      if (std::abs(n_b) > most_turns || !holds(rest)) continue;
      if (a != b) turns[terms_[a].history] += turn * n_a;
      turns[terms_[b].history] += turn * n_b;
      return rest;
    }
  return violation;
}

}  // namespace linkwork
