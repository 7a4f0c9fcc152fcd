#include "linkwork/integration/growing_multipliers.hpp"

#include <algorithm>
#include <cmath>

#include "linkwork/math/lagrange.hpp"

namespace linkwork {
namespace {

constexpr double better = 0.1;  // times the error, to take multipliers for such that grow without limit

class GrowingMultipliers {
 public:
  GrowingMultipliers(std::vector<double> places, std::vector<VectorXd> multipliers, const std::vector<double>& poses,
                     double nearest)
      : places_(std::move(places)), smooth_(std::move(multipliers)), poses_(poses), nearest_(nearest) {
    for (std::size_t j = 0; j < poses_.size(); ++j) residues_.push_back(residue(j));
    for (std::size_t k = 0; k < places_.size(); ++k) smooth_[k] -= growing(places_[k]);
  }

  VectorXd at(double place) const { return between(smooth_, place) + growing(place); }

 private:
  double way(double place, double pose) const {
    const double way = place - pose;
    return std::copysign(std::max(std::abs(way), nearest_), way);
  }
  /// Of the multipliers times the ways to all poses, in this pose, over the ways from there to the others.
  VectorXd residue(std::size_t j) const {
    std::vector<VectorXd> products = smooth_;
    for (std::size_t i = 0; i < poses_.size(); ++i)
      for (std::size_t k = 0; k < places_.size(); ++k)
        products[k] *= way(places_[k], poses_[i]) / (i == j ? 1.0 : way(poses_[j], poses_[i]));
    return between(products, poses_[j]);
  }
  VectorXd growing(double place) const {
    VectorXd sum = VectorXd::Zero(smooth_.front().size());
    for (std::size_t j = 0; j < poses_.size(); ++j) sum += residues_[j] / way(place, poses_[j]);
    return sum;
  }
  VectorXd between(const std::vector<VectorXd>& values, double place) const {
    return interpolated(places_, values, place);
  }

  std::vector<double> places_;
  std::vector<VectorXd> smooth_;  ///< what does not grow
  const std::vector<double>& poses_;
  double nearest_;
  std::vector<VectorXd> residues_;
};

}  // namespace

std::optional<VectorXd> growing_multipliers(const std::vector<double>& places, const std::vector<VectorXd>& multipliers,
                                            const std::vector<double>& poses, double nearest, double at) {
  if (poses.empty() || places.size() < 3 || multipliers.front().size() == 0) return {};
  const std::vector<double> others(places.begin() + 1, places.end());
  const std::vector<VectorXd> of_others(multipliers.begin() + 1, multipliers.end());
  const auto error = [&](const VectorXd& found) { return (found - multipliers.front()).cwiseAbs().maxCoeff(); };
  const double growing = error(GrowingMultipliers(others, of_others, poses, nearest).at(places.front()));
  if (!(growing < better * error(interpolated(others, of_others, places.front())))) return {};
  return GrowingMultipliers(places, multipliers, poses, nearest).at(at);
}

}  // namespace linkwork
