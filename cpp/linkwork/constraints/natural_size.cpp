#include "linkwork/constraints/natural_size.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/length_scale.hpp"

namespace linkwork {

NaturalSize::NaturalSize(const System& system)
    : system_(&system), components_(&ConnectedComponents::of(system)), lengths_(characteristic_lengths(system)) {
  heaviest_.setZero(components_->count());
  for (int body = 0; body < system.body_count(); ++body) {
    double& mass = heaviest_[components_->of_body(body)];
    mass = std::max(mass, system.mass(body));
  }
}

double NaturalSize::square(const ConstVector& x, int body) const {
  const auto own = x.segment<velocity_size>(velocity_size * body);
  if (!std::isfinite(own.sum())) return INFINITY;
  return std::max(own.head<3>().squaredNorm() / (lengths_[body] * lengths_[body]), own.tail<3>().squaredNorm());
}

double NaturalSize::of(const ConstVector& x) const {
  double largest = 0.0;
  for (int body = 0; body < system_->body_count(); ++body) largest = std::max(largest, square(x, body));
  return std::sqrt(largest);
}

void NaturalSize::of(const ConstVector& x, VectorXd& components) const {
  components.setZero(components_->count());
  for (int body = 0; body < system_->body_count(); ++body) {
    double& largest = components[components_->of_body(body)];
    largest = std::max(largest, square(x, body));
  }
  components = components.cwiseSqrt();
}

double NaturalSize::of_forces(const ConstVector& a, int body) const {
  const double force = a.segment<3>(velocity_size * body).norm(),
               torque = a.segment<3>(velocity_size * body + 3).norm();
  return force + torque / lengths_[body];
}

double NaturalSize::of_free_body(const ConstVector& a, int body) const {
  const double m = system_->mass(body);
  return m > 0.0 ? of_forces(a, body) / (m * lengths_[body]) : 0.0;
}

void NaturalSize::of_heaviest(const ConstVector& a, VectorXd& components) const {
  components.setZero(components_->count());
  for (int body = 0; body < system_->body_count(); ++body) {
    const int k = components_->of_body(body);
    if (heaviest_[k] > 0.0)
      components[k] = std::max(components[k], of_forces(a, body) / (lengths_[body] * heaviest_[k]));
  }
}

double NaturalSize::of_free_motion(const ConstVector& a) const {
  double out = 0.0;
  for (int body = 0; body < system_->body_count(); ++body) out = std::max(out, of_free_body(a, body));
  return out;
}

void NaturalSize::of_free_motion(const ConstVector& a, VectorXd& components) const {
  components.setZero(components_->count());
  for (int body = 0; body < system_->body_count(); ++body) {
    double& largest = components[components_->of_body(body)];
    largest = std::max(largest, of_free_body(a, body));
  }
}

double NaturalSize::largest_ratio(const VectorXd& x, const VectorXd& sizes) {
  double out = 0.0;
  for (Eigen::Index k = 0; k < x.size(); ++k) out = std::max(out, ratio(x[k], sizes[k]));
  return out;
}

}  // namespace linkwork
