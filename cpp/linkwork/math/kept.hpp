#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <typeindex>

namespace linkwork {

/// What others find once about something constant and keep with it: one object of each type. Several threads may ask.
class Kept {
 public:
  /// The object of type T; `make`, which asks for nothing here, gives the first one. Where it throws, there is none.
  template <class T, class Make>
  T& get(const Make& make) {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<void>& found = objects_[typeid(T)];
    if (!found) found = std::make_shared<T>(make());
    return *static_cast<T*>(found.get());
  }

 private:
  std::mutex mutex_;
  std::map<std::type_index, std::shared_ptr<void>> objects_;
};

}  // namespace linkwork
