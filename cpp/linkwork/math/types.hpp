#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace linkwork {

template <class Real>
using Vec3 = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Vec4 = Eigen::Matrix<Real, 4, 1>;
template <class Real>
using Mat3 = Eigen::Matrix<Real, 3, 3>;

using VectorXd = Eigen::VectorXd;
using MatrixXd = Eigen::MatrixXd;

/// Read-only view of a vector held elsewhere.
using ConstVector = Eigen::Ref<const Eigen::VectorXd>;
/// Writable view of a vector held elsewhere.
using MutableVector = Eigen::Ref<Eigen::VectorXd>;

constexpr int position_size = 7;  ///< entries of q per body: r (3), p (4)
constexpr int velocity_size = 6;  ///< entries of v per body: r_dot (3), omega (3)

}  // namespace linkwork
