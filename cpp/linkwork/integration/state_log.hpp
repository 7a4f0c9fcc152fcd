#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "linkwork/math/types.hpp"

namespace linkwork {

/// States of a run where its steps begin: of each step of a short one, of every so many of a long one and beside those
/// where velocities have changed by much, and beside and in contacts and stops; as many as memory allows, up to where that
/// would be too few to tell how the motion goes between them. Of models so large that these would be few, none.
class StateLog {
 public:
  StateLog() = default;
  StateLog(int bodies, Eigen::Index history_size);

  /// `touches`: a contact or a stop is under way.
  void add(double t, const VectorXd& y, const VectorXd& history, bool touches = false);
  void end() { ended_ = true; }  ///< nothing more is added
  std::size_t size() const { return times_.size(); }
  double t(std::size_t k) const { return times_[k]; }
  Eigen::Map<const VectorXd> y(std::size_t k) const { return {numbers_.data() + k * row(), y_size_}; }
  Eigen::Map<const VectorXd> history(std::size_t k) const {
    return {numbers_.data() + k * row() + y_size_, history_size_};
  }
  /// Whether a contact or a stop is under way there or in a state beside it.
  bool touches_about(std::size_t k) const {
    return touches_[k] || (k > 0 && touches_[k - 1]) || (k + 1 < size() && touches_[k + 1]);
  }

 private:
  std::size_t row() const { return static_cast<std::size_t>(y_size_ + history_size_); }
  void append(double t, const VectorXd& y, const VectorXd& history, bool touches);
  void take_nearer_signs();
  void find_ranges(const VectorXd& y);
  double velocities_apart(const ConstVector& y, const ConstVector& other) const;
  double angles_apart(const ConstVector& y, const ConstVector& other) const;
  bool is_wanted(const VectorXd& y, bool touches) const;
  void leave_out_some();
  bool is_between(std::size_t before, std::size_t k, bool touching) const;
  void leave_out_between(bool touching);

  int bodies_ = 0;
  Eigen::Index y_size_ = 0, history_size_ = 0;
  std::size_t most_ = 0;
  bool ended_ = false;
  std::int64_t every_ = 1, waiting_ = 0;                 ///< steps from one to the next at most, and since the last
  Eigen::Matrix3Xd least_velocities_, most_velocities_;  ///< of each body, so far [m/s]
  std::vector<double> times_, numbers_;
  std::vector<bool> touches_;
  double last_t_ = 0.0;  ///< of the last state that was not taken [s]
  VectorXd last_y_, last_history_;
};

}  // namespace linkwork
