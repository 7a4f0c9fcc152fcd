#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/integration/break_points.hpp"

namespace linkwork {

/// Where stiffness, free length or ends of the free range of a force element jump at a break, the energy that it stores
/// jumps, too, in a state (q, v) that does not. Whoever makes it jump does the work V(after) - V(before).
class StoredEnergyJumps {
 public:
  /// Refers to the system.
  explicit StoredEnergyJumps(const System& system);

  bool any() const { return !elements_.empty(); }  ///< elements whose stored energy may jump
  /// From `before` to `after` [s] a break, at the state y = (q, v, work) with the history of the last accepted one [J].
  double work(double before, double after, const VectorXd& y, const VectorXd& history) const;
  /// The same of all breaks in a step from (t, y) to (t_new, y_new). Those at its ends are up to these times in the one
  /// step and from there on in the other, as functions are evaluated at these times.
  double work_in_step(const BreakPoints& breaks, double t, double t_new, const VectorXd& y, const VectorXd& y_new,
                      const VectorXd& history) const;

 private:
  /// Whose stored energy depends on functions of time: its place in the model's forces, and these.
  struct Element {
    int force;
    std::vector<TimeFunctionPtr> functions;
  };

  const System& system_;
  std::vector<Element> elements_;
};

}  // namespace linkwork
