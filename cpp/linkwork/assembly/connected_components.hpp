#pragma once

#include <vector>

#include "linkwork/assembly/system.hpp"

namespace linkwork {

/// The connected components of the graph of bodies, its edges the joints and inerters between them; the ground connects
/// nothing. Each has equations of its own. With forces between bodies as edges, too, each has a motion of its own,
/// whatever the others do.
class ConnectedComponents {
 public:
  enum class Edges { equations, forces_too };
  explicit ConnectedComponents(const System& system, Edges edges = Edges::equations);
  /// Those of a system are found once.
  static const ConnectedComponents& of(const System& system);

  int count() const { return count_; }
  int of_body(int body) const { return of_body_[body]; }
  int of_row(Eigen::Index row) const { return of_row_[row]; }

 private:
  int count_ = 0;
  std::vector<int> of_body_, of_row_;
};

/// With forces between bodies as edges: the parts of a mechanism, each of which moves and is judged as if it were alone.
class ConnectedParts : public ConnectedComponents {
 public:
  explicit ConnectedParts(const System& system) : ConnectedComponents(system, Edges::forces_too) {}
  /// Those of a system are found once.
  static const ConnectedParts& of(const System& system);

  /// Of an element between these; one may be the ground.
  int of_bodies(int i, int j) const { return of_body(i != ground ? i : j); }
  /// Of a history variable.
  int of_history(const System& system, Eigen::Index variable) const;
};

}  // namespace linkwork
