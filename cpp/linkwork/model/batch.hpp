#pragma once

#include <cstddef>
#include <vector>

#include "linkwork/model/body_state.hpp"

namespace linkwork {

/// A parameter of a joint or force: a constant, or the signal (function of time) with this index.
struct Parameter {
  double constant = 0.0;
  int signal = -1;
};

/// The current value of a parameter.
inline Signal<double> current(const Parameter& parameter, const Signal<double>* signals) {
  if (parameter.signal < 0) return {parameter.constant, 0.0, 0.0};
  return signals[parameter.signal];
}

/// All joints, or all forces, of one kind in one system: what evaluation reads.
/// Bodies are indices into an array of states whose last entry is the ground.
struct Batch {
  std::vector<int> element;  ///< index in the model
  std::vector<int> body_i, body_j;
  std::vector<Attachment<double>> attachment;
  std::vector<Parameter> parameters;   ///< as many per element as the kind has
  std::vector<int> row;                ///< first constraint row (joints)
  std::vector<std::ptrdiff_t> D;       ///< place of D_i; D_j follows (joints)
  std::vector<std::ptrdiff_t> memory;  ///< place of remembered numbers (forces)

  std::size_t size() const { return body_i.size(); }
};

}  // namespace linkwork
