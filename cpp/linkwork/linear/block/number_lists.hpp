#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace linkwork::block {

/// Lists of numbers, one behind the other.
class NumberLists {
 public:
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const int> operator[](std::size_t k) const {
    return {numbers_.data() + begin_[k], static_cast<std::size_t>(begin_[k + 1] - begin_[k])};
  }
  std::span<const int> back() const { return (*this)[size() - 1]; }
  const std::vector<int>& begins() const { return begin_; }  ///< of the lists in all numbers, and their end
  const std::vector<int>& numbers() const { return numbers_; }
  bool operator==(const NumberLists&) const = default;

  void reserve(std::size_t lists, std::size_t numbers) {
    begin_.reserve(lists + 1);
    numbers_.reserve(numbers);
  }
  void add(std::span<const int> list) {
    numbers_.insert(numbers_.end(), list.begin(), list.end());
    begin_.push_back(static_cast<int>(numbers_.size()));
  }

 private:
  std::vector<int> begin_{0}, numbers_;
};

}  // namespace linkwork::block
