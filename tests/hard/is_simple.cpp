// SPDX-License-Identifier: LGPL-3.0-or-later
//
// For the digest, which is built without GMP too, whose fractions tell the tests what is simple:
// what the library says, which permits repeated vertices.
#include <algorithm>

#include "gcv/gcv.h"
#include "invariants.hpp"

namespace gcv::invariants {

bool is_simple(const Polygon& ring) {
  const bool repeats =
      ring.front() == ring.back() || std::adjacent_find(ring.begin(), ring.end()) != ring.end();
  gcv_polygon* polygon = nullptr;
  const bool is_made = gcv_polygon_create(ring.front().data(), ring.size(), 0, &polygon) == GCV_OK;
  gcv_polygon_destroy(polygon);
  return is_made && !repeats;
}

}  // namespace gcv::invariants
