#include "linkwork/integration/state_log.hpp"

#include <algorithm>

#include "linkwork/assembly/system.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_bytes = 1u << 25, most_states = 4096, few_states = 200;
// Of the range of velocities of a body, or an angle [rad], in the mean between states that follow each other; ranges
// below this part of the largest speed are none.
constexpr double far = 0.15, constant = 1e-9;

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
  if (times_.empty()) {
    times_.reserve(most_);
    numbers_.reserve(most_ * row());
  }
  times_.push_back(t);
  numbers_.insert(numbers_.end(), y.data(), y.data() + y_size_);
  numbers_.insert(numbers_.end(), history.data(), history.data() + history_size_);
  if (size() > 1) take_nearer_signs();
}

/// Of Euler parameters: some integrators change them, and what lies between states goes by the numbers.
void StateLog::take_nearer_signs() {
  double* last = numbers_.data() + (size() - 1) * row();
  for (Eigen::Index p = 3; p < position_size * static_cast<Eigen::Index>(bodies_); p += position_size) {
    Eigen::Map<Vec4<double>> own(last + p);
    if (own.dot(Eigen::Map<const Vec4<double>>(last - row() + p)) < 0.0) own = -own;
  }
}

/// The mean, of the body that goes farthest by what its velocity does at all.
double StateLog::distance_between() const {
  const auto velocity = [this](std::size_t k, int body) {
    return y(k).segment<3>(position_size * static_cast<Eigen::Index>(bodies_) + velocity_size * body);
  };
  double sum = 0.0, largest = 0.0;
  std::vector<double> range;
  for (int body = 0; body < bodies_; ++body) {
    Vec3<double> least = velocity(0, body), most = least;
    for (std::size_t k = 1; k < size(); ++k) {
      least = least.cwiseMin(velocity(k, body));
      most = most.cwiseMax(velocity(k, body));
    }
    range.push_back((most - least).norm() / 2.0);
    largest = std::max({largest, least.norm(), most.norm()});
  }
  for (std::size_t k = 1; k < size(); ++k) {
    double farthest = 0.0;
    for (int body = 0; body < bodies_; ++body) {
      const Eigen::Index p = position_size * static_cast<Eigen::Index>(body) + 3;
      farthest = std::max(farthest, 2.0 * (y(k).segment<4>(p) - y(k - 1).segment<4>(p)).norm());
      if (range[static_cast<std::size_t>(body)] > constant * largest)
        farthest = std::max(farthest,
                            (velocity(k, body) - velocity(k - 1, body)).norm() / range[static_cast<std::size_t>(body)]);
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
