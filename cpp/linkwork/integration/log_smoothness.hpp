#pragma once

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/integration/moving_axes.hpp"
#include "linkwork/integration/state_log.hpp"

namespace linkwork {

/// Whether a run goes from one state of its log to another, not the next one, as what is interpolated between the two
/// does.
class LogSmoothness {
 public:
  /// `lengths`, `speeds`: by which poses and velocities of each of ConnectedParts count, seen from its axes [m, m/s].
  LogSmoothness(const System& system, const StateLog& log, const MovingAxes& axes, const VectorXd& lengths,
                const VectorXd& speeds);

  /// By velocities halfway: what is small beside what comes later counts by its own size.
  bool halfway(std::size_t k, std::size_t end) const;
  /// By accelerations everywhere: a stop may have been there for a while.
  bool everywhere(std::size_t k, std::size_t end) const;

 private:
  VectorXd velocities(std::size_t k) const;
  double share(std::size_t k, std::size_t between, std::size_t end) const;
  double size(int body, const VectorXd& velocity, const Vec3<double>& less = Vec3<double>::Zero()) const;

  const System& system_;
  const ConnectedParts& connected_;
  const StateLog& log_;
  const MovingAxes& axes_;
  const VectorXd &lengths_, &speeds_;
};

}  // namespace linkwork
