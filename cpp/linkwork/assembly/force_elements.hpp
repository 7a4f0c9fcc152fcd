#pragma once

#include <array>

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
  /// Where the place of its history variable is known; -1: it has none.
  ForceElement(const System& system, int element, int history);
  /// `history` as for System::evaluate; `v_dot` counts for inerters.
  ForceOnBody evaluate(double t, const ConstVector& q, const ConstVector& v, const ConstVector& v_dot,
                       const ConstVector& history);
  /// Its switches, see Wrenches.
  std::array<double, 2> switches(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history);
  /// What it adds to g of its two bodies, in their order.
  std::array<double, 2 * velocity_size> forces(double t, const ConstVector& q, const ConstVector& v,
                                               const ConstVector& history);
  /// The energy that it stores [J].
  double potential(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history);
  /// The same, and the power of the part of its force that has no potential [W].
  struct Energy {
    double potential, power;
  };
  Energy energy(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history);
  const Element& element() const { return element_; }
  /// Another function for its parameter of that place.
  void replace(std::size_t parameter, TimeFunctionPtr function);

 private:
  /// What its law says, by itself.
  struct Said {
    std::array<BodyState<double>, 2> bodies;
    std::array<double, 2 * velocity_size> g{};
    std::array<double, 2> switches{};
    double history = 0.0, potential = 0.0, power = 0.0;
  };
  Said ask(double t, const ConstVector& q, const ConstVector& v, const ConstVector& history);
  void add_inertia(const BodyState<double>* bodies, const ConstVector& v_dot, double* g) const;

  const System& system_;
  Element element_;
  ForceBatch batch_;
  int history_ = -1;                        ///< place of its variable
  std::vector<TimeFunctionPtr> functions_;  ///< its own parameters'
  std::vector<Signal<double>> signals_;
};

/// Of a switch: its force element, of those in Model::forces(), and which of its switches it is.
struct SwitchOwner {
  int element, place;
};
/// Of all, in the order of Evaluation::switches.
std::vector<SwitchOwner> owners_of_switches(const Model& model);

}  // namespace linkwork
