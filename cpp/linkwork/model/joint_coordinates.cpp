#include "linkwork/model/joint_coordinates.hpp"

#include <cmath>
#include <numbers>

namespace linkwork {
namespace {

using State = BodyState<double>;
using Place = Attachment<double>;

void turn_of_revolute(const Place& at, const State& i, const State& j, Equation<double>& out) {
  angle<double>(i, j, at.x_i(), at.y_i(), at.x_j(), out.rows());
}

void shift(const Place& at, const State& i, const State& j, Equation<double>& out) {
  in_plane<double>(i, j, at.z_i(), at.s_i, at.s_j, out.rows());
}

// Of a Cardan joint, x = z_a x z_b: about z_a turns z_b, which was -y_a; about z_b turns y_b, which was z_a.
void turn_about_a(const Place& at, const State& i, const State& j, Equation<double>& out) {
  const RelativeRotation<double> rotation(i, j);
  Equation<double> s, c;
  rotation.perpendicular(rotation.direction(at.x_i()), at.z_j(), s.rows());
  rotation.perpendicular(rotation.direction(-at.y_i()), at.z_j(), c.rows());
  angle_of<double>(i, j, s, c, out.rows());
}

void turn_about_b(const Place& at, const State& i, const State& j, Equation<double>& out) {
  const RelativeRotation<double> rotation(i, j);
  const auto axis = rotation.direction(at.z_i());
  Equation<double> s, c;
  rotation.perpendicular(axis, at.x_j(), s.rows());
  rotation.perpendicular(axis, at.y_j(), c.rows());
  angle_of<double>(i, j, s, c, out.rows());
}

}  // namespace

constexpr FreeCoordinate turn_about_axis{"angle", "rad", turn_of_revolute};
constexpr FreeCoordinate shift_along_axis{"displacement", "m", shift};
constexpr FreeCoordinate turn_about_axis_a{"angle_a", "rad", turn_about_a};
constexpr FreeCoordinate turn_about_axis_b{"angle_b", "rad", turn_about_b};

const FreeCoordinate* find_coordinate(const KindInfo& kind, const std::string& name) {
  for (const FreeCoordinate* it : kind.coordinates)
    if (it->name == name) return it;
  return nullptr;
}

}  // namespace linkwork
