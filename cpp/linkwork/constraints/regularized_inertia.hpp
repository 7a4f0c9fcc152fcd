#pragma once

#include <memory>
#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Mass matrices with very small principal moments: thin rods, point masses, massless bodies.
///
/// Who eliminates bodies first, divides by their inertia j, and what is large then, 1/j, cancels in the equations of
/// joints that hold the body against that rotation: with roundoff of some 1e-15 N/j in the accelerations, N the inertia
/// of the body's other motions. This matters where joints feel the rotation, and where they do, they mostly decide it
/// themselves. So small moments are regularized, M^ = M + P, P a body's own and only as large as roundoff asks for.
/// Then M^ factorizes as well as that of compact bodies does, and Refinement leads from its solutions to those of M.
///
/// All is judged per body, in its own length and mass, so that units do not matter.
class RegularizedInertia {
 public:
  /// Which rotations joints feel is seen at the evaluation `typical`.
  RegularizedInertia(const System& system, const Evaluation& typical);

  /// With M^ for M; the given one where there is nothing to be regularized.
  const System& system() const { return regularized_ ? *regularized_ : *given_; }
  bool regularized() const { return regularized_ != nullptr; }
  const std::vector<int>& regularized_bodies() const { return changed_; }

  /// The smallest moment that joints feel, of any body, relative to the inertia of the body's other motions; 1 at most.
  double smallest_moment() const { return smallest_; }
  /// Whether roundoff by small moments would show in solutions with relative errors of `accuracy`.
  bool shows(double accuracy) const;
  /// Whether solutions of `system()` are to be refined for such errors.
  bool refined(double accuracy) const { return regularized() || shows(accuracy); }

  /// Size that makes rotations of a body comparable with its translations [m], one per body.
  const VectorXd& lengths() const { return lengths_; }

 private:
  const System* given_;
  std::unique_ptr<System> regularized_;
  std::vector<int> changed_;
  double smallest_ = 1.0;
  VectorXd lengths_;
};

}  // namespace linkwork
