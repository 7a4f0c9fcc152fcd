#include "linkwork/integration/kink_watch.hpp"

#include <algorithm>
#include <utility>

#include "linkwork/model/force_kind.hpp"

namespace linkwork {

/// Stands for a function, and keeps where it was asked.
class KinkWatch::PieceOf final : public TimeFunction {
 public:
  explicit PieceOf(std::vector<double> kinks) : kinks_(std::move(kinks)) {}
  Signal<double> evaluate(double x) const override {
    piece_ = static_cast<int>(std::upper_bound(kinks_.begin(), kinks_.end(), x) - kinks_.begin());
    return {0.0, 0.0, 0.0};
  }
  bool of_time() const override { return false; }
  int piece() const { return piece_; }

 private:
  std::vector<double> kinks_;
  mutable int piece_ = 0;
};

/// Nothing where the parameter is no characteristic with kinks.
std::shared_ptr<const KinkWatch::PieceOf> KinkWatch::piece_of(const Model& model, const Parameter& parameter) {
  if (parameter.signal < 0) return {};
  const TimeFunction& function = *model.signals()[static_cast<std::size_t>(parameter.signal)];
  if (function.of_time()) return {};
  std::vector<Break> breaks;
  function.add_breaks(breaks);
  std::vector<double> kinks;
  for (const Break& at : breaks)
    if (at.ends_step) kinks.push_back(at.t);
  if (kinks.empty()) return {};
  std::sort(kinks.begin(), kinks.end());
  return std::make_shared<PieceOf>(std::move(kinks));
}

KinkWatch::KinkWatch(const System& system) {
  const Model& model = system.model();
  for (int element = 0; element < static_cast<int>(model.forces().size()); ++element) {
    const Element& it = model.forces()[static_cast<std::size_t>(element)];
    const std::size_t count = force_kinds()[it.kind].info.parameters.size();
    for (std::size_t p = 0; p < count; ++p) {
      std::shared_ptr<const PieceOf> function = piece_of(model, model.force_parameters()[it.first_parameter + p]);
      if (!function) continue;
      if (elements_.empty() || elements_.back() != element) watched_.push_back({ForceElement(system, element), {}});
      watched_.back().element.replace(p, function);
      watched_.back().functions.push_back(std::move(function));
      elements_.push_back(element);
    }
  }
}

const std::vector<int>& KinkWatch::pieces(double t, const ConstVector& q, const ConstVector& v,
                                          const ConstVector& history) {
  pieces_.clear();
  for (Watched& it : watched_) {
    it.element.potential(t, q, v, history);
    for (const auto& function : it.functions) pieces_.push_back(function->piece());
  }
  return pieces_;
}

}  // namespace linkwork
