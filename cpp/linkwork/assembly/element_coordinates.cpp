#include "linkwork/assembly/element_coordinates.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>
#include <utility>

#include "linkwork/model/force_kind.hpp"

namespace linkwork {
namespace {

constexpr std::ptrdiff_t row_size = 2 * velocity_size;

/// Of a force element, or of an inerter: equal for those along one coordinate. Angles know of no points, and distances
/// and shifts of no axes of the second body.
std::string key_of(const Element& element, CoordinateKind kind) {
  const Attachment<double>& at = element.at;
  std::string key;
  const auto append = [&](const auto* first, std::size_t count) {
    key.append(reinterpret_cast<const char*>(first), count * sizeof *first);
  };
  const int whole[] = {static_cast<int>(kind), element.i, element.j};
  append(whole, std::size(whole));
  append(at.C_i.data(), 9);
  if (kind == CoordinateKind::angle) {
    append(at.C_j.data(), 9);
  } else {
    append(at.s_i.data(), 3);
    append(at.s_j.data(), 3);
  }
  return key;
}

/// Of elements along coordinates: the kind of the first, whether others are of another, and the row.
struct SharedCoordinate {
  int kind = -1;
  bool shared = false;
  int row = -1;

  void see(int other) {
    shared = shared || (kind >= 0 && kind != other);
    kind = other;
  }
};
using Coordinates = std::unordered_map<std::string, SharedCoordinate>;

/// Nothing is listed of a model whose elements along coordinates are all of one kind.
Coordinates list_coordinates(const Model& model) {
  SharedCoordinate all;
  for (const Element& it : model.forces())
    if (force_kinds()[it.kind].coordinate) all.see(it.kind);
  Coordinates out;
  if (!all.shared) return out;
  for (const Element& it : model.forces())
    if (const auto& coordinate = force_kinds()[it.kind].coordinate) out[key_of(it, *coordinate)].see(it.kind);
  return out;
}

/// Of each kind whether it is a law all of whose elements share their coordinates with another kind.
std::vector<char> sharing_kinds(const Model& model, const Coordinates& coordinates) {
  std::vector<char> out;
  for (const ForceKind& kind : force_kinds()) out.push_back(kind.coordinate && !kind.inertia);
  for (const Element& it : model.forces())
    if (out[it.kind] && !coordinates.at(key_of(it, *force_kinds()[it.kind].coordinate)).shared) out[it.kind] = 0;
  return out;
}

}  // namespace

ElementCoordinates::ElementCoordinates(const Model& model, const Inerters& inerters, std::ptrdiff_t behind,
                                       const InstructionSet& instructions) {
  const std::vector<Row> all = list_rows(model, inerters);
  const std::size_t others = all.size() - inerters.count();
  D_size_ = row_size * static_cast<std::ptrdiff_t>(others);
  for (std::size_t k = 0; k < inerters.count(); ++k) places_.push_back(inerters.place(k));
  for (std::size_t k = 0; k < others; ++k) places_.push_back(behind + row_size * static_cast<std::ptrdiff_t>(k));
  for (const CoordinateKind kind : {CoordinateKind::length, CoordinateKind::angle, CoordinateKind::displacement})
    for (const bool valued : {false, true}) compile(model, all, kind, valued, instructions);
}

std::vector<ElementCoordinates::Row> ElementCoordinates::list_rows(const Model& model, const Inerters& inerters) {
  std::vector<Row> out;
  for (std::size_t k = 0; k < inerters.count(); ++k) {
    const int force = inerters.force(k);
    out.push_back({force, *force_kinds()[model.forces()[force].kind].coordinate, false});
  }
  Coordinates coordinates = list_coordinates(model);
  if (coordinates.empty()) return out;
  const std::vector<char> sharing = sharing_kinds(model, coordinates);
  for (std::size_t k = 0; k < out.size(); ++k)
    coordinates.at(key_of(model.forces()[out[k].force], out[k].kind)).row = static_cast<int>(k);
  rows_of_forces_.assign(model.forces().size(), -1);
  for (std::size_t force = 0; force < model.forces().size(); ++force) {
    const Element& it = model.forces()[force];
    if (!sharing[it.kind]) continue;
    const ForceKind& kind = force_kinds()[it.kind];
    SharedCoordinate& shared = coordinates.at(key_of(it, *kind.coordinate));
    if (shared.row < 0) {
      shared.row = static_cast<int>(out.size());
      out.push_back({static_cast<int>(force), *kind.coordinate, false});
    }
    out[shared.row].valued = out[shared.row].valued || kind.valued;
    rows_of_forces_[force] = shared.row;
  }
  return out;
}

void ElementCoordinates::compile(const Model& model, const std::vector<Row>& all, CoordinateKind kind, bool valued,
                                 const InstructionSet& instructions) {
  const auto belongs = [&](const Row& it) { return it.kind == kind && it.valued == valued; };
  const auto count = static_cast<int>(std::count_if(all.begin(), all.end(), belongs));
  if (count == 0) return;
  const InstructionSet chosen = evaluation_for(count, instructions);
  Rows rows{kind, valued, coordinate_rows(kind, valued).evaluate[chosen.level], {}};
  rows.batch.reserve(static_cast<std::size_t>(count), 0, chosen.width);
  for (std::size_t row = 0; row < all.size(); ++row) {
    if (!belongs(all[row])) continue;
    const Element& it = model.forces()[all[row].force];
    rows.batch.append(all[row].force, it.i, it.j, nullptr, 0);
    rows.batch.attach(it.at);
    rows.batch.row.push_back(static_cast<int>(row));
    rows.batch.D.push_back(places_[row]);
  }
  rows.batch.fill_up();
  rows_.push_back(std::move(rows));
}

void ElementCoordinates::evaluate(const double* q, const double* v, double* D, double* gamma, double* Phi, double* rate,
                                  ThreadPool& threads) const {
  constexpr int chunk = 4096;  // a multiple of any width
  const ConstraintArrays out{.Phi = Phi, .Phi_t = nullptr, .Phi_dot = rate, .gamma = gamma, .D = D};
  for (const Rows& rows : rows_)
    threads.in_chunks(static_cast<int>(rows.batch.size()), chunk,
                      [&](int first, int last) { rows.evaluate(rows.batch.joints(first, last), q, v, nullptr, out); });
}

}  // namespace linkwork
