#pragma once

#include "linkwork/constraints/consistent_pose.hpp"
#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/constraints/natural_size.hpp"

namespace linkwork {

/// What begins in a singular pose, where branches of motion meet.
struct Departure {
  enum class Kind {
    one_motion,       ///< or rest
    of_no_branch,     ///< the velocities belong to none
    several_motions,  ///< no velocities decide between them
    no_motion         ///< from rest: forces act along infinitesimal motions, which no finite reactions hold
  };
  Kind kind = Kind::one_motion;
  VectorXd v_dot = {};   ///< on the branch
  bool decided = false;  ///< it is that of the velocities
};

/// Looks where a mechanism can go from a singular pose, which the equations of that pose do not tell: at places beside it
/// that meet the constraints, where D has its full rank.
///
/// Velocities lie on a branch where a displacement along them is off the constraints by no more than a branch bends. Then
/// they decide, be they fast or slow. From rest the accelerations do that the joints allow in the pose: on a branch that
/// leads along them reactions are finite, on all others these would grow like 1 / t^2. Where none does, each branch has
/// a motion of its own, with the accelerations that its D allows. A toggle that is stretched to the full, both ends held,
/// has none: from everywhere beside the pose the constraints lead back into it.
///
/// Each connected component is looked at by itself.
class DepartureSearch {
 public:
  /// `redundant` rows, ascending, are implied by the others in every pose.
  DepartureSearch(const System& system, const std::vector<int>& redundant, const TimedPose& pose);
  /// With velocities v and what drives the bodies there, g as in Evaluation.
  Departure find(const VectorXd& v, const VectorXd& g);

 private:
  struct Place {
    double t;
    VectorXd q;
    VectorXd corrected;  ///< from where a displacement led, relative to that, 6 per body
    VectorXd off;        ///< the size of it, per component; infinite where it does not come to the constraints
    VectorXd away;       ///< from the pose, per component, relative to the displacement
  };
  using OfComponents = std::vector<char>;

  Place go(const VectorXd& direction, double sign = 1.0);
  bool lies_on_branch(const VectorXd& fall);
  OfComponents undecided_by(const VectorXd& v_dot);
  VectorXd of_start(const VectorXd& v_dot);
  VectorXd driven_by(double seconds);
  VectorXd off_along(const VectorXd& direction);
  VectorXd off_along_start(const VectorXd& direction);
  Departure::Kind kind_of(const VectorXd& v_dot, const OfComponents& undecided, VectorXd& of_branch);
  bool differ(const Place& one, const VectorXd& a, const Place& other, const VectorXd& b, const VectorXd& v_dot,
              const OfComponents& undecided) const;
  VectorXd accelerations(const Place& place);
  bool singular(const Place& place, double near) const;
  void evaluate(double t, const VectorXd& q, const VectorXd& v);
  VectorXd solve(const VectorXd& a, const VectorXd& b);
  VectorXd momentum(const VectorXd& v) const;
  VectorXd random_direction(std::uint64_t seed);
  VectorXd unit(const VectorXd& v) const;
  VectorXd beside_center(const VectorXd& v) const;
  VectorXd sizes(const VectorXd& x) const;
  void multiply(const VectorXd& factors, VectorXd& x) const;

  const System& given_;
  MassWeightedLeastSquares solver_;
  const System& system_;
  TimedPose pose_;
  NaturalSize size_;
  DroppedRows dropped_;
  Evaluation at_;
  VectorXd e_, lambda_;
  VectorXd v_, g_;
  VectorXd center_;       ///< the velocities, as a displacement
  double seconds_ = 0.0;  ///< in which they make it, where constraints change with time
  double way_;            ///< to the places beside the pose [rad, or relative to the length]
  double blur_;           ///< roundoff of positions, relative to the length
  bool starts_ = false;   ///< from rest, as drivers accelerate it
};

}  // namespace linkwork
