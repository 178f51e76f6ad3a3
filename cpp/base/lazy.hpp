// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

namespace gcv {

// A value that is made on first use. It is made once, by the first thread that asks; other threads
// wait. So an object with such a part does not change for its users. A copy starts without the
// value. Takes a pointer until it is asked for.
template <class Value>
class Lazy {
 public:
  Lazy() = default;
  Lazy(const Lazy& /*other*/) {}
  Lazy& operator=(const Lazy& other) {
    if (this != &other) {
      delete place_.exchange(nullptr);
    }
    return *this;
  }
  ~Lazy() { delete place_.load(std::memory_order_acquire); }

  // Returns the value. The first call makes it with make().
  template <class Make>
  const Value& get(Make make) const {
    const Place* const place = place_.load(std::memory_order_acquire);
    return place != nullptr && place->is_made.load(std::memory_order_acquire)
               ? *place->value
               : value_in(shared_place(), make);
  }

 private:
  struct Place {
    std::mutex mutex;
    std::atomic<bool> is_made{false};
    std::optional<Value> value;
  };

  // The place of all threads that ask, the first one's.
  Place& shared_place() const {
    Place* place = place_.load(std::memory_order_acquire);
    if (place == nullptr) {
      auto made = std::make_unique<Place>();
      if (place_.compare_exchange_strong(place, made.get())) {
        place = made.release();
      }
    }
    return *place;
  }

  // Not in line: get() is called for every question.
  template <class Make>
  [[gnu::noinline]] static const Value& value_in(Place& place, Make make) {
    const std::lock_guard<std::mutex> lock(place.mutex);
    if (!place.value) {
      place.value.emplace(make());
      place.is_made.store(true, std::memory_order_release);
    }
    return *place.value;
  }

  mutable std::atomic<Place*> place_{nullptr};
};

}  // namespace gcv
