#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// States of a run where its steps begin: of each step of a short one, of every so many of a long one, as many as
/// memory allows; up to where that would be too few to tell how the motion goes between them. Of models so large that
/// these would be few, none.
class StateLog {
 public:
  StateLog() = default;
  StateLog(int bodies, Eigen::Index history_size);

  void add(double t, const VectorXd& y, const VectorXd& history);
  void end() { ended_ = true; }  ///< nothing more is added
  std::size_t size() const { return times_.size(); }
  double t(std::size_t k) const { return times_[k]; }
  Eigen::Map<const VectorXd> y(std::size_t k) const { return {numbers_.data() + k * row(), y_size_}; }
  Eigen::Map<const VectorXd> history(std::size_t k) const {
    return {numbers_.data() + k * row() + y_size_, history_size_};
  }

 private:
  std::size_t row() const { return static_cast<std::size_t>(y_size_ + history_size_); }
  void take_nearer_signs();
  double distance_between() const;
  void leave_out_every_other();

  int bodies_ = 0;
  Eigen::Index y_size_ = 0, history_size_ = 0;
  std::size_t most_ = 0;
  bool ended_ = false;
  std::int64_t every_ = 1, steps_ = 0;  ///< steps from one to the next, and so far
  std::vector<double> times_, numbers_;
};

}  // namespace linkwork
