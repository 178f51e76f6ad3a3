// SPDX-License-Identifier: LGPL-3.0-or-later
//
// May rings lie as they do? Of small integer coordinates, by a theory of its own: every edge is cut
// where it meets the other ring, and the middle of every piece must lie strictly on the right side
// of that ring. All in integers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "generators.hpp"

namespace gcv::test::pieces {

struct Fraction {
  std::int64_t over;
  std::int64_t under;  // above 0
};
inline bool operator<(const Fraction& p, const Fraction& q) {
  return p.over * q.under < q.over * p.under;
}

// (x / w, y / w), w > 0
struct Place {
  std::int64_t x;
  std::int64_t y;
  std::int64_t w;
};

struct Vector {
  std::int64_t x;
  std::int64_t y;
};
inline Vector between(const Point& p, const Point& q) {
  return {static_cast<std::int64_t>(q.x - p.x), static_cast<std::int64_t>(q.y - p.y)};
}
inline std::int64_t cross(const Vector& v, const Vector& w) { return v.x * w.y - v.y * w.x; }
inline std::int64_t dot(const Vector& v, const Vector& w) { return v.x * w.x + v.y * w.y; }

inline const Point& end_of(const Ring& ring, std::size_t edge) {
  return ring[edge + 1 == ring.size() ? 0 : edge + 1];
}

// 1 inside, 0 on the ring, -1 outside.
inline int location(const Ring& ring, const Place& p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const auto seen = [&](const Point& q) {
      return Vector{static_cast<std::int64_t>(q.x) * p.w - p.x,
                    static_cast<std::int64_t>(q.y) * p.w - p.y};
    };
    const Vector a = seen(ring[k]);
    const Vector b = seen(end_of(ring, k));
    const std::int64_t turn = cross(a, b);
    if (turn == 0 && dot(a, b) <= 0) {
      return 0;
    }
    if ((a.y > 0) != (b.y > 0)) {
      inside ^= (turn > 0) == (a.y <= 0);
    }
  }
  return inside ? 1 : -1;
}

// Where the closed edge pq meets rs, as parts of the way from p to q.
inline void add_meetings(const Point& p, const Point& q, const Point& r, const Point& s,
                         std::vector<Fraction>& cuts) {
  const Vector along = between(p, q);
  const Vector other = between(r, s);
  const std::int64_t turn = cross(along, other);
  if (turn == 0) {
    for (const Point& end : {r, s}) {
      const Fraction cut{dot(between(p, end), along), dot(along, along)};
      if (cross(along, between(p, end)) == 0 && cut.over > 0 && cut.over < cut.under) {
        cuts.push_back(cut);
      }
    }
    return;
  }
  const std::int64_t sign = turn > 0 ? 1 : -1;
  const Fraction cut{sign * cross(between(p, r), other), sign * turn};
  const std::int64_t on_other = sign * cross(between(p, r), along);
  if (cut.over > 0 && cut.over < cut.under && on_other >= 0 && on_other <= cut.under) {
    cuts.push_back(cut);
  }
}

// Do all of the pieces lie on that side of the ring, strictly?
inline bool lies(const Ring& ring, int side, const Ring& of) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& p = ring[i];
    const Vector along = between(p, end_of(ring, i));
    std::vector<Fraction> cuts{{0, 1}, {1, 1}};
    for (std::size_t k = 0; k < of.size(); ++k) {
      add_meetings(p, end_of(ring, i), of[k], end_of(of, k), cuts);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const auto& [a, b] = std::tie(cuts[k], cuts[k + 1]);
      if (!(a < b)) {
        continue;
      }
      const std::int64_t w = 2 * a.under * b.under;
      const std::int64_t t = a.over * b.under + b.over * a.under;
      const Place middle{static_cast<std::int64_t>(p.x) * w + t * along.x,
                         static_cast<std::int64_t>(p.y) * w + t * along.y, w};
      if (location(of, middle) != side) {
        return false;
      }
    }
  }
  return true;
}

// May rings i and j lie so? Ring 0 is the outer one.
inline bool may_lie(const std::vector<Ring>& rings, std::size_t i, std::size_t j) {
  const auto [first, second] = std::minmax(i, j);
  return lies(rings[second], first == 0 ? 1 : -1, rings[first]) &&
         lies(rings[first], -1, rings[second]);
}

inline bool all_may_lie(const std::vector<Ring>& rings) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = i + 1; j < rings.size(); ++j) {
      if (!may_lie(rings, i, j)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace gcv::test::pieces
