#include "linkwork/assembly/mass_ratios.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "linkwork/assembly/connected_components.hpp"
#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

struct Range {
  double least = std::numeric_limits<double>::infinity(), most = 0.0;

  void take(double size) {
    if (size == 0.0) return;
    least = std::min(least, size);
    most = std::max(most, size);
  }
  double ratio() const { return most > 0.0 ? most / least : 1.0; }
};

double inertia_along(const System& system, int force, int body) {
  const ForceKind& kind = force_kinds()[system.model().forces()[static_cast<std::size_t>(force)].kind];
  return kind.info.parameters.front().unit == "kg" ? system.mass(body) : system.inertia(body).diagonal().maxCoeff();
}

}  // namespace

MassRatios::MassRatios(const System& system) {
  const ConnectedComponents& components = ConnectedComponents::of(system);
  std::vector<Range> masses(static_cast<std::size_t>(components.count())), moments = masses;
  for (int body = 0; body < system.body_count(); ++body) {
    const auto component = static_cast<std::size_t>(components.of_body(body));
    masses[component].take(system.mass(body));
    moments[component].take(system.inertia(body).diagonal().maxCoeff());
  }
  for (const Range& it : masses) mass = std::max(mass, it.ratio());
  for (const Range& it : moments) moment = std::max(moment, it.ratio());
  const Inerters& inerters = system.inerters();
  for (std::size_t k = 0; k < inerters.count(); ++k)
    for (const int body : inerters.bodies(k)) {
      const double own = body == ground ? 0.0 : inertia_along(system, inerters.force(k), body);
      if (own > 0.0) inertance = std::max(inertance, inerters.inertance(k) / own);
    }
}

}  // namespace linkwork
