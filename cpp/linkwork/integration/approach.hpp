#pragma once

#include <vector>

#include "linkwork/assembly/force_elements.hpp"

namespace linkwork {

/// The states at both ends of a step of h [s], which the caller keeps. Accelerations are null where they are not known.
struct StepEnds {
  double t, h;
  const VectorXd &y, &y_new;
  const double *v_dot = nullptr, *v_dot_new = nullptr;
};

/// How far the two bodies of a contact or a stop may come nearer within a step, by their speeds: what is farther apart
/// need not be looked at.
///
/// Where positions are the cubics of Hermite, velocities are quadratic in time, and never more than the largest of
/// their three Bernstein coefficients, h r_dot at both ends and 3 (r_new - r) less both. Steps that are longer than
/// what a cubic follows have h^2 r_ddot / 2 beside it, without which an oscillation that returns to the same state was
/// none.
class Approach {
 public:
  explicit Approach(const Model& model);

  /// Of a switch: the most that it changes by as bodies move [m or rad].
  double largest_change(int which, const StepEnds& step) const;
  /// A limit that is a function of time, of which a switch is so many times as much more as that is more.
  struct Limit {
    const TimeFunction* function = nullptr;  ///< null: none is
    double sign = 0.0;
    double amplitude = 0.0;      ///< see TimeFunction
    std::vector<double> breaks;  ///< its own [s]
  };
  const Limit& limit(int which) const { return gaps_[static_cast<std::size_t>(which)].limit; }
  /// Whether its depth is that of two spheres, which is not smooth where these are small and pass each other fast: of
  /// the radii less the distance of their centers.
  bool of_spheres(int which) const { return gaps_[static_cast<std::size_t>(which)].shape == Shape::spheres; }
  /// Of their centers, in a state y.
  double distance(int which, const VectorXd& y) const;
  const SwitchOwner& owner(int which) const { return gaps_[static_cast<std::size_t>(which)].owner; }

 private:
  enum class Shape { spheres, along_axis, angle };
  struct Gap {
    SwitchOwner owner;
    int i, j;
    Vec3<double> s_i, s_j;  ///< as of Attachment
    Shape shape;
    Limit limit;
  };

  std::vector<Gap> gaps_;
};

}  // namespace linkwork
