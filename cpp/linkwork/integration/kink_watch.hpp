#pragma once

#include <memory>
#include <vector>

#include "linkwork/assembly/force_elements.hpp"

namespace linkwork {

/// Kinks of characteristics: where functions of coordinates and of rates, of force elements, are not smooth up to the
/// second derivative, as their tables say.
class KinkWatch {
 public:
  explicit KinkWatch(const System& system);

  bool empty() const { return watched_.empty(); }
  /// The force elements of `pieces`, of those in Model::forces().
  const std::vector<int>& elements() const { return elements_; }
  /// Between which of its kinks the argument of each function is; of the element's variables, `history`, as for
  /// System::evaluate.
  const std::vector<int>& pieces(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history);

 private:
  class PieceOf;
  static std::shared_ptr<const PieceOf> piece_of(const Model& model, const Parameter& parameter);
  struct Watched {
    ForceElement element;
    std::vector<std::shared_ptr<const PieceOf>> functions;
  };

  std::vector<Watched> watched_;
  std::vector<int> elements_, pieces_;
};

}  // namespace linkwork
