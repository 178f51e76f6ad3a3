// SPDX-License-Identifier: LGPL-3.0-or-later
#include "arrangement.hpp"

#include <algorithm>

namespace worlds {
namespace {

// The places of a segment at which another one meets it, in parts of a unit along its direction.
void find_cuts(const Segment& s, const Segment& other, std::vector<Int>& cuts) {
  const Int determinant = cross(s.direction, other.direction);
  const Point between = other.from - s.from;
  if (determinant != 0) {
    const Int part = kUnit / determinant;
    const Int along = cross(between, other.direction) * part;
    const Int along_other = cross(between, s.direction) * part;
    if (along >= 0 && along <= s.length * kUnit && along_other >= 0 &&
        along_other <= other.length * kUnit) {
      cuts.push_back(along);
    }
  } else if (cross(s.direction, between) == 0) {
    const Int from = dot(between, s.direction) / dot(s.direction, s.direction);
    for (const Int along : {from, from + other.length}) {
      if (along > 0 && along < s.length) {
        cuts.push_back(along * kUnit);
      }
    }
  }
}

}  // namespace

std::vector<SmallEdge> arrange(const std::vector<Segment>& segments) {
  std::vector<SmallEdge> small;
  std::vector<Int> cuts;
  for (const Segment& s : segments) {
    cuts.assign({0, s.length * kUnit});
    for (const Segment& other : segments) {
      find_cuts(s, other, cuts);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k) {
      small.push_back({kUnit * s.from + cuts[k - 1] * s.direction,
                       kUnit * s.from + cuts[k] * s.direction, s.direction});
    }
  }
  std::sort(small.begin(), small.end());
  small.erase(std::unique(small.begin(), small.end()), small.end());
  return small;
}

}  // namespace worlds
