// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers different keys from 0 on, in the order in which they come. A hash table in two pieces of
// memory: those of std have one for each key, which takes long to give back where there are many.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace gcv {

// hash(key) gives 64 bits.
template <class Key, class Hash, class Equal>
class KeyNumbers {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  KeyNumbers(Hash hash, Equal equal) : hash_(std::move(hash)), equal_(std::move(equal)) {}

  // The number of a key, or none.
  [[nodiscard]] std::uint32_t find(const Key& key) const {
    return keys_.empty() ? none : numbers_[place_of(key)];
  }
  // The number of a key, and whether it is a new one.
  std::pair<std::uint32_t, bool> add(const Key& key) {
    if (2 * keys_.size() >= numbers_.size()) {
      grow();
    }
    std::uint32_t& number = numbers_[place_of(key)];
    if (number != none) {
      return {number, false};
    }
    const auto next = static_cast<std::uint32_t>(keys_.size());
    keys_.push_back(key);
    number = next;
    return {next, true};
  }
  void clear() {
    keys_.clear();
    numbers_.clear();
  }

 private:
  // Where to look for the key first, of so many places.
  [[nodiscard]] std::size_t first_place(const Key& key, std::size_t places) const {
    // The golden ratio spreads keys that are near (Knuth, 1973).
    return static_cast<std::size_t>((hash_(key) * 0x9e3779b97f4a7c15U) >>
                                    (64 - std::bit_width(places - 1)));
  }
  // Where the number of the key is, or may be put.
  [[nodiscard]] std::size_t place_of(const Key& key) const {
    std::size_t place = first_place(key, numbers_.size());
    while (numbers_[place] != none && !equal_(keys_[numbers_[place]], key)) {
      place = (place + 1) & (numbers_.size() - 1);
    }
    return place;
  }
  // To twice the room. All keys are different.
  void grow() {
    std::vector<std::uint32_t> numbers(numbers_.empty() ? 16 : 2 * numbers_.size(), none);
    for (std::uint32_t number = 0; number < keys_.size(); ++number) {
      std::size_t place = first_place(keys_[number], numbers.size());
      while (numbers[place] != none) {
        place = (place + 1) & (numbers.size() - 1);
      }
      numbers[place] = number;
    }
    numbers_ = std::move(numbers);
  }

  Hash hash_;
  Equal equal_;
  std::vector<Key> keys_;
  std::vector<std::uint32_t> numbers_;  // a power of two of places, at most half of them taken
};

}  // namespace gcv
