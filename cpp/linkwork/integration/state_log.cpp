#include "linkwork/integration/state_log.hpp"

#include <algorithm>

#include "linkwork/assembly/system.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_bytes = 1u << 25, most_states = 4096, few_states = 200;
constexpr double far =
    0.15;  // of the largest speed, or an angle [rad], in the mean between states that follow each other

}  // namespace

StateLog::StateLog(int bodies, Eigen::Index history_size)
    : bodies_(bodies),
      y_size_((position_size + velocity_size) * static_cast<Eigen::Index>(bodies) + 1),
      history_size_(history_size) {
  const std::size_t affordable = most_bytes / (sizeof(double) * row());
  most_ = affordable < few_states ? 0 : std::min(affordable, most_states);
}

void StateLog::add(double t, const VectorXd& y, const VectorXd& history) {
  if (most_ == 0 || ended_ || steps_++ % every_ != 0) return;
  if (size() == most_) {
    if (distance_between() > far / 2.0) {
      ended_ = true;
      return;
    }
    leave_out_every_other();
    if ((steps_ - 1) % every_ != 0) return;
  }
  times_.push_back(t);
  numbers_.insert(numbers_.end(), y.data(), y.data() + y_size_);
  numbers_.insert(numbers_.end(), history.data(), history.data() + history_size_);
}

/// The mean, of the body that goes farthest.
double StateLog::distance_between() const {
  const Eigen::Index q_size = position_size * static_cast<Eigen::Index>(bodies_);
  double speed = 0.0, sum = 0.0;
  for (std::size_t k = 0; k < size(); ++k)
    for (int body = 0; body < bodies_; ++body)
      speed = std::max(speed, y(k).segment<3>(q_size + velocity_size * body).norm());
  for (std::size_t k = 1; k < size(); ++k) {
    const Eigen::Map<const VectorXd> a = y(k - 1), b = y(k);
    double farthest = 0.0;
    for (int body = 0; body < bodies_; ++body) {
      const Eigen::Index p = position_size * static_cast<Eigen::Index>(body) + 3, v = q_size + velocity_size * body;
      farthest = std::max(farthest, 2.0 * (b.segment<4>(p) - a.segment<4>(p)).norm());
      if (speed > 0.0) farthest = std::max(farthest, (b.segment<3>(v) - a.segment<3>(v)).norm() / speed);
    }
    sum += farthest;
  }
  return sum / static_cast<double>(size() - 1);
}

void StateLog::leave_out_every_other() {
  const auto length = static_cast<std::ptrdiff_t>(row());
  const std::size_t left = (size() + 1) / 2;
  for (std::size_t k = 1; k < left; ++k) {
    times_[k] = times_[2 * k];
    const auto from = numbers_.begin() + static_cast<std::ptrdiff_t>(2 * k) * length;
    std::copy(from, from + length, numbers_.begin() + static_cast<std::ptrdiff_t>(k) * length);
  }
  times_.resize(left);
  numbers_.resize(left * row());
  every_ *= 2;
}

}  // namespace linkwork
