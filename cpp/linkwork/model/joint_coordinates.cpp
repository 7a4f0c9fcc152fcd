#include "linkwork/model/joint_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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
  Equation<double> s, c;
  perpendicular<double>(i, j, at.x_i(), at.z_j(), s.rows());
  perpendicular<double>(i, j, -at.y_i(), at.z_j(), c.rows());
  angle_of<double>(i, j, s, c, out.rows());
}

void turn_about_b(const Place& at, const State& i, const State& j, Equation<double>& out) {
  Equation<double> s, c;
  perpendicular<double>(i, j, at.z_i(), at.x_j(), s.rows());
  perpendicular<double>(i, j, at.z_i(), at.y_j(), c.rows());
  angle_of<double>(i, j, s, c, out.rows());
}

constexpr FreeCoordinate coordinates[] = {{"angle", true, turn_of_revolute},
                                          {"displacement", false, shift},
                                          {"angle_a", true, turn_about_a},
                                          {"angle_b", true, turn_about_b}};

}  // namespace

const FreeCoordinate* find_coordinate(const KindInfo& kind, const std::string& name) {
  if (std::find(kind.coordinates.begin(), kind.coordinates.end(), name) == kind.coordinates.end()) return nullptr;
  const auto found =
      std::find_if(std::begin(coordinates), std::end(coordinates), [&](const auto& it) { return it.name == name; });
  return found == std::end(coordinates) ? nullptr : found;
}

double continued(double angle, double last) {
  constexpr double turn = 2.0 * std::numbers::pi;
  return angle + turn * std::round((last - angle) / turn);
}

}  // namespace linkwork
