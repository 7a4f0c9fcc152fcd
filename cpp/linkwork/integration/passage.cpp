#include "linkwork/integration/passage.hpp"

#include <algorithm>

namespace linkwork {
namespace {

constexpr double away = 0.03;      // [rad] from the pose: branches are apart, and have not bent much
constexpr double other = 0.5;      // of the velocities: those of another branch
constexpr double known = 1e-4;     // of the velocities afterwards: slower ones have few digits
constexpr double resolved = 1e-6;  // of the accelerations: what is beside the velocities

}  // namespace

void Passage::begin(double t, const VectorXd& y, const VectorXd& v, double ahead) {
  if (open()) return;
  begun_ = t_ = t;
  y_ = y;
  v_ = v;
  turned_ = 0.0;
  until_ = away + 2.0 * ahead;
}

bool Passage::left_branch(const VectorXd& v, const VectorXd& v_dot) const {
  if (!(v_.norm() > known * v.norm()) || !(v.norm() > 0.0)) return false;
  const VectorXd along = v.normalized(), beside = v_dot - along * along.dot(v_dot);
  VectorXd rest = v_ - along * along.dot(v_);
  if (beside.norm() > resolved * v_dot.norm()) rest -= beside * (beside.dot(rest) / beside.squaredNorm());
  return rest.norm() > other * v_.norm();
}

bool Passage::differ(const VectorXd& v, const VectorXd& other_v) {
  return !((v - other_v).norm() <= other * std::max(v.norm(), other_v.norm()));
}

}  // namespace linkwork
