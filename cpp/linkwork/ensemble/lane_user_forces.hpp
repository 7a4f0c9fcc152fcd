#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "linkwork/ensemble/lane_guard.hpp"
#include "linkwork/formulation/dynamics.hpp"

namespace linkwork {

/// Of each mechanism why it cannot have been simulated beside others, in words: it has a force that was found to be
/// another one there, or the same function; empty where it can.
std::vector<std::string> distrusted_forces(const std::vector<const Model*>& models);

/// Forces of the user's own on the mechanisms in lanes: those that can be asked for together are, others lane by lane.
class LaneUserForces {
 public:
  explicit LaneUserForces(const std::vector<Dynamics*>& mechanisms);

  /// Another mechanism in a lane.
  void replace(int l, const Dynamics& mechanism);
  bool none() const { return most_ == 0; }

  /// The state (q, v, ...) of a lane and the evaluation to which its forces are added.
  struct Place {
    double t = 0.0;
    VectorXd y;
    Evaluation* at = nullptr;
  };
  Place& place(int l) { return places_[l]; }
  /// Adds the forces of all lanes that step.
  void add(LaneGuard& guard);

 private:
  using Group = std::vector<int>;

  const UserForce& force(int l, std::size_t k) const { return *systems_[l]->model().user_forces()[k]; }
  void find_groups();
  void add(std::size_t k, const Group& group, LaneGuard& guard);
  bool ask_together(std::size_t k, const Group& lanes);
  bool is_looked_at(int l) const;
  bool is_same_alone(std::size_t k, int l, const double* g);
  void distrust(std::size_t k, const Group& lanes, LaneGuard& guard);
  void ask(std::size_t k, int l, double* g);
  double* forces(std::size_t place) { return g_.data() + place * v_size_; }

  std::vector<const System*> systems_;
  std::vector<Place> places_;
  std::vector<std::vector<Group>> groups_;  ///< of the k-th force of each mechanism
  std::vector<std::uint32_t> asked_;        ///< how often, of each lane that steps
  std::size_t most_ = 0, q_size_, v_size_;
  std::vector<double> t_, q_, v_, g_, single_;
};

}  // namespace linkwork
