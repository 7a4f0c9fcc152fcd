#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "linkwork/constraints/consistent_pose.hpp"
#include "linkwork/math/archive.hpp"

namespace linkwork {

/// Constraint rows near a pose in which some of them depend on the others.
struct PoseExamination {
  std::vector<int> rows;    ///< of the kept ones, those that nearly depend on the rest; ascending
  std::vector<int> joints;  ///< of the equations in that dependence, ascending
  /// Redundant rows without which the others are independent here, where those that are left out now are the wrong
  /// ones; else empty.
  std::vector<int> better_choice;
  bool singular = false;  ///< whatever is left out, the others nearly depend on each other
};

/// Looks at the loops by a rank-revealing factorization. A row is near the others when so small a part of its length,
/// in velocities of natural size, is independent of them. `redundant` are the rows left out, ascending.
PoseExamination examine_pose(const System& system, const TimedPose& pose, const std::vector<int>& redundant,
                             double near);

/// The redundant rows that leave the others best conditioned in this pose, ascending; none where their number is
/// another than that of those `present`.
std::vector<int> choose_redundant_rows(const System& system, const TimedPose& pose, const std::vector<int>& present);

/// A pose of the motion in which equations depend on each other.
struct SingularityCrossing {
  double t = 0.0;                         ///< [s]
  double pivot = 0.0;                     ///< the smallest there, relative to the usual one
  std::vector<int> joints;                ///< see PoseExamination
  bool rows_changed = false;              ///< no singular pose: other redundant rows are left out from here on
  std::int64_t fallback_evaluations = 0;  ///< evaluations before that the usual factorization was not trusted with
};

/// Watches the smallest pivot of each factorization. A small one alone is no sign: in a chain of n links it is ~ 1/n^3.
/// It is compared with the largest that the run has seen, and a suspicion that does not hold makes it less suspicious.
class SingularWatch {
 public:
  SingularWatch();
  /// The level before the first factorization: 1 where the first pose is known to be singular.
  void start(double level) { raise(level); }

  /// True for all but few evaluations; then there is nothing to do.
  bool usual(double pivot) {
    if (suspicious(pivot)) return false;
    if (pivot > level_) raise(pivot);
    return true;
  }

  bool suspicious(double pivot) const { return open_ || !(pivot >= suspicious_); }
  /// A small first pivot, before anything is known of what is usual: of a long chain, or of uneven masses, or of a pose
  /// that is nearly singular.
  bool doubts_first(double pivot) const { return level_ == 0.0 && pivot > 0.0 && pivot < doubtful; }
  /// Pivots that are usual and change nothing of what is.
  struct Range {
    double least = INFINITY, most = -INFINITY;
  };
  Range usual_pivots() const { return open_ ? Range() : Range{suspicious_, level_}; }

  /// A pivot seen by the way, for the trend.
  void note(double t, double pivot) {
    samples_[next_sample_++ % samples_.size()] = {t, std::sqrt(std::max(pivot, 0.0))};
  }
  struct Sample {
    double t = 0.0;
    double root = 0.0;  ///< of the smallest pivot: it falls linearly in time toward a singular pose
    void keep(Archive& archive) { archive(t, root); }
  };
  /// The last value, and the one of the last few that is farthest from it in time; none before there are two.
  struct Trend {
    Sample last, other;
  };
  std::optional<Trend> trend() const;
  /// The last value of the trend; none where there is none.
  const Sample* latest() const { return next_sample_ < 2 ? nullptr : &samples_[(next_sample_ - 1) % samples_.size()]; }
  /// The last value at this time or, by less than `within`, near to it.
  std::optional<Sample> sample(double t, double within) const;
  void forget_trend() { next_sample_ = 0; }
  double root_of_level() const { return root_of_level_; }

  bool open() const { return open_; }
  /// Half of the digits of a factorization are lost.
  bool untrustworthy(double pivot) const { return !(pivot >= untrusted_); }
  /// For examine_pose: pivots are squares of the independent parts of rows.
  double near(double pivot) const;

  void suspect_less();
  /// Rows are near each other from here on.
  void begin(double t, double pivot, std::vector<int> joints);
  /// While they are, which may end here.
  void go_on(double pivot);
  /// Whether evaluations with such rows are listed, as those of a user are. The poses of a run, whose evaluations
  /// need not be on the motion, are listed by `cross`.
  void list_evaluations(bool on) { lists_ = on; }
  void change_rows(double t, double pivot, std::vector<int> joints);
  /// Lists a pose that the motion passed.
  void cross(double t, double pivot, std::vector<int> joints);
  void count_fallback() {
    (lists_ && !crossings_.empty() ? crossings_.back().fallback_evaluations : fallback_evaluations_) += 1;
  }

  /// Without what it has listed.
  void keep(Archive& archive) {
    archive(level_, suspicious_, untrusted_, suspicion_, open_, samples_, next_sample_, fallback_evaluations_);
    root_of_level_ = std::sqrt(level_);
  }
  /// What was listed is forgotten, and what comes up to t is not listed: a run is taken once more up to there.
  void silence_until(double t) {
    silent_until_ = t;
    crossings_.clear();
    singular_poses_ = row_changes_ = 0;
  }

  const std::vector<SingularityCrossing>& crossings() const { return crossings_; }  ///< the first ones
  std::int64_t singular_poses() const { return singular_poses_; }                   ///< of all crossings
  std::int64_t row_changes() const { return row_changes_; }

 private:
  void raise(double level);
  void keep(double t, double pivot, std::vector<int> joints, bool rows_changed);

  static constexpr double doubtful = 1e-8;         ///< a first pivot, of which a long chain may have smaller ones
  static constexpr double first_suspicion = 1e-5;  ///< pivots below this part of the level are looked at
  double level_ = 0.0, root_of_level_ = 0.0, suspicious_ = 0.0, untrusted_, suspicion_ = first_suspicion;
  bool open_ = false, lists_ = true;
  std::array<Sample, 32> samples_;
  std::size_t next_sample_ = 0;
  std::int64_t fallback_evaluations_ = 0;  ///< since the last crossing
  double silent_until_ = -INFINITY;
  std::vector<SingularityCrossing> crossings_;
  std::int64_t singular_poses_ = 0, row_changes_ = 0;
};

}  // namespace linkwork
