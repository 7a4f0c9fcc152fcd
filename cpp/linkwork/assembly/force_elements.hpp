#pragma once

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// What a force element does to its second body at its point there, and to the mechanism.
struct ForceOnBody {
  Vec3<double> force;      ///< [N], inertial axes
  Vec3<double> torque;     ///< about the element's point on the body [N m], inertial axes
  double power = 0.0;      ///< that it gives to both bodies [W]
  double potential = 0.0;  ///< stored in it [J]
  double history = 0.0;    ///< what its history variable becomes; 0: it has none
};

/// One force element by itself, of those in Model::forces(): System adds all of them up.
class ForceElement {
 public:
  ForceElement(const System& system, int element);
  /// `history` as for System::evaluate; `v_dot` counts for inerters.
  ForceOnBody evaluate(double t, const ConstVector& q, const ConstVector& v, const ConstVector& v_dot,
                       const ConstVector& history);

 private:
  void add_inertia(const BodyState<double>* bodies, const ConstVector& v_dot, double* g) const;

  const System& system_;
  Element element_;
  ForceBatch batch_;
  int history_ = -1;  ///< place of its variable
  std::vector<Signal<double>> signals_;
};

}  // namespace linkwork
