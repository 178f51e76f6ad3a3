// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Rows of bits, in words.
#pragma once

#include <cstdint>

namespace gcv {

using Word = std::uint64_t;
inline constexpr std::uint32_t word_size = 64;

// Calls visit(word, mask) for the words of a row with the bits from one to before another, until it
// returns false.
template <class Bits, class Visit>
bool for_each_word(Bits* row, std::uint32_t from, std::uint32_t to, Visit visit) {
  const std::uint32_t first = from / word_size;
  const std::uint32_t last = (to - 1) / word_size;
  for (std::uint32_t k = first; k <= last; ++k) {
    Word mask = ~Word{0};
    if (k == first) {
      mask <<= from % word_size;
    }
    if (k == last) {
      mask &= ~Word{0} >> (word_size - 1 - (to - 1) % word_size);
    }
    if (!visit(row[k], mask)) {
      return false;
    }
  }
  return true;
}

inline void set(Word* row, std::uint32_t from, std::uint32_t to) {
  for_each_word(row, from, to, [](Word& word, Word mask) {
    word |= mask;
    return true;
  });
}

}  // namespace gcv
