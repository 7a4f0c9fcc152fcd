#include "linkwork/ensemble/lane_user_forces.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace linkwork {
namespace {

/// One look at a lane in so many evaluations, at other ones in other lanes: at one of eight lanes in each eighth.
constexpr std::uint32_t a_look = 64, between_lanes = 8;

}  // namespace

std::vector<std::string> distrusted_forces(const std::vector<const Model*>& models) {
  std::vector<const UserForce*> found;
  for (const Model* model : models)
    for (const auto& force : model->user_forces())
      if (!force->trusted() && std::find(found.begin(), found.end(), force.get()) == found.end())
        found.push_back(force.get());
  std::vector<std::string> out(models.size());
  for (std::size_t m = 0; m < models.size(); ++m)
    for (std::size_t k = 0; k < models[m]->user_forces().size(); ++k) {
      const UserForce& force = *models[m]->user_forces()[k];
      const auto same = [&](const UserForce* other) { return other == &force || other->goes_with(force); };
      if (std::any_of(found.begin(), found.end(), same))
        out[m] =
            "user force '" + models[m]->user_force_name(k) + "' is another one beside other mechanisms than by itself";
    }
  return out;
}

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
  for (std::size_t l = 0; l < asked_.size(); ++l)
    if (guard.steps(static_cast<int>(l))) asked_[l] += 1;
  for (std::size_t k = 0; k < most_; ++k)
    for (const Group& group : groups_[k]) add(k, group, guard);
}

/// Where it goes wrong together, and now and then where it does not, each lane is asked for by itself: it must not
/// matter to a mechanism which others are there. Where it does, what it has been for all of them may be wrong.
void LaneUserForces::add(std::size_t k, const Group& group, LaneGuard& guard) {
  Group lanes;
  for (const int l : group)
    if (guard.steps(l)) lanes.push_back(l);
  g_.assign(lanes.size() * v_size_, 0.0);
  const bool together = lanes.size() > 1 && ask_together(k, lanes);
  bool distrusted = false;
  for (std::size_t place = 0; place < lanes.size(); ++place) {
    const int l = lanes[place];
    const auto leave = [&](std::string why) { guard.leave(l, places_[l].t, std::move(why)); };
    if (!together) do_apart([&] { ask(k, l, forces(place)); }, leave);
    else if (is_looked_at(l)) do_apart([&] { distrusted = !is_same_alone(k, l, forces(place)) || distrusted; }, leave);
  }
  if (distrusted) distrust(k, lanes, guard);
  for (std::size_t place = 0; place < lanes.size(); ++place) {
    const int l = lanes[place];
    if (!guard.steps(l)) continue;
    const Place& here = places_[l];
    here.at->user = Eigen::Map<const VectorXd>(forces(place), static_cast<Eigen::Index>(v_size_));
    systems_[l]->add_user_force(here.at->user, here.y.segment(systems_[l]->q_size(), systems_[l]->v_size()), *here.at);
  }
}

bool LaneUserForces::is_looked_at(int l) const {
  const std::uint32_t count = asked_[l];
  return std::has_single_bit(count) || (count + between_lanes * static_cast<std::uint32_t>(l)) % a_look == 0;
}

bool LaneUserForces::is_same_alone(std::size_t k, int l, const double* g) {
  ask(k, l, single_.data());
  return std::memcmp(single_.data(), g, v_size_ * sizeof(double)) == 0;
}

void LaneUserForces::distrust(std::size_t k, const Group& lanes, LaneGuard& guard) {
  std::vector<const Model*> models;
  for (const int l : lanes) {
    force(l, k).distrust();
    models.push_back(&systems_[l]->model());
  }
  const std::vector<std::string> reasons = distrusted_forces(models);
  for (std::size_t place = 0; place < lanes.size(); ++place)
    guard.refuse(lanes[place], places_[lanes[place]].t, reasons[place]);
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
