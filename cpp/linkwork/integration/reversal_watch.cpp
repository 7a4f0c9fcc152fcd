#include "linkwork/integration/reversal_watch.hpp"

#include <optional>
#include <string>

#include "linkwork/math/rotation.hpp"
#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

/// Of an element by its name; null: it has none.
const Parameter* parameter(const Model& model, const Element& it, const std::string& name) {
  const std::vector<ParameterInfo>& parameters = force_kinds()[it.kind].info.parameters;
  for (std::size_t p = 0; p < parameters.size(); ++p)
    if (parameters[p].name == name) return &model.force_parameters()[it.first_parameter + p];
  return nullptr;
}

bool acts(const Parameter* friction) { return friction && (friction->signal >= 0 || friction->constant > 0.0); }

/// A body, or the ground, as far as rates ask for it.
struct Moving {
  Mat3<double> A = Mat3<double>::Identity();
  Vec3<double> r = Vec3<double>::Zero(), r_dot = r, omega = r;  ///< omega in space

  Moving(int body, const VectorXd& y, Eigen::Index q_size) {
    if (body == ground) return;
    const Eigen::Index q = position_size * static_cast<Eigen::Index>(body);
    const Eigen::Index v = q_size + velocity_size * static_cast<Eigen::Index>(body);
    A = rotation_matrix<double>(y.segment<4>(q + 3));
    r = y.segment<3>(q);
    r_dot = y.segment<3>(v);
    omega = A * y.segment<3>(v + 3);
  }
};

}  // namespace

ReversalWatch::ReversalWatch(const System& system) : q_size_(system.q_size()) {
  const Model& model = system.model();
  for (int element = 0; element < static_cast<int>(model.forces().size()); ++element) {
    const Element& it = model.forces()[static_cast<std::size_t>(element)];
    const std::optional<CoordinateKind> along = force_kinds()[it.kind].coordinate;
    const Parameter* transition = parameter(model, it, "transition");
    if (!along || !transition || !acts(parameter(model, it, "coulomb"))) continue;
    watched_.push_back({it.i, it.j, it.at, *along == CoordinateKind::angle, transition->constant});
    elements_.push_back(element);
  }
}

// z . (omega_j - omega_i); of a shift z . (P_j - P_i): z . (P_j_dot - P_i_dot) + (omega_i x z) . (P_j - P_i)
double ReversalWatch::rate(const Watched& it, const VectorXd& y) const {
  const Moving i(it.i, y, q_size_), j(it.j, y, q_size_);
  const Vec3<double> z = i.A * it.at.z_i();
  if (it.turns) return z.dot(j.omega - i.omega);
  const Vec3<double> to_i = i.A * it.at.s_i, to_j = j.A * it.at.s_j;
  const Vec3<double> apart = j.r + to_j - i.r - to_i;
  const Vec3<double> rates = j.r_dot + j.omega.cross(to_j) - i.r_dot - i.omega.cross(to_i);
  return z.dot(rates) + i.omega.cross(z).dot(apart);
}

const std::vector<int>& ReversalWatch::directions(const VectorXd& y) {
  directions_.clear();
  for (const Watched& it : watched_) {
    const double speed = rate(it, y);
    directions_.push_back(speed > it.transition ? 1 : speed < -it.transition ? -1 : 0);
  }
  return directions_;
}

}  // namespace linkwork
