// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <atomic>
#include <mutex>
#include <optional>

namespace gcv {

// A value that is made on first use. It is made once, by the first thread that asks; other threads
// wait. So an object with such a part does not change for its users. A copy starts without the
// value.
template <class Value>
class Lazy {
 public:
  Lazy() = default;
  Lazy(const Lazy& /*other*/) {}
  Lazy& operator=(const Lazy& other) {
    if (this != &other) {
      is_made_ = false;
      value_.reset();
    }
    return *this;
  }
  ~Lazy() = default;

  // Returns the value. The first call makes it with make().
  template <class Make>
  const Value& get(Make make) const {
    if (!is_made_.load(std::memory_order_acquire)) {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (!value_) {
        value_.emplace(make());
        is_made_.store(true, std::memory_order_release);
      }
    }
    return *value_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::atomic<bool> is_made_{false};
  mutable std::optional<Value> value_;
};

}  // namespace gcv
