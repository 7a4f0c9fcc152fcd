#include "linkwork/integration/log_smoothness.hpp"

#include <algorithm>

#include "linkwork/integration/state_interpolation.hpp"

namespace linkwork {
namespace {

// By how much the cubic may be off: of velocities; of accelerations, relative to the mean of all between; of the largest
// velocity of all, which is none.
constexpr double of_velocity = 0.03, of_acceleration = 0.3, none = 1e-12;
constexpr std::size_t most_pieces = 16;  // in which accelerations are looked at

/// What the next term of velocities would be, which the fifth degree has.
double next_in_velocities(double share) { return share * (1.0 - share) * (1.0 - 2.0 * share); }

}  // namespace

LogSmoothness::LogSmoothness(const System& system, const StateLog& log, const MovingAxes& axes, const VectorXd& lengths,
                             const VectorXd& speeds)
    : system_(system),
      connected_(ConnectedParts::of(system)),
      log_(log),
      axes_(axes),
      lengths_(lengths),
      speeds_(speeds) {}

VectorXd LogSmoothness::velocities(std::size_t k) const {
  return log_.y(k).segment(system_.q_size(), system_.v_size());
}

double LogSmoothness::share(std::size_t k, std::size_t between, std::size_t end) const {
  return (log_.t(between) - log_.t(k)) / (log_.t(end) - log_.t(k));
}

double LogSmoothness::size(int body, const VectorXd& velocity, const Vec3<double>& less) const {
  const Eigen::Index v = velocity_size * static_cast<Eigen::Index>(body);
  const double turning = lengths_[connected_.of_body(body)] * velocity.segment<3>(v + 3).norm();
  return std::max((velocity.segment<3>(v) - less).norm(), turning);
}

bool LogSmoothness::halfway(std::size_t k, std::size_t end) const {
  const std::size_t middle = k + (end - k) / 2;
  if (middle == k) return true;
  const VectorXd first = velocities(k), there = velocities(middle), last = velocities(end);
  const CubicVelocities cubic(system_, log_.y(k), log_.y(end), log_.t(end) - log_.t(k));
  const VectorXd off = cubic.at(share(k, middle, end)) - there;
  for (int body = 0; body < system_.body_count(); ++body) {
    const int part = connected_.of_body(body);
    const Vec3<double> whole = axes_.part.empty() ? Vec3<double>::Zero() : Vec3<double>(axes_.velocity.col(part));
    const double largest = std::max({size(body, first, whole), size(body, there, whole), size(body, last, whole)});
    if (size(body, off) > of_velocity * largest + none * (speeds_[part] + whole.norm())) return false;
  }
  return true;
}

bool LogSmoothness::everywhere(std::size_t k, std::size_t end) const {
  const std::size_t pieces = std::min(end - k, most_pieces);
  if (pieces < 2) return true;
  const CubicVelocities cubic(system_, log_.y(k), log_.y(end), log_.t(end) - log_.t(k));
  const auto place = [&](std::size_t piece) { return k + (end - k) * piece / pieces; };
  VectorXd path = VectorXd::Zero(system_.body_count());
  MatrixXd off(system_.v_size(), static_cast<Eigen::Index>(pieces));
  VectorXd shares(off.cols()), bends(off.cols());
  for (Eigen::Index piece = 0; piece < off.cols(); ++piece) {
    const std::size_t from = place(static_cast<std::size_t>(piece)), to = place(static_cast<std::size_t>(piece) + 1);
    const double before = share(k, from, end), after = share(k, to, end);
    const VectorXd change = velocities(to) - velocities(from);
    off.col(piece) = cubic.at(after) - cubic.at(before) - change;
    shares[piece] = after - before;
    bends[piece] = next_in_velocities(after) - next_in_velocities(before);
    for (int body = 0; body < system_.body_count(); ++body) path[body] += size(body, change);
  }
  if (pieces > 3) off -= off * bends * bends.transpose() / bends.squaredNorm();
  for (Eigen::Index piece = 0; piece < off.cols(); ++piece)
    for (int body = 0; body < system_.body_count(); ++body)
      if (size(body, off.col(piece)) >
          of_acceleration * shares[piece] * path[body] + none * speeds_[connected_.of_body(body)])
        return false;
  return true;
}

}  // namespace linkwork
