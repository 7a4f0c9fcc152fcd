#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "linkwork/math/error.hpp"
#include "linkwork/math/interruption.hpp"
#include "linkwork/math/types.hpp"

namespace linkwork {

/// Takes the state of objects bit by bit, and gives it back: each class has one function for both,
///   void keep(Archive& archive) { archive(a_, b_); }
/// so that what is written and what is read cannot differ. For the machine that wrote it.
class Archive {
 public:
  Archive() = default;                                                          ///< writes
  explicit Archive(std::string_view bytes) : unread_(bytes), reading_(true) {}  ///< reads, from what stays there

  bool reading() const { return reading_; }

  template <class... Values>
  void operator()(Values&... values) {
    (keep(values), ...);
  }

  std::string take() { return std::move(written_); }
  /// OptionError: something is left to be read.
  void finish() const {
    if (!unread_.empty()) throw_damaged();
  }

 private:
  [[noreturn]] static void throw_damaged() {
    throw OptionError("start",
                      "start: what it has to go on from is damaged: leave it out (start._replace(resume=None))");
  }

  void bytes(void* values, std::size_t count) {
    if (count > long_bytes) look_for_interruption();
    if (!reading_) {
      written_.append(static_cast<const char*>(values), count);
      return;
    }
    if (count > unread_.size()) throw_damaged();
    if (count > 0) std::memcpy(values, unread_.data(), count);
    unread_.remove_prefix(count);
  }

  /// Of so many values, or of those that are there; a count that cannot be is none of ours.
  std::size_t count(std::size_t present, std::size_t least_bytes) {
    auto number = static_cast<std::uint64_t>(present);
    bytes(&number, sizeof number);
    if (reading_ && number > unread_.size() / least_bytes) throw_damaged();
    return static_cast<std::size_t>(number);
  }

  template <class Value>
  void keep(Value& value) {
    if constexpr (std::is_arithmetic_v<Value>) bytes(&value, sizeof value);
    else value.keep(*this);
  }

  template <class Scalar, int rows, int columns>
  void keep(Eigen::Matrix<Scalar, rows, columns>& matrix) {
    auto height = static_cast<std::uint64_t>(matrix.rows());
    bytes(&height, sizeof height);
    const std::size_t size = count(static_cast<std::size_t>(matrix.size()), sizeof(Scalar));
    if (reading_ && (height == 0 ? size > 0 : size % height > 0)) throw_damaged();
    if (reading_) {
      const auto width = height == 0 ? matrix.cols() : static_cast<Eigen::Index>(size / height);
      matrix.resize(static_cast<Eigen::Index>(height), width);
    }
    bytes(matrix.data(), size * sizeof(Scalar));
  }

  template <class Value>
  void keep(std::vector<Value>& list) {
    constexpr bool plain = std::is_arithmetic_v<Value>;
    list.resize(count(list.size(), plain ? sizeof(Value) : 1));
    if constexpr (plain) bytes(list.data(), list.size() * sizeof(Value));
    else
      for (Value& value : list) keep(value);
  }

  template <class Value, std::size_t size>
  void keep(std::array<Value, size>& list) {
    for (Value& value : list) keep(value);
  }

  template <class Value>
  void keep(std::optional<Value>& value) {
    bool there = value.has_value();
    keep(there);
    if (reading_) value = there ? std::optional<Value>(Value{}) : std::nullopt;
    if (there) keep(*value);
  }

  static constexpr std::size_t long_bytes = std::size_t{1} << 20;

  std::string written_;
  std::string_view unread_;
  bool reading_ = false;
};

}  // namespace linkwork
