#pragma once

#include <string>

namespace linkwork {

/// Who takes the steps of lanes, and hears of each what a run by itself would watch.
class LaneGuard {
 public:
  virtual ~LaneGuard() = default;

  /// What lane l makes is of interest.
  virtual bool steps(int l) const = 0;
  /// The first stage of the step that comes was looked at ahead, and is factorized there already.
  virtual bool looked(int l) const = 0;
  /// The smallest pivot of a stage at t.
  virtual void note(int l, double t, double pivot, bool first_stage) = 0;
  /// It meets what lanes cannot do.
  virtual void leave(int l, double t, std::string reason) = 0;
};

}  // namespace linkwork
