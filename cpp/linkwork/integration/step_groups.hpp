#pragma once

#include <cstdint>
#include <vector>

#include "linkwork/assembly/system.hpp"
#include "linkwork/integration/kept_step.hpp"

namespace linkwork {

/// Steps in which something happens that others say nothing of: a break, a contact or a stop that begins or ends, the
/// kink of a characteristic. They are grouped by what happens there, and some of each group are kept, spread over all
/// of them: a rare blow is not lost among many slight ones, nor does it stand for them. A step of several groups
/// belongs to the one that was rarest so far.
class StepGroups {
 public:
  static constexpr int most = 32;  ///< further ones share these

  /// At most so many kept steps of each group.
  StepGroups() = default;
  StepGroups(int groups, std::size_t most_kept);

  /// Where the step of these groups is to be kept; null: it is not.
  KeptStep* take(const std::vector<int>& groups);
  /// A part of the run of its own for each that was kept.
  std::vector<RunPart> parts() const;

 private:
  struct Group {
    std::int64_t steps = 0;
    double share = 1.0;  ///< of those steps that are kept, and where each stands in their order:
    struct Step {
      double place;
      KeptStep step;
    };
    std::vector<Step> kept;
  };

  std::vector<Group> groups_;
  std::size_t most_kept_ = 0;
};

/// The group of each of these times, ascending [s]: by the function that breaks there, the one with the fewest breaks,
/// and the decade of its jump, in relation to its largest. Times of functions that nobody knows are one group.
std::vector<int> groups_of_breaks(const Model& model, const std::vector<double>& times);

/// By force elements.
struct GroupsOfSwitches {
  int count = 0;
  /// Of each in Evaluation::switches, of each history variable, of each of these elements.
  std::vector<int> of_switch, of_history, of_kink;

  static GroupsOfSwitches of(const System& system, const std::vector<int>& elements_with_kinks);
};

}  // namespace linkwork
