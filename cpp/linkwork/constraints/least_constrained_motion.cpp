#include "linkwork/constraints/least_constrained_motion.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <cstdio>

namespace linkwork {
namespace {

constexpr double nothing = 1e-9;  // of a component of a direction

/// Such as (1, 0, 0): of unit length, the largest component positive.
std::string text_of(Vec3<double> direction) {
  direction.normalize();
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  if (direction[largest] < 0.0) direction = -direction;
  std::string out;
  for (const double component : direction) {
    char number[32];
    std::snprintf(number, sizeof number, "%.3g", std::abs(component) > nothing ? component : 0.0);
    out += (out.empty() ? "(" : ", ") + std::string(number);
  }
  return out + ")";
}

}  // namespace

std::string describe_least_constrained_motion(const System& system, const Evaluation& at, int body) {
  const MatrixXd K = system.massless_directions(body);
  MatrixXd held = MatrixXd::Zero(K.cols(), K.cols());  // K^T D^T D K
  for (const int index : system.body_blocks(body)) {
    const MatrixXd DK = block_of(at, system.blocks()[index]) * K;
    held += DK.transpose() * DK;
  }
  const Eigen::JacobiSVD<MatrixXd> svd(held, Eigen::ComputeFullV);
  const VectorXd motion = K * svd.matrixV().rightCols<1>();
  const Vec3<double> translation = motion.head<3>(), rotation = motion.tail<3>();
  if (rotation.norm() > nothing) return "its rotation about " + text_of(rotation) + " in body axes";
  return "its translation along " + text_of(translation);
}

}  // namespace linkwork
