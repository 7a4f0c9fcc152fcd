#include "linkwork/linear/block/eliminated_rows.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace linkwork::block {
namespace {

constexpr int none = -1;
constexpr int most_rows = 6;  // of a joint of an open branch; see TreeStep

}  // namespace

EliminatedRows::EliminatedRows(const System& system, const std::vector<int>& dropped, int compliant_from)
    : system_(system), dropped_(system.row_count(), 0), host_(system.joint_count()), next_(system.joint_count(), none) {
  for (const int row : dropped) dropped_[row] = 1;
  const std::vector<int>& first = system.model().joint_rows();
  const auto begin = dropped_.begin();
  for (int joint = 0; joint < system.joint_count(); ++joint) {
    all_rows_.push_back(first[joint + 1] - first[joint]);
    count_.push_back(static_cast<int>(std::count(begin + first[joint], begin + first[joint + 1], 0)));
  }
  std::iota(host_.begin(), host_.end(), 0);
  for (int joint = 0; joint < system.joint_count(); ++joint)
    if (first[joint] >= compliant_from) attach(joint);
}

void EliminatedRows::attach(int joint) {
  const int host = find_host(joint);
  if (host == none) return;
  int last = host;
  while (next_[last] != none) last = next_[last];
  next_[last] = joint;
  host_[joint] = host;
  count_[host] += std::exchange(count_[joint], 0);
  all_rows_[host] += all_rows_[joint];
}

/// None of a special joint.
const JointKind* EliminatedRows::kind(int joint) const {
  const Model& model = system_.model();
  return model.special_joint(joint) ? nullptr : &joint_kinds()[model.joints()[joint].kind];
}

bool EliminatedRows::turning(int joint) const {
  const JointKind* found = kind(joint);
  return found && found->info.rows >= 5 && found->holds_point;
}

bool EliminatedRows::slides(int joint) const {
  const JointKind* found = kind(joint);
  return found && found->slides;
}

/// Among those before it, on the body with the fewest: the other one may have very many.
int EliminatedRows::find_host(int joint) const {
  const auto size = [](const BlockRange& blocks) { return blocks.end() - blocks.begin(); };
  const BlockRange own = system_.joint_blocks(joint);
  BlockRange fewest{nullptr, nullptr};
  for (const int index : own) {
    const BlockRange blocks = system_.body_blocks(system_.blocks()[index].body);
    if (fewest.first == nullptr || size(blocks) < size(fewest)) fewest = blocks;
  }
  for (const int index : fewest) {
    const int other = system_.blocks()[index].joint;
    const bool fits = count_[other] > 0 && all_rows_[other] + all_rows_[joint] <= most_rows;
    if (other < joint && !is_attached(other) && fits && same_bodies(joint, other)) return other;
  }
  return none;
}

bool EliminatedRows::same_bodies(int joint, int other) const {
  const auto body = [&](int index) { return system_.blocks()[index].body; };
  const BlockRange a = system_.joint_blocks(joint), b = system_.joint_blocks(other);
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(),
                             [&](int one, int two) { return body(one) == body(two); });
}

}  // namespace linkwork::block
