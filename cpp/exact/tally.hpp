// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace gcv {

// The number of predicates that each tier has decided.
struct Tally {
  std::uint64_t filtered = 0;
  std::uint64_t fixed_width = 0;
  std::uint64_t rational = 0;

  Tally& operator+=(const Tally& other) {
    filtered += other.filtered;
    fixed_width += other.fixed_width;
    rational += other.rational;
    return *this;
  }
};

}  // namespace gcv
