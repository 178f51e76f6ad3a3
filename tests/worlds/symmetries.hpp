// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The symmetries of the square, and pairs up to them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "plane.hpp"

namespace worlds {

inline Point image(int symmetry, Point p) {
  if ((symmetry & 1) != 0) {
    p = {p.y, p.x};
  }
  return {(symmetry & 2) != 0 ? -p.x : p.x, (symmetry & 4) != 0 ? -p.y : p.y};
}

// What each symmetry makes of each member of a list: the index of the image.
using Images = std::array<std::vector<std::size_t>, 8>;

// Visits one of all pairs that some symmetry, of both together, or their exchange makes the same.
template <class Visit>
void visit_pairs(const Images& images, Visit visit) {
  for (std::size_t i = 0; i < images[0].size(); ++i) {
    for (std::size_t j = i; j < images[0].size(); ++j) {
      if (std::all_of(images.begin(), images.end(), [&](const auto& image) {
            const std::pair<std::size_t, std::size_t> other = std::minmax(image[i], image[j]);
            return std::pair{i, j} <= other;
          })) {
        visit(i, j);
      }
    }
  }
}

// Likewise with one of each of two lists, which are not exchanged.
template <class Visit>
void visit_pairs(const Images& a, const Images& b, Visit visit) {
  for (std::size_t i = 0; i < a[0].size(); ++i) {
    for (std::size_t j = 0; j < b[0].size(); ++j) {
      bool is_first = true;
      for (std::size_t s = 0; s < a.size(); ++s) {
        is_first = is_first && std::pair{i, j} <= std::pair{a[s][i], b[s][j]};
      }
      if (is_first) {
        visit(i, j);
      }
    }
  }
}

}  // namespace worlds
