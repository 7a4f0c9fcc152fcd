#pragma once

#include "linkwork/assembly/system.hpp"
#include "linkwork/math/error.hpp"

namespace linkwork {

/// Tells runs that no longer mean anything: bodies that move by many sizes of the mechanism, or turn round very often,
/// within one step.
class Divergence {
 public:
  static constexpr const char* code = "diverged";

  explicit Divergence(const System& system);

  /// NotFiniteError with this code: the state y = (q, v, ...) at t does so in a step of h, beyond all that is possible.
  void check(const VectorXd& y, double t, double h) const { look(y, t, h, impossible); }
  /// Calls `action` from the state y; where it fails and less than that is there, it is the cause.
  template <class Action>
  void blame(const VectorXd& y, double t, double h, Action action) const {
    try {
      action();
    } catch (const SingularSystemError&) {
      look(y, t, h, doubtful);
      throw;
    } catch (const NotConvergedError&) {
      look(y, t, h, doubtful);
      throw;
    }
  }

 private:
  static constexpr double impossible = 1e12, doubtful = 1e3;  ///< sizes or radians in a step
  void look(const VectorXd& y, double t, double h, double limit) const;
  [[noreturn]] void report(double way, bool turn, int body, double t, double h) const;

  const System& system_;
  double size_;  ///< [m]; infinite where the mechanism has none
};

}  // namespace linkwork
