#include "linkwork/integration/state_log.hpp"

#include <algorithm>

#include "linkwork/assembly/system.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_bytes = 1u << 25, most_states = 4096, few_states = 200;
// Of the range of velocities of a body, or an angle [rad], between states that follow each other; ranges below this part
// of the largest speed are none.
constexpr double far = 0.15, constant = 1e-9;

Eigen::Index p_of(int body) { return position_size * static_cast<Eigen::Index>(body) + 3; }

}  // namespace

StateLog::StateLog(int bodies, Eigen::Index history_size)
    : bodies_(bodies),
      y_size_((position_size + velocity_size) * static_cast<Eigen::Index>(bodies) + 1),
      history_size_(history_size) {
  const std::size_t affordable = most_bytes / (sizeof(double) * row());
  most_ = affordable < few_states ? 0 : std::min(affordable, most_states);
}

void StateLog::add(double t, const VectorXd& y, const VectorXd& history, bool touches) {
  if (most_ == 0 || ended_) return;
  find_ranges(y);
  waiting_ += 1;
  if (!is_wanted(y, touches)) {
    last_t_ = t;
    last_y_ = y;
    last_history_ = history;
    return;
  }
  if (touches && waiting_ > 1) append(last_t_, last_y_, last_history_, false);
  append(t, y, history, touches);
}

void StateLog::append(double t, const VectorXd& y, const VectorXd& history, bool touches) {
  if (size() == most_) leave_out_some();
  if (ended_) return;
  if (times_.empty()) {
    times_.reserve(most_);
    numbers_.reserve(most_ * row());
  }
  waiting_ = 0;
  times_.push_back(t);
  touches_.push_back(touches);
  numbers_.insert(numbers_.end(), y.data(), y.data() + y_size_);
  numbers_.insert(numbers_.end(), history.data(), history.data() + history_size_);
  if (size() > 1) take_nearer_signs();
}

/// Of Euler parameters: some integrators change them, and what lies between states goes by the numbers.
void StateLog::take_nearer_signs() {
  double* last = numbers_.data() + (size() - 1) * row();
  for (int body = 0; body < bodies_; ++body) {
    Eigen::Map<Vec4<double>> own(last + p_of(body));
    if (own.dot(Eigen::Map<const Vec4<double>>(last - row() + p_of(body))) < 0.0) own = -own;
  }
}

void StateLog::find_ranges(const VectorXd& y) {
  const Eigen::Map<const Eigen::Matrix<double, velocity_size, Eigen::Dynamic>> v(
      y.data() + position_size * static_cast<Eigen::Index>(bodies_), velocity_size, bodies_);
  if (least_velocities_.cols() == 0) least_velocities_ = most_velocities_ = v.topRows<3>();
  least_velocities_ = least_velocities_.cwiseMin(v.topRows<3>());
  most_velocities_ = most_velocities_.cwiseMax(v.topRows<3>());
}

/// Of the body that is farthest by what its velocity does at all.
double StateLog::velocities_apart(const ConstVector& y, const ConstVector& other) const {
  double out = 0.0;
  for (int body = 0; body < bodies_; ++body) {
    const Eigen::Index v = position_size * static_cast<Eigen::Index>(bodies_) + velocity_size * body;
    const double range = (most_velocities_.col(body) - least_velocities_.col(body)).norm() / 2.0;
    const double none = constant * std::max(most_velocities_.col(body).norm(), least_velocities_.col(body).norm());
    if (range > none) out = std::max(out, (y.segment<3>(v) - other.segment<3>(v)).norm() / range);
  }
  return out;
}

double StateLog::angles_apart(const ConstVector& y, const ConstVector& other) const {
  double out = 0.0;
  for (int body = 0; body < bodies_; ++body)
    out = std::max(out, 2.0 * (y.segment<4>(p_of(body)) - other.segment<4>(p_of(body))).norm());
  return out;
}

bool StateLog::is_wanted(const VectorXd& y, bool touches) const {
  if (times_.empty() || waiting_ >= every_ || touches || touches_.back()) return true;
  return velocities_apart(y, this->y(size() - 1)) > far;
}

/// Those while something touches only where else too few would go.
void StateLog::leave_out_some() {
  for (const bool touching : {false, true}) {
    leave_out_between(touching);
    if (4 * size() <= 3 * most_) {
      every_ *= 2;
      return;
    }
  }
  ended_ = true;
}

/// Whether state k is of no use between one before it and the next.
bool StateLog::is_between(std::size_t before, std::size_t k, bool touching) const {
  if (!touching && (touches_[before] || touches_[k] || touches_[k + 1])) return false;
  if (touches_[before] != touches_[k] || touches_[k] != touches_[k + 1]) return false;
  return velocities_apart(y(before), y(k)) <= far && velocities_apart(y(before), y(k + 1)) <= far &&
         angles_apart(y(before), y(k + 1)) <= far;
}

/// Never two that follow each other.
void StateLog::leave_out_between(bool touching) {
  const auto length = static_cast<std::ptrdiff_t>(row());
  std::size_t left = 1;
  bool last_left_out = false;
  for (std::size_t k = 1; k < size(); ++k) {
    last_left_out = !last_left_out && k + 1 < size() && is_between(k - 1, k, touching);
    if (last_left_out) continue;
    times_[left] = times_[k];
    touches_[left] = touches_[k];
    const auto from = numbers_.begin() + static_cast<std::ptrdiff_t>(k) * length;
    if (left < k) std::copy(from, from + length, numbers_.begin() + static_cast<std::ptrdiff_t>(left) * length);
    left += 1;
  }
  times_.resize(left);
  touches_.resize(left);
  numbers_.resize(left * row());
}

}  // namespace linkwork
