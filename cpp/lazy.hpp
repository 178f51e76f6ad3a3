// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <mutex>
#include <optional>

namespace gcv {

// A part of an object that is made when it is first asked for, once, by whichever thread asks:
// seen from outside, the object stays as it is. Copies start without it.
template <class Value>
class Lazy {
 public:
  Lazy() = default;
  Lazy(const Lazy& /*other*/) {}
  Lazy& operator=(const Lazy& other) {
    if (this != &other) {
      value_.reset();
    }
    return *this;
  }
  ~Lazy() = default;

  // The value; the first time, make() makes it.
  template <class Make>
  const Value& get(Make make) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!value_) {
      value_.emplace(make());
    }
    return *value_;
  }

 private:
  mutable std::mutex mutex_;
  mutable std::optional<Value> value_;
};

}  // namespace gcv
