#include "linkwork/model/name_table.hpp"

#include <algorithm>
#include <charconv>

#include "linkwork/math/error.hpp"

namespace linkwork {
namespace {

/// k of a name "prefix[k]", or -1.
int number_in(const std::string& name, const std::string& prefix) {
  const std::size_t begin = prefix.size() + 1;
  if (name.size() < begin + 2 || name.compare(0, prefix.size(), prefix) != 0 || name[prefix.size()] != '[') return -1;
  const char* last = name.data() + name.size() - 1;
  int number = -1;
  const auto [end, error] = std::from_chars(name.data() + begin, last, number);
  const bool one = error == std::errc() && end == last && *last == ']';
  return one && name.compare(begin, name.size() - 1 - begin, std::to_string(number)) == 0 ? number : -1;  // no "01"
}

}  // namespace

void NameTable::throw_taken(const std::string& name) const {
  throw ModelError("duplicate_name", std::string(what_) + " '" + name + "' exists already; choose another name");
}

void NameTable::take(const std::string& name) {
  if (name.empty()) throw ModelError("empty_name", std::string(what_) + ": the name is empty; give it one");
  if (name.back() == ']' && find(name) >= 0) throw_taken(name);
  if (!index_.try_emplace(name, static_cast<int>(groups_.size())).second) throw_taken(name);
}

void NameTable::add(const std::string& name) {
  take(name);
  groups_.push_back({.prefix = name, .first = size_, .count = 1, .single = true});
  if (name.back() == ']') bracketed_.push_back(name);
  size_ += 1;
}

void NameTable::add_group(const std::string& prefix, int count) {
  for (const std::string& name : bracketed_)
    if (const int k = number_in(name, prefix); k >= 0 && k < count) throw_taken(name);
  take(prefix);
  groups_.push_back({.prefix = prefix, .first = size_, .count = count, .single = false});
  size_ += count;
}

void NameTable::add(const Names& names, int count) {
  if (names.group()) return add_group(names.prefix(), count);
  if (count > size_) {
    groups_.reserve(groups_.size() + names.each().size());
    index_.reserve(index_.size() + names.each().size());
  }
  const std::size_t groups = groups_.size(), bracketed = bracketed_.size();
  try {
    for (const std::string& name : names.each()) add(name);
  } catch (const ModelError&) {
    forget_from(groups, bracketed);
    throw;
  }
}

void NameTable::forget_from(std::size_t group, std::size_t bracketed) {
  if (group < groups_.size()) size_ = groups_[group].first;
  for (std::size_t k = group; k < groups_.size(); ++k) index_.erase(groups_[k].prefix);
  groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(group), groups_.end());
  bracketed_.resize(bracketed);
}

std::string NameTable::name(int index) const {
  const auto starts_after = [](int value, const Group& group) { return value < group.first; };
  auto group = std::upper_bound(groups_.begin(), groups_.end(), index, starts_after) - 1;
  if (group->single) return group->prefix;
  return group->prefix + "[" + std::to_string(index - group->first) + "]";
}

int NameTable::find(const std::string& name) const {
  if (const auto found = index_.find(name); found != index_.end()) {
    const Group& group = groups_[found->second];
    return group.single ? group.first : -1;
  }
  const std::size_t bracket = name.rfind('[');
  if (bracket == std::string::npos || name.back() != ']') return -1;
  const auto found = index_.find(name.substr(0, bracket));
  if (found == index_.end()) return -1;
  const Group& group = groups_[found->second];
  const int number = group.single ? -1 : number_in(name, group.prefix);
  return number >= 0 && number < group.count ? group.first + number : -1;
}

}  // namespace linkwork
