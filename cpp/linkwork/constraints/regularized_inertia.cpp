#include "linkwork/constraints/regularized_inertia.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "linkwork/linear/block/kept_orders.hpp"

namespace linkwork {
namespace {

// Relative to the inertia of the body's other motions.
constexpr double fill = 1e-5;       // what is added to moments: roundoff of 1e-10, and as few refinements
constexpr double small = 1e-3;      // moments whose roundoff shows in any solution
constexpr double roundoff = 4e-13;  // tolerance times moment from which on it shows in that tolerance
constexpr double of_interest = 0.1;
constexpr double felt = 1e-6;        // part of a row of D
constexpr double massless = 1e-14;   // as in System
constexpr double rounded = 1.5e-14;  // of positions

/// Mass and inertia that are typical of a body, though some of its own may vanish: m l^2 counts as inertia and J / l^2
/// as mass, with l the longest way from its center of mass to a joint.
class NaturalSizes {
 public:
  explicit NaturalSizes(const System& system) : system_(system) {
    const auto n = static_cast<std::size_t>(system.body_count());
    arm_.assign(n, 0.0);
    for (const Element& joint : system.model().joints()) {
      if (joint.i != ground) longer(joint.i, joint.at.s_i.norm());
      if (joint.j != ground) longer(joint.j, joint.at.s_j.norm());
    }
    mass_.resize(n);
    inertia_.resize(n);
    for (int body = 0; body < system.body_count(); ++body) {
      const auto k = static_cast<std::size_t>(body);
      const double m = system.mass(body), J = system.inertia(body).diagonal().maxCoeff(), l2 = squared_arm(body);
      inertia_[k] = std::max(J, m * l2);
      mass_[k] = m > 0.0 || l2 == 0.0 ? m : J / l2;
    }
    take_from_neighbors(mass_);
    take_from_neighbors(inertia_);
  }

  double mass(int body) const { return mass_[body]; }
  double inertia(int body) const { return inertia_[body]; }
  double length(int body) const { return std::sqrt(inertia(body) / mass(body)); }

 private:
  void longer(int body, double arm) {
    double& longest = arm_[body];
    longest = std::max(longest, arm);
  }

  /// None where the joints are at the center of mass but for what positions are rounded to.
  double squared_arm(int body) const {
    const double arm = arm_[static_cast<std::size_t>(body)];
    return arm > rounded * system_.model().bodies()[body].position.norm() ? arm * arm : 0.0;
  }

  /// Bodies that have none take the mean of those that they are joined to, else of all.
  void take_from_neighbors(std::vector<double>& sizes) const {
    if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size > 0.0; })) return;
    const std::vector<double> own = sizes;
    double sum_of_all = 0.0, count_of_all = 0.0;
    for (const double size : own) {
      sum_of_all += size;
      count_of_all += size > 0.0 ? 1.0 : 0.0;
    }
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (sizes[k] > 0.0) continue;
      double sum = 0.0, count = 0.0;
      for (const int block : system_.body_blocks(static_cast<int>(k)))
        for (const int other : system_.joint_blocks(system_.blocks()[block].joint)) {
          const double size = own[system_.blocks()[other].body];
          sum += size;
          count += size > 0.0 ? 1.0 : 0.0;
        }
      sizes[k] = count > 0.0 ? sum / count : count_of_all > 0.0 ? sum_of_all / count_of_all : 1.0;
    }
  }

  const System& system_;
  std::vector<double> arm_, mass_, inertia_;
};

using Directions = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;

/// Of the rotations spanned by orthonormal directions V, those that the joints of the body feel.
Directions felt_by_joints(const System& system, const Evaluation& typical, int body, const Directions& V) {
  if (V.cols() == 0) return V;
  Mat3<double> all = Mat3<double>::Zero();
  for (const int index : system.body_blocks(body)) {
    const ConstraintBlock& block = system.blocks()[index];
    for (int k = 0; k < block.rows; ++k) {
      const Eigen::Map<const Vec3<double>> row(typical.D.data() + block.offset + 6 * k + 3);
      if (const double length = row.norm(); length > 0.0) all += row * row.transpose() / (length * length);
    }
  }
  const MatrixXd squares = V.transpose() * all * V;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(squares);
  Directions out(3, 0);
  for (Eigen::Index k = 0; k < squares.rows(); ++k)
    if (eigen.eigenvalues()[k] > felt * felt) {
      out.conservativeResize(3, out.cols() + 1);
      out.rightCols<1>() = V * eigen.eigenvectors().col(k);
    }
  return out;
}

/// The principal axes with moments below a bound.
Directions axes_below(const Eigen::SelfAdjointEigenSolver<Mat3<double>>& eigen, double bound) {
  const auto count = (eigen.eigenvalues().array() < bound).count();  // ascending
  return eigen.eigenvectors().leftCols(count);
}

/// The smallest moment that joints feel, and what is to be added to the inertia.
struct AddedInertia {
  double smallest = 1.0;
  Mat3<double> inertia = Mat3<double>::Zero();
};

/// What vanishes is regularized in any case, what is tiny where joints feel it: else nothing comes of it, and a
/// rotation that its own inertia decides keeps it.
AddedInertia added_inertia(const System& system, const Evaluation& typical, int body, double natural) {
  const Mat3<double> J = system.inertia(body);
  AddedInertia out;
  if (J.isDiagonal(0.0) && J.diagonal().minCoeff() >= of_interest * natural) return out;
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> eigen(J);
  const Directions small_ones = felt_by_joints(system, typical, body, axes_below(eigen, of_interest * natural));
  for (Eigen::Index k = 0; k < small_ones.cols(); ++k)
    out.smallest = std::min(out.smallest, small_ones.col(k).dot(J * small_ones.col(k)) / natural);
  Directions tiny = axes_below(eigen, fill * natural);
  if (eigen.eigenvalues()[0] > massless * natural) tiny = felt_by_joints(system, typical, body, tiny);
  else out.smallest = 0.0;
  out.inertia = fill * natural * tiny * tiny.transpose();
  return out;
}

}  // namespace

RegularizedInertia::RegularizedInertia(const System& system, const Evaluation& typical) : given_(&system) {
  const NaturalSizes natural(system);
  lengths_.resize(system.body_count());
  std::vector<Body> bodies;
  for (int body = 0; body < system.body_count(); ++body) {
    lengths_[body] = natural.length(body);
    const bool no_mass = system.mass(body) == 0.0;
    const AddedInertia added = added_inertia(system, typical, body, natural.inertia(body));
    smallest_ = no_mass ? 0.0 : std::min(smallest_, added.smallest);
    if (!no_mass && added.inertia.isZero(0.0)) continue;
    changed_.push_back(body);
    if (bodies.empty()) bodies = system.model().bodies();
    Body& own = bodies[body];
    own.inertia += added.inertia;
    if (no_mass) own.mass += fill * natural.mass(body);
  }
  if (bodies.empty()) return;
  regularized_ = std::make_unique<System>(system.model().with_masses(bodies));
  regularized_->use(system.shared_threads());
  block::share_orders(system, *regularized_);
}

bool RegularizedInertia::shows(double accuracy) const { return smallest_ < small || smallest_ * accuracy < roundoff; }

}  // namespace linkwork
