#pragma once

#include <cmath>
#include <vector>

#include "linkwork/constraints/consistent_pose.hpp"
#include "linkwork/constraints/dropped_rows.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork {

/// What became of redundant rows at some pose that violates them more than the others.
struct RedundancyExamination {
  VectorXd q;               ///< on all constraints, where there is such a pose near
  bool consistent = false;  ///< there is
  /// Rows to leave out from here on, ascending, where fewer depend on the others than before.
  std::vector<int> choice;
  bool changed = false;  ///< `choice` is another one
  /// The nearest pose in the sense of least squares leaves a good part of the violation; neither this nor
  /// `consistent` where no nearest pose was found.
  bool contradicts = false;
  std::vector<int> joints;  ///< that contradict each other, ascending
};

/// Pulls the pose onto all constraints, redundant ones included, and looks at the rank there. Off the constraints the
/// rank says nothing: equations that contradict each other by delta are independent by delta.
RedundancyExamination examine_redundancy(const System& system, const TimedPose& here,
                                         const std::vector<int>& redundant);

/// Watches rows that are left out as redundant: the others imply them, so their Phi and Phi_dot, which an evaluation
/// has in any case, stay as small as those of the others. More means that they have become independent, or that they
/// contradict the others, such as drivers that agreed at the start.
///
/// A contradiction of accelerations shows in Phi_dot after one step.
class RedundancyWatch {
 public:
  RedundancyWatch() = default;
  RedundancyWatch(const System& system, const VectorXd& q);

  struct Excess {
    double position = 0.0, velocity = 0.0;  ///< relative to the size of the mechanism, to its largest speed so far
    double Phi = 0.0;                       ///< the largest of a dropped row [m or 1]
    double kept = 0.0;                      ///< the position of the others; known where they were looked at
  };

  /// False for all but few states (q, v) of a run, for which a look at the dropped rows alone is enough.
  bool suspicious(const System& system, const Evaluation& at, const DroppedRows& dropped, const ConstVector& v) {
    for (const int row : dropped.rows())
      if (!usual(at.Phi[row], at.Phi_dot[row])) return exceeds(system, at, dropped, v);
    return false;
  }
  /// Of a dropped row: there is nothing to look at.
  bool usual(double Phi, double Phi_dot) const {
    return std::abs(Phi) <= least_Phi_ && std::abs(Phi_dot) <= least_Phi_dot_;
  }
  const Excess& excess() const { return excess_; }  ///< of the last look
  /// What was found is known: the next suspicion is a larger excess.
  void suspect_less();

  void keep(Archive& archive) {
    archive(size_, speed_, position_level_, velocity_level_, usual_Phi_, usual_Phi_dot_, least_Phi_, least_Phi_dot_);
    archive(excess_.position, excess_.velocity, excess_.Phi, excess_.kept);
  }

 private:
  bool exceeds(const System& system, const Evaluation& at, const DroppedRows& dropped, const ConstVector& v);
  void measure(const System& system, const Evaluation& at, const DroppedRows& dropped, const ConstVector& v);
  void set_least();

  double size_ = 1.0, speed_ = 0.0;
  double position_level_ = 0.0, velocity_level_ = 0.0;
  double usual_Phi_ = 0.0, usual_Phi_dot_ = 0.0;  ///< drift that the other rows have explained, and some more
  double least_Phi_ = 0.0, least_Phi_dot_ = 0.0;  ///< of any row, at the speed known so far, that is looked at
  Excess excess_;
};

}  // namespace linkwork
