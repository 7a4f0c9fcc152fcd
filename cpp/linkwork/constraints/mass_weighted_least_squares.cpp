#include "linkwork/constraints/mass_weighted_least_squares.hpp"

#include <Eigen/Eigenvalues>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/constraints/length_scale.hpp"
#include "linkwork/linear/block/kept_orders.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

constexpr double flat = 1e-6;  // smallest principal moment, relative to the largest, that makes a metric

/// The mean of the positive numbers among x, or 1.
double mean_of_positive(const VectorXd& x) {
  const auto count = (x.array() > 0.0).count();
  return count > 0 ? x.sum() / static_cast<double>(count) : 1.0;
}

Model with_masses(const System& system, const VectorXd& weights) {
  const Model& model = system.model();
  const auto n = static_cast<Eigen::Index>(model.bodies().size());
  VectorXd mass(n), moment(n);
  for (Eigen::Index b = 0; b < n; ++b) {
    mass[b] = model.bodies()[b].mass;
    moment[b] = model.bodies()[b].inertia.trace() / 3.0;
  }
  const double usual_mass = mean_of_positive(mass), usual_length = characteristic_lengths(system).mean();
  const double usual_moment =
      moment.maxCoeff() > 0.0 ? mean_of_positive(moment) : usual_mass * usual_length * usual_length;
  std::vector<Body> bodies = model.bodies();
  for (Body& body : bodies) {
    const Vec3<double> moments = Eigen::SelfAdjointEigenSolver<Mat3<double>>(body.inertia).eigenvalues();
    if (body.mass == 0.0) body.mass = usual_mass;
    if (!(moments[0] > flat * moments[2]))
      body.inertia = (moments[2] > 0.0 ? moments.mean() : usual_moment) * Mat3<double>::Identity();
  }
  for (Eigen::Index b = 0; b < weights.size(); ++b) {
    bodies[b].mass *= weights[b];
    bodies[b].inertia *= weights[b];
  }
  return model.with_masses(bodies);
}

/// 3 per body: where the first body of its connected component is.
VectorXd first_bodies(const System& system, const ConstVector& q) {
  const ConnectedComponents& components = ConnectedComponents::of(system);
  std::vector<int> first(static_cast<std::size_t>(components.count()), -1);
  VectorXd out(3 * std::ptrdiff_t{system.body_count()});
  for (int body = 0; body < system.body_count(); ++body) {
    int& found = first[components.of_body(body)];
    if (found < 0) found = body;
    out.segment<3>(3 * body) = q.segment<3>(position_size * found);
  }
  return out;
}

}  // namespace

MassWeightedLeastSquares::MassWeightedLeastSquares(const System& system, const VectorXd& weights)
    : MassWeightedLeastSquares(system, system.massless_bodies().empty() && weights.size() == 0
                                           ? nullptr
                                           : std::make_unique<System>(with_masses(system, weights))) {}

MassWeightedLeastSquares MassWeightedLeastSquares::of_geometry(const System& system, const ConstVector& q) {
  const VectorXd& lengths = characteristic_lengths(system);
  std::vector<Body> bodies = system.model().bodies();
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double length = lengths[static_cast<Eigen::Index>(b)];
    bodies[b].mass = 1.0 / (length * length);
    bodies[b].inertia.setIdentity();
  }
  VectorXd origins = first_bodies(system, q);
  const Model model = system.model().with_masses(bodies).without_inertances().seen_from(origins);
  auto geometry = std::make_unique<System>(model);
  keep_lengths(system, *geometry);
  return {system, std::move(geometry), std::move(origins)};
}

MassWeightedLeastSquares::MassWeightedLeastSquares(const System& system, std::unique_ptr<System> other,
                                                   VectorXd origins)
    : origins_(std::move(origins)),
      regularized_(std::move(other)),
      system_(regularized_ ? regularized_.get() : &system),
      saddle_(make_saddle_solver("kkt", linear_solver_info("block"), *system_)) {
  if (regularized_) block::share_orders(system, *regularized_);
  saddle_->analyze(*system_, {});  // block takes none
}

VectorXd MassWeightedLeastSquares::seen(const ConstVector& q) const {
  VectorXd out = q;
  for (Eigen::Index body = 0; 3 * body < origins_.size(); ++body)
    out.segment<3>(position_size * body) -= origins_.segment<3>(3 * body);
  return out;
}

bool MassWeightedLeastSquares::factorize(const Evaluation& at, const VectorXd& e) {
  meter_.add(system_->body_count());
  try {
    saddle_->factorize(at, e);
  } catch (const SingularSystemError&) {
    return false;
  }
  return true;
}

bool MassWeightedLeastSquares::factorize_and_solve(const Evaluation& at, const VectorXd& e, const ConstVector& a,
                                                   const ConstVector& b, MutableVector x, MutableVector lambda) {
  meter_.add(system_->body_count());
  try {
    saddle_->factorize_and_solve(at, e, a, b, x, lambda);
  } catch (const SingularSystemError&) {
    return false;
  }
  return true;
}

void MassWeightedLeastSquares::solve(const ConstVector& a, const ConstVector& b, MutableVector x,
                                     MutableVector lambda) {
  saddle_->solve(a, b, x, lambda);
}

}  // namespace linkwork
