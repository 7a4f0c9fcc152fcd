#pragma once

#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// Weights of the polynomial through values at so many places, at another one.
inline std::vector<double> lagrange_weights(const std::vector<double>& places, double at) {
  std::vector<double> weights(places.size(), 1.0);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != i) weights[i] *= (at - places[k]) / (places[i] - places[k]);
  return weights;
}

/// The polynomial itself.
inline VectorXd interpolated(const std::vector<double>& places, const std::vector<VectorXd>& values, double at) {
  const std::vector<double> weights = lagrange_weights(places, at);
  VectorXd sum = VectorXd::Zero(values.front().size());
  for (std::size_t k = 0; k < values.size(); ++k) sum += weights[k] * values[k];
  return sum;
}

/// The highest divided difference of values at so many places.
inline double divided_difference(const std::vector<double>& places, const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    double product = 1.0;
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != i) product *= places[i] - places[k];
    sum += values[i] / product;
  }
  return sum;
}

}  // namespace linkwork
