#pragma once

#include <memory>

namespace linkwork {

/// A value that copies share until one of them changes it: what makes a Model of a million bodies cheap to copy.
template <class T>
class Shared {
 public:
  template <class... Arguments>
  explicit Shared(Arguments&&... arguments) : value_(std::make_shared<T>(std::forward<Arguments>(arguments)...)) {}
  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }
  /// For changes: the value of this copy alone.
  T& own() {
    if (value_.use_count() > 1) value_ = std::make_shared<T>(*value_);
    return *value_;
  }

 private:
  std::shared_ptr<T> value_;
};

}  // namespace linkwork
