#include "linkwork/ensemble/lane_user_forces.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace linkwork {

LaneUserForces::LaneUserForces(const std::vector<Dynamics*>& mechanisms)
    : places_(mechanisms.size()),
      asked_(mechanisms.size(), 0),
      q_size_(mechanisms.front()->system().q_size()),
      v_size_(mechanisms.front()->system().v_size()),
      single_(v_size_) {
  for (const Dynamics* it : mechanisms) systems_.push_back(&it->system());
  find_groups();
}

void LaneUserForces::replace(int l, const Dynamics& mechanism) {
  systems_[l] = &mechanism.system();
  asked_[l] = 0;
  find_groups();
}

void LaneUserForces::find_groups() {
  most_ = 0;
  for (const System* it : systems_) most_ = std::max(most_, it->model().user_forces().size());
  groups_.assign(most_, {});
  for (std::size_t k = 0; k < most_; ++k)
    for (int l = 0; l < static_cast<int>(systems_.size()); ++l) {
      if (systems_[l]->model().user_forces().size() <= k) continue;
      const auto found = std::find_if(groups_[k].begin(), groups_[k].end(), [&](const Group& group) {
        return force(group.front(), k).goes_with(force(l, k));
      });
      if (found == groups_[k].end()) groups_[k].push_back({l});
      else found->push_back(l);
    }
}

void LaneUserForces::add(LaneGuard& guard) {
  for (std::uint32_t& count : asked_) count += 1;
  for (std::size_t k = 0; k < most_; ++k)
    for (const Group& group : groups_[k]) add(k, group, guard);
}

/// Where it goes wrong together, and now and then where it does not, each lane is asked for by itself: it must not
/// matter to a mechanism which others are there.
void LaneUserForces::add(std::size_t k, const Group& group, LaneGuard& guard) {
  Group lanes;
  for (const int l : group)
    if (guard.steps(l)) lanes.push_back(l);
  g_.assign(lanes.size() * v_size_, 0.0);
  const bool together = lanes.size() > 1 && ask_together(k, lanes);
  for (std::size_t place = 0; place < lanes.size(); ++place) {
    const int l = lanes[place];
    const auto leave = [&](std::string why) { guard.leave(l, places_[l].t, std::move(why)); };
    if (!together) do_apart([&] { ask(k, l, forces(place)); }, leave);
    else if (std::has_single_bit(asked_[l]))
      do_apart(
          [&] {
            ask(k, l, single_.data());
            if (std::memcmp(single_.data(), forces(place), v_size_ * sizeof(double)) != 0)
              guard.refuse(l, places_[l].t,
                           "user force '" + systems_[l]->model().user_force_name(k) +
                               "' is another one beside other mechanisms than by itself");
          },
          leave);
    if (!guard.steps(l)) continue;
    const Place& here = places_[l];
    here.at->user = Eigen::Map<const VectorXd>(forces(place), static_cast<Eigen::Index>(v_size_));
    systems_[l]->add_user_force(here.at->user, here.y.segment(systems_[l]->q_size(), systems_[l]->v_size()), *here.at);
  }
}

/// False where it went wrong.
bool LaneUserForces::ask_together(std::size_t k, const Group& lanes) {
  t_.clear();
  q_.clear();
  v_.clear();
  for (const int l : lanes) {
    const double* y = places_[l].y.data();
    t_.push_back(places_[l].t);
    q_.insert(q_.end(), y, y + q_size_);
    v_.insert(v_.end(), y + q_size_, y + q_size_ + v_size_);
  }
  bool there = true;
  do_apart(
      [&] {
        force(lanes.front(), k)
            .add_to_all(static_cast<int>(lanes.size()), t_.data(), systems_[lanes.front()]->body_count(), q_.data(),
                        v_.data(), g_.data());
      },
      [&](const std::string&) { there = false; });
  return there;
}

void LaneUserForces::ask(std::size_t k, int l, double* g) {
  const Place& here = places_[l];
  std::fill_n(g, v_size_, 0.0);
  force(l, k).add(here.t, systems_[l]->body_count(), here.y.data(), here.y.data() + q_size_, g);
}

}  // namespace linkwork
