#pragma once

#include <array>
#include <cmath>
#include <functional>

#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// A place on the way, in time or another parameter, and the root of the smallest pivot there.
struct PivotSample {
  double at = 0.0, root = 0.0;
};

/// Where in a bracket, b lower than a and c, the root is least: in a singular pose it comes down to zero like |t|.
/// Ends early where it does not.
PivotSample least_root(PivotSample a, PivotSample b, PivotSample c, const std::function<double(double)>& root_at);
/// Whether that is a zero.
bool vanishes(const PivotSample& a, const PivotSample& least, const PivotSample& c);

/// Lists the singular poses that a motion passes, each once.
///
/// Where the root of the smallest pivot, which goes linearly to zero and up again, has been less than before and after,
/// its least is searched between the states of the motion; one that vanishes is a pose, if the rank says so, too.
class SingularPoseSearch {
 public:
  explicit SingularPoseSearch(Dynamics& dynamics) : dynamics_(dynamics) {}

  /// The motion begins anew.
  void restart();
  /// A state of the motion with the root of its smallest pivot. True where `dynamics` was evaluated somewhere else.
  bool pass(double t, double root, const VectorXd& y);
  /// The last one, for now. Leaves `dynamics` evaluated somewhere else.
  void finish(double t, const VectorXd& y);
  /// The motion begins in a singular pose, where `dynamics` is evaluated.
  void begin_in_pose(double t, double root, const VectorXd& y);

  /// Time of the last state, -infinity where there is none.
  double last() const { return count_ > 0 ? marks_[2].t : -INFINITY; }
  /// 0 where the matrix has no factorization. Leaves `dynamics` evaluated there.
  double root_at(double t, const VectorXd& y);

 private:
  struct Mark {
    double t = 0.0, root = 0.0;
    VectorXd y;
  };

  bool worth_a_search(double root) const;
  bool probe();
  void search(PivotSample a, PivotSample b, PivotSample c);
  void interpolate(double t, VectorXd& y) const;

  Dynamics& dynamics_;
  std::array<Mark, 3> marks_;  ///< the last ones
  int count_ = 0;              ///< of them
  double highest_ = 0.0;       ///< root since the last pose that was listed
  VectorXd y_;
};

}  // namespace linkwork
