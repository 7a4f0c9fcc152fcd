#pragma once

#include "linkwork/model/model.hpp"

namespace linkwork {

/// A free coordinate of a joint of a model, by its name in the KindInfo, as it enters a coupler.
struct CoupledCoordinate {
  int joint;
  std::string name;
  double factor;
};

/// sum factor_k x_k = offset, of free coordinates x_k of joints (1 equation).
class Coupler final : public SpecialJoint {
 public:
  /// ModelError: no coordinates, one that the joint does not have, a factor of zero.
  Coupler(const Model& model, const std::vector<CoupledCoordinate>& coordinates);
  const std::vector<int>& bodies() const override { return bodies_; }
  HistoryKind history_kind() const override { return HistoryKind::angle; }
  int history_size() const override { return angles_; }
  void evaluate(const BodyState<double>* bodies, const Signal<double>* parameters, const SpecialHistory& history,
                const SpecialRows& out) const override;
  SpecialJointPtr seen_from(const Vec3<double>& origin) const override;

 private:
  struct Term {
    std::size_t i, j;  ///< places in bodies_
    Attachment<double> at;
    const FreeCoordinate* coordinate;
    double factor;
    int history;  ///< place of the angle over full turns, or -1
  };
  double choose_turns(double violation, double* turns) const;

  std::vector<int> bodies_;
  std::vector<Term> terms_;
  int angles_ = 0;  ///< among them
};

}  // namespace linkwork
