#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// Joints with friction that grips at once where the direction of motion changes: force elements along a coordinate with
/// a speed of transition.
class ReversalWatch {
 public:
  explicit ReversalWatch(const System& system);

  bool empty() const { return watched_.empty(); }
  /// Those force elements, of those in Model::forces().
  const std::vector<int>& elements() const { return elements_; }
  /// Of each: 1 or -1 where it slides to and fro, 0 below the speed of transition.
  const std::vector<int>& directions(const VectorXd& y);

 private:
  struct Watched {
    int i, j;
    Attachment<double> at;
    bool turns;
    double transition;  ///< [rad/s or m/s]
  };
  double rate(const Watched& it, const VectorXd& y) const;

  Eigen::Index q_size_;
  std::vector<Watched> watched_;
  std::vector<int> elements_, directions_;
};

}  // namespace linkwork
