#include "linkwork/integration/step_groups.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "linkwork/assembly/force_elements.hpp"
#include "linkwork/integration/step_parts.hpp"

namespace linkwork {
namespace {

constexpr std::size_t most_of_group = 20, fewest_of_group = 2, most_of_all = 80;
constexpr int decades = 4;
constexpr double same_time = 1e-13;  // relative

int decade(double share) {
  double limit = 0.1;
  int out = 0;
  for (; share < limit && out + 1 < decades; limit *= 0.1) ++out;
  return out;
}

}  // namespace

StepGroups::StepGroups(int groups, std::size_t most_kept)
    : groups_(static_cast<std::size_t>(std::min(groups, most))),
      most_kept_(std::min(most_kept, std::clamp(most_of_all / std::max(groups_.size(), std::size_t{1}), fewest_of_group,
                                                most_of_group))) {}

KeptStep* StepGroups::take(const std::vector<int>& groups) {
  const auto steps = [this](int group) { return groups_[static_cast<std::size_t>(group)].steps; };
  const int rarest = *std::min_element(groups.begin(), groups.end(), [&](int a, int b) { return steps(a) < steps(b); });
  Group& group = groups_[static_cast<std::size_t>(rarest)];
  // multiples of it are spread evenly, whichever of them are taken
  const double multiple = golden_share * static_cast<double>(group.steps++), place = multiple - std::floor(multiple);
  if (place >= group.share) return nullptr;
  while (group.kept.size() >= most_kept_) {
    group.share *= golden_share;
    std::erase_if(group.kept, [&](const Group::Step& it) { return it.place >= group.share; });
  }
  if (place >= group.share) return nullptr;
  group.kept.push_back({place, {}});
  return &group.kept.back().step;
}

std::vector<RunPart> StepGroups::parts() const {
  std::vector<RunPart> out;
  for (const Group& group : groups_) {
    const auto kept = static_cast<std::int64_t>(group.kept.size());
    for (const Group::Step& it : group.kept) {
      const std::int64_t each = (group.steps - 1) / kept + 1;
      out.push_back({each,
                     it.step.t,
                     static_cast<double>(each) * it.step.h,
                     static_cast<double>(each) * it.step.changes,
                     {},
                     {},
                     it.step,
                     {}});
    }
  }
  return out;
}

std::vector<int> groups_of_breaks(const Model& model, const std::vector<double>& times) {
  struct Claim {
    std::size_t breaks = std::numeric_limits<std::size_t>::max();  ///< of the function
    int signal = -1, decade = 0;
  };
  std::vector<Claim> claims(times.size());
  std::vector<Break> own;
  for (std::size_t signal = 0; signal < model.signals().size(); ++signal) {
    if (!model.signals()[signal]->of_time()) continue;
    own.clear();
    model.signals()[signal]->add_breaks(own);
    for (const Break& it : own) {
      const double slack = same_time * std::abs(it.t);
      for (auto at = std::lower_bound(times.begin(), times.end(), it.t - slack);
           at != times.end() && *at <= it.t + slack; ++at) {
        Claim& claim = claims[static_cast<std::size_t>(at - times.begin())];
        if (own.size() < claim.breaks) claim = {own.size(), static_cast<int>(signal), decade(it.share)};
      }
    }
  }
  std::map<std::pair<int, int>, int> known;
  std::vector<int> out;
  for (const Claim& it : claims) {
    const int next = static_cast<int>(known.size());
    out.push_back(known.emplace(std::pair(it.signal, it.decade), next).first->second % StepGroups::most);
  }
  return out;
}

GroupsOfSwitches GroupsOfSwitches::of(const System& system, const std::vector<int>& elements_with_kinks) {
  GroupsOfSwitches out;
  std::map<int, int> known;
  const auto group = [&](int element) {
    const int next = static_cast<int>(known.size());
    return known.emplace(element, next).first->second % StepGroups::most;
  };
  for (const SwitchOwner& owner : owners_of_switches(system.model())) out.of_switch.push_back(group(owner.element));
  for (const HistoryOwner& owner : system.history_owners())
    out.of_history.push_back(group(owner.joint ? -1 - owner.element : owner.element));
  for (const int element : elements_with_kinks) out.of_kink.push_back(group(element));
  out.count = std::min(static_cast<int>(known.size()), StepGroups::most);
  return out;
}

}  // namespace linkwork
