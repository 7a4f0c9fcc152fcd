#include "linkwork/constraints/natural_size.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/constraints/length_scale.hpp"

namespace linkwork {

NaturalSize::NaturalSize(const System& system) : system_(&system), lengths_(characteristic_lengths(system)) {}

double NaturalSize::of(const ConstVector& x) const {
  double square = 0.0;
  for (int body = 0; body < system_->body_count(); ++body) {
    const auto own = x.segment<velocity_size>(velocity_size * body);
    square = std::max(
        {square, own.head<3>().squaredNorm() / (lengths_[body] * lengths_[body]), own.tail<3>().squaredNorm()});
    if (!std::isfinite(own.sum())) return INFINITY;
  }
  return std::sqrt(square);
}

double NaturalSize::of_free_motion(const ConstVector& a) const {
  double out = 0.0;
  for (int body = 0; body < system_->body_count(); ++body)
    if (const double m = system_->mass(body); m > 0.0) {
      const double length = lengths_[body];
      out = std::max(
          out, (a.segment<3>(velocity_size * body).norm() + a.segment<3>(velocity_size * body + 3).norm() / length) /
                   (m * length));
    }
  return out;
}

}  // namespace linkwork
