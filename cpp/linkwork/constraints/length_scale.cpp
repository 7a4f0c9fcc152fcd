#include "linkwork/constraints/length_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/math/rotation.hpp"

namespace linkwork {
namespace {

constexpr double at_rest = 1e-12;         // [1/s]: slower, and nothing moves but by roundoff
constexpr double at_rest_beside = 1e-12;  // the same, relative to the fastest part

constexpr double roundoff = 64 * std::numeric_limits<double>::epsilon();
constexpr double least_row = 0.1;  // of natural size 1
constexpr double next_to = 1e-3;   // a center of mass: of the radius of gyration

Vec3<double> point(const Body& body, const Vec3<double>& s) {
  return body.position + rotation_matrix<double>(body.orientation) * s;
}

/// Lengths of the bodies that joints connect, by one of these bodies.
class ConnectedBodies {
 public:
  explicit ConnectedBodies(const System& system)
      : model_(system.model()),
        parent_(system.body_count()),
        arm_(parent_.size(), 0.0),
        way_(arm_),
        reach_(arm_),
        gyration_(parent_.size(), INFINITY) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (int joint = 0; joint < system.joint_count(); ++joint) {
      int last = -1;
      for (const int block : system.joint_blocks(joint)) {
        const int body = system.blocks()[block].body;
        if (last >= 0) parent_[root(body)] = static_cast<int>(root(last));
        last = body;
      }
    }
    for (const Element& joint : model_.joints()) measure(joint);
    for (std::size_t body = 0; body < parent_.size(); ++body) measure(body);
  }

  /// Where joints are at centers of mass, or next to them, the extent of the bodies counts: the least radius of
  /// gyration. Else it does not depend on masses.
  double length(int body) {
    const std::size_t c = root(body);
    const bool extended = gyration_[c] < INFINITY;
    const double least = std::max(roundoff * reach_[c], extended ? next_to * gyration_[c] : 0.0);
    for (const double length : {arm_[c], way_[c]})
      if (length > least) return length;
    return extended ? gyration_[c] : 1.0;
  }

 private:
  std::size_t root(int body) {
    auto k = static_cast<std::size_t>(body);
    while (static_cast<std::size_t>(parent_[k]) != k) k = static_cast<std::size_t>(parent_[k] = parent_[parent_[k]]);
    return k;
  }

  static void keep_largest(double& largest, double x) { largest = std::max(largest, x); }

  void measure(const Element& joint) {
    Vec3<double> ends[2] = {joint.at.s_i, joint.at.s_j};
    const int bodies[2] = {joint.i, joint.j};
    for (int k = 0; k < 2; ++k)
      if (bodies[k] != ground) {
        keep_largest(arm_[root(bodies[k])], ends[k].norm());
        ends[k] = point(model_.bodies()[bodies[k]], ends[k]);
      }
    for (const int body : bodies)
      if (body != ground) keep_largest(way_[root(body)], (ends[0] - ends[1]).norm());
  }

  void measure(std::size_t body) {
    const std::size_t c = root(static_cast<int>(body));
    const Body& own = model_.bodies()[body];
    keep_largest(reach_[c], own.position.norm());
    keep_largest(way_[c], (own.position - model_.bodies()[c].position).norm());
    if (const double J = own.inertia.trace(); own.mass > 0.0 && J > 0.0)
      gyration_[c] = std::min(gyration_[c], std::sqrt(J / (2.0 * own.mass)));
  }

  const Model& model_;
  std::vector<int> parent_;
  std::vector<double> arm_, way_, reach_, gyration_;  ///< of the roots
};

struct CharacteristicLengths {
  VectorXd of_bodies;
};

/// Calls with each body that joints hold, and its distance from the origin, relative to its length.
template <class Note>
void each_distance(const System& system, const ConstVector& q, const Note& note) {
  const VectorXd& lengths = characteristic_lengths(system);
  for (int body = 0; body < system.body_count(); ++body)
    if (const BlockRange blocks = system.body_blocks(body); blocks.begin() != blocks.end())
      note(body, q.segment<3>(position_size * body).norm() / lengths[body]);
}

}  // namespace

const VectorXd& characteristic_lengths(const System& system) {
  return system.kept()
      .get<CharacteristicLengths>([&] {
        look_for_interruption();
        InterruptionMeter meter;
        ConnectedBodies connected(system);
        CharacteristicLengths found{VectorXd(system.body_count())};
        for (int body = 0; body < system.body_count(); ++body) {
          meter.add(1);
          found.of_bodies[body] = connected.length(body);
        }
        return found;
      })
      .of_bodies;
}

void keep_lengths(const System& from, const System& with) {
  const VectorXd& lengths = characteristic_lengths(from);
  with.kept().get<CharacteristicLengths>([&] { return CharacteristicLengths{lengths}; });
}

VectorXd velocity_scale(const System& system) {
  const VectorXd& lengths = characteristic_lengths(system);
  VectorXd scale = VectorXd::Ones(system.v_size());
  for (int body = 0; body < system.body_count(); ++body)
    scale.segment<3>(velocity_size * body).setConstant(lengths[body]);
  return scale;
}

VectorXd row_lengths(const System& system, const Evaluation& at) {
  const VectorXd scale = velocity_scale(system);
  VectorXd squares = VectorXd::Zero(system.row_count());
  for (const ConstraintBlock& block : system.blocks())
    for (int k = 0; k < block.rows; ++k) {
      const Eigen::Map<const Eigen::Matrix<double, velocity_size, 1>> row(at.D.data() + block.offset +
                                                                          velocity_size * k);
      squares[block.row + k] +=
          row.cwiseProduct(scale.segment<velocity_size>(velocity_size * block.body)).squaredNorm();
    }
  VectorXd lengths = squares.cwiseSqrt();
  const std::vector<char> rotations = rows_of_rotations(system, at);
  for (int row = 0; row < system.row_count(); ++row) {
    if (rotations[row]) lengths[row] = std::max(lengths[row], least_row);
    else if (!(lengths[row] > 0.0)) lengths[row] = 1.0;
  }
  return lengths;
}

std::vector<char> rows_of_rotations(const System& system, const Evaluation& at) {
  std::vector<char> out(system.row_count(), 1);
  for (const ConstraintBlock& block : system.blocks()) {
    const bool special = system.model().special_joint(block.joint) != nullptr;
    for (int k = 0; k < block.rows; ++k) {
      const double* row = at.D.data() + block.offset + velocity_size * k;
      if (special || row[0] != 0.0 || row[1] != 0.0 || row[2] != 0.0) out[block.row + k] = 0;
    }
  }
  return out;
}

// Without the parts, which are as large as the model.
double farthest_position(const System& system, const ConstVector& q) {
  double most = 0.0;
  each_distance(system, q, [&](int, double distance) { most = std::max(most, distance); });
  return most;
}

double roundoff_of_positions(const System& system, const ConstVector& q) {
  return roundoff * farthest_position(system, q);
}

VectorXd roundoff_of_parts(const System& system, const ConstVector& q) {
  const ConnectedParts& parts = ConnectedParts::of(system);
  VectorXd out = VectorXd::Zero(parts.count());
  each_distance(system, q, [&](int body, double distance) {
    double& own = out[parts.of_body(body)];
    own = std::max(own, roundoff * distance);
  });
  return out;
}

VectorXd characteristic_rates(const System& system, const Evaluation& at, const ConstVector& v) {
  const VectorXd& lengths = characteristic_lengths(system);
  const ConnectedParts& parts = ConnectedParts::of(system);
  VectorXd out = VectorXd::Constant(parts.count(), at_rest), force = VectorXd::Zero(parts.count()), inertia = force;
  for (int body = 0; body < system.body_count(); ++body) {
    const auto own = v.segment<velocity_size>(velocity_size * body);
    const int part = parts.of_body(body);
    out[part] = std::max({out[part], own.head<3>().norm() / lengths[body], own.tail<3>().norm()});
    const auto load = at.g.segment<velocity_size>(velocity_size * body);
    force[part] += load.head<3>().norm() + load.tail<3>().norm() / lengths[body];
    inertia[part] += system.mass(body) * lengths[body] + system.inertia(body).trace() / (2.0 * lengths[body]);
  }
  const VectorXd rows = at.Phi_t.size() > 0 ? row_lengths(system, at) : VectorXd();
  for (Eigen::Index row = 0; row < rows.size(); ++row) {
    double& rate = out[parts.of_row(row)];
    rate = std::max({rate, std::abs(at.Phi_t[row]) / rows[row], std::sqrt(std::abs(at.gamma[row]) / rows[row])});
  }
  for (Eigen::Index part = 0; part < out.size(); ++part)
    if (inertia[part] > 0.0) out[part] = std::max(out[part], std::sqrt(force[part] / inertia[part]));
  return out.cwiseMax(at_rest_beside * (out.size() > 0 ? out.maxCoeff() : 0.0));
}

}  // namespace linkwork
