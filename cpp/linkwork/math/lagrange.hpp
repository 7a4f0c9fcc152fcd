#pragma once

#include <vector>

namespace linkwork {

/// Weights of the polynomial through values at so many places, at another one.
inline std::vector<double> lagrange_weights(const std::vector<double>& places, double at) {
  std::vector<double> weights(places.size(), 1.0);
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t k = 0; k < places.size(); ++k)
      if (k != i) weights[i] *= (at - places[k]) / (places[i] - places[k]);
  return weights;
}

}  // namespace linkwork
