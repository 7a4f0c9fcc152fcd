#pragma once

#include <array>
#include <cmath>

#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

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
  struct Sample {
    double t = 0.0, root = 0.0;
  };

  bool worth_a_search(double root) const;
  bool probe();
  void search(Sample a, Sample b, Sample c);
  void interpolate(double t, VectorXd& y) const;

  Dynamics& dynamics_;
  std::array<Mark, 3> marks_;  ///< the last ones
  int count_ = 0;              ///< of them
  double highest_ = 0.0;       ///< root since the last pose that was listed
  VectorXd y_;
};

}  // namespace linkwork
