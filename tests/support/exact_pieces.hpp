// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How two simple rings lie, in fractions: every edge is cut where it meets the other ring, and the
// middle of each piece is on one side of that ring, or on it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "exact_geometry.hpp"

namespace gcv::invariants {

// On which sides of another ring a ring has pieces.
struct Sides {
  bool inside = false;
  bool on = false;
  bool outside = false;
};

// Where the edge pq is cut by rs, as parts of the way from p to q.
inline void add_cuts(const Exact& p, const Exact& q, const Exact& r, const Exact& s,
                     std::vector<Rational>& cuts) {
  const Exact along = q - p;
  const Exact other = s - r;
  const Rational turn = cross(along, other);
  const auto add = [&](const Rational& t) {
    if (t > 0 && t < 1) {
      cuts.push_back(t);
    }
  };
  if (turn != 0) {
    const Rational on_other = cross(r - p, along) / turn;
    if (on_other >= 0 && on_other <= 1) {
      add(cross(r - p, other) / turn);
    }
  } else if (cross(along, r - p) == 0) {
    add(dot(r - p, along) / dot(along, along));
    add(dot(s - p, along) / dot(along, along));
  }
}

inline Sides sides(const Ring& ring, const Ring& of) {
  std::vector<std::vector<Rational>> cuts(ring.size(), {0, 1});
  for_each_overlap(edge_boxes(ring), edge_boxes(of), [&](std::size_t i, std::size_t k) {
    add_cuts(ring[i], next(ring, i), of[k], next(of, k), cuts[i]);
    return true;
  });
  Sides found;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    std::sort(cuts[i].begin(), cuts[i].end());
    for (std::size_t k = 0; k + 1 < cuts[i].size(); ++k) {
      if (cuts[i][k] == cuts[i][k + 1]) {
        continue;
      }
      const Rational middle = (cuts[i][k] + cuts[i][k + 1]) / 2;
      const int where = location(of, ring[i] + middle * (next(ring, i) - ring[i]));
      found.inside = found.inside || where > 0;
      found.on = found.on || where == 0;
      found.outside = found.outside || where < 0;
    }
  }
  return found;
}

// Do the interiors of the two polygons meet? If no piece of a boundary is in the other interior,
// only if they are one.
inline bool interiors_overlap(const Ring& p, const Ring& q) {
  const Sides of_p = sides(p, q);
  return of_p.inside || sides(q, p).inside || !of_p.outside;
}

// Is no point of the polygon p outside the polygon q?
inline bool lies_in(const Ring& p, const Ring& q) { return !sides(p, q).outside; }

}  // namespace gcv::invariants
