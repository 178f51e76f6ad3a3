// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Does one ring contain another, in fractions?
#pragma once

#include <cstddef>

#include "exact_geometry.hpp"

namespace gcv::invariants {

// No point of `inner` is outside `outer`, both counter-clockwise. As many vertices of each are
// looked at as given, and all edges.
inline bool contains(const Ring& outer, const Ring& inner, std::size_t samples) {
  for (const std::size_t k : sample(inner.size(), samples)) {
    if (location(outer, inner[k]) < 0) {
      return false;
    }
  }
  for (const std::size_t k : sample(outer.size(), samples)) {
    if (location(inner, outer[k]) > 0) {
      return false;
    }
  }
  bool cross = false;
  for_each_overlap(edge_boxes(outer), edge_boxes(inner), [&](std::size_t i, std::size_t j) {
    cross = segments_cross(outer[i], next(outer, i), inner[j], next(inner, j));
    return !cross;
  });
  return !cross;
}

}  // namespace gcv::invariants
