// SPDX-License-Identifier: LGPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "system.hpp"

namespace gcv::bench {

double cells_per_unit(const Ring& a, const Ring& b, int bits) {
  double size = 0;
  for (const Ring* ring : {&a, &b}) {
    for (const Point& p : *ring) {
      size = std::max({size, std::abs(p.x), std::abs(p.y)});
    }
  }
  return std::ldexp(1, bits - 2 - std::ilogb(size));
}

}  // namespace gcv::bench
