// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers of keys against those of std::map, with hashes that spread keys and with one that does
// not.
#include "key_numbers.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <map>
#include <random>

namespace gcv {
namespace {

template <class Hash>
void compare_with_map(std::uint64_t different, int adds, Hash hash) {
  KeyNumbers<std::uint64_t, Hash, std::equal_to<>> numbers(hash, {});
  for (int round = 0; round < 2; ++round) {
    std::map<std::uint64_t, std::uint32_t> expected;
    std::mt19937_64 random(20261127);
    EXPECT_EQ(numbers.find(0), numbers.none);
    for (int k = 0; k < adds; ++k) {
      const std::uint64_t key = random() % different;
      const auto found = expected.find(key);
      ASSERT_EQ(numbers.find(key), found == expected.end() ? numbers.none : found->second);
      const auto [number, is_new] =
          expected.try_emplace(key, static_cast<std::uint32_t>(expected.size()));
      ASSERT_EQ(numbers.add(key), std::pair(number->second, is_new));
    }
    numbers.clear();
  }
}

TEST(KeyNumbers, AreThoseOfTheOrderOfKeys) {
  const auto same = [](std::uint64_t key) { return key; };
  compare_with_map(10, 100, same);
  compare_with_map(1000, 5000, same);
  compare_with_map(~std::uint64_t{0}, 20000, same);
}

TEST(KeyNumbers, NeedNoHashThatSpreads) {
  compare_with_map(300, 2000, [](std::uint64_t) { return std::uint64_t{7}; });
  compare_with_map(1000, 5000, [](std::uint64_t key) { return key << 48U; });
}

}  // namespace
}  // namespace gcv
