#include "linkwork/integration/violation_monitor.hpp"

#include <cmath>

namespace linkwork {
namespace {

constexpr std::size_t most_excesses = 100;

}  // namespace

ViolationMonitor::ViolationMonitor(Dynamics& dynamics)
    : dynamics_(dynamics),
      limits_(dynamics.options().violation_limit),
      limited_(std::isfinite(limits_[0]) || std::isfinite(limits_[1]) || std::isfinite(limits_[2])) {
  if (!limited_) return;
  v_dot_.setZero(dynamics.system().v_size());
  for (VectorXd* rows : {&lambda_, &residual_}) rows->setZero(dynamics.system().row_count());
}

bool ViolationMonitor::exceeded(double t) {
  if (!limited_ || dynamics_.system().row_count() == 0) return false;
  look(0, t, dynamics_.evaluation().Phi);
  look(1, t, dynamics_.evaluation().Phi_dot);
  if (std::isfinite(limits_[2])) {
    dynamics_.accelerations(v_dot_, lambda_);
    dynamics_.acceleration_residual(v_dot_, residual_);
    look(2, t, residual_);
  }
  return open_[0] || open_[1];
}

/// An excess goes on until the violation is below the limit again.
void ViolationMonitor::look(int level, double t, const VectorXd& violation) {
  const auto k = static_cast<std::size_t>(level);
  Eigen::Index row = 0;
  const double largest = violation.cwiseAbs().maxCoeff(&row);
  const bool before = open_[k];
  open_[k] = largest > limits_[k];
  if (!open_[k]) return;
  if (!before) {
    count_ += 1;
    if (excesses_.size() < most_excesses) excesses_.push_back({.level = level, .t = t});
    else excesses_.back() = {level, t, 0.0, 0};
    place_[k] = excesses_.size() - 1;
  }
  Excess& excess = excesses_[place_[k]];
  if (excess.level != level || !(largest > excess.largest)) return;
  excess.largest = largest;
  excess.row = static_cast<int>(row);
}

}  // namespace linkwork
