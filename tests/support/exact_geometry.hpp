// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Geometry in fractions, for tests: plain and slow.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "invariants.hpp"

namespace gcv::invariants {

using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

struct Exact {
  Rational x;
  Rational y;
};

using Ring = std::vector<Exact>;

inline bool operator==(const Exact& p, const Exact& q) { return p.x == q.x && p.y == q.y; }
inline bool operator<(const Exact& p, const Exact& q) {
  return p.x < q.x || (p.x == q.x && p.y < q.y);
}
inline Exact operator+(const Exact& p, const Exact& q) { return {p.x + q.x, p.y + q.y}; }
inline Exact operator-(const Exact& p, const Exact& q) { return {p.x - q.x, p.y - q.y}; }
inline Exact operator*(const Rational& t, const Exact& p) { return {t * p.x, t * p.y}; }

inline Rational cross(const Exact& p, const Exact& q) { return p.x * q.y - p.y * q.x; }
inline Rational dot(const Exact& p, const Exact& q) { return p.x * q.x + p.y * q.y; }
inline int sign(const Rational& x) { return x.sign(); }

// Above 0: r lies left of the line from p to q.
inline int orientation(const Exact& p, const Exact& q, const Exact& r) {
  return sign(cross(q - p, r - p));
}

template <typename Vector>
const auto& next(const Vector& ring, std::size_t k) {
  return ring[k + 1 == ring.size() ? 0 : k + 1];
}
template <typename Vector>
const auto& previous(const Vector& ring, std::size_t k) {
  return ring[k == 0 ? ring.size() - 1 : k - 1];
}

inline Exact exact(const Point& p) { return {Rational(p[0]), Rational(p[1])}; }

inline Ring exact(const Polygon& polygon) {
  Ring ring;
  for (const Point& p : polygon) {
    ring.push_back(exact(p));
  }
  return ring;
}

// Doubles close below and above x.
inline double below(const Rational& x) {
  const double towards_zero = mpq_get_d(x.backend().data());
  return std::nextafter(std::nextafter(towards_zero, -HUGE_VAL), -HUGE_VAL);
}
inline double above(const Rational& x) { return -below(-x); }

// The double nearest to x, ties to even.
inline double nearest(const Rational& x) {
  double best = below(x);
  for (int k = 0; k < 4; ++k) {
    const double candidate = std::nextafter(best, HUGE_VAL);
    if (!std::isfinite(candidate)) {
      break;
    }
    const Rational gain = abs(x - Rational(best)) - abs(x - Rational(candidate));
    if (gain < 0 || (gain == 0 && std::bit_cast<std::uint64_t>(best) % 2 == 0)) {
      break;
    }
    best = candidate;
  }
  return best == 0 ? 0 : best;
}

inline Point nearest(const Exact& p) { return {nearest(p.x), nearest(p.y)}; }

// From the lexicographically smallest vertex.
template <typename Vector>
Vector canonical(Vector ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

template <typename Vector>
Vector without_repetitions(const Vector& ring) {
  Vector distinct;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (!(ring[k] == next(ring, k))) {
      distinct.push_back(ring[k]);
    }
  }
  return distinct;
}

inline Rational twice_area(const Ring& ring) {
  Rational sum = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    sum += cross(ring[k] - ring[0], ring[k + 1] - ring[0]);
  }
  return sum;
}

// An upper bound on it. Fractions with unlike denominators do not add up cheaply: each is
// rounded up first, to 2^-256 of the largest.
inline Rational twice_area_bound(const Ring& ring) {
  using boost::multiprecision::mpz_int;
  std::vector<Rational> terms;
  Rational largest = 0;
  for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
    terms.push_back(cross(ring[k] - ring[0], ring[k + 1] - ring[0]));
    largest = std::max<Rational>(largest, abs(terms.back()));
  }
  const Rational unit = largest / Rational(mpz_int(1) << 256);
  mpz_int units = 0;
  for (const Rational& term : terms) {
    const Rational quotient = term / unit;
    units += mpz_int(numerator(quotient) / denominator(quotient)) + 1;
  }
  return Rational(units) * unit;
}

inline bool between(const Exact& p, const Exact& q, const Exact& x) {
  return !(std::max(p, q) < x) && !(x < std::min(p, q));
}

inline bool on_segment(const Exact& p, const Exact& q, const Exact& x) {
  return orientation(p, q, x) == 0 && between(p, q, x);
}

inline bool segments_meet(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  const int c_side = orientation(a, b, c);
  const int d_side = orientation(a, b, d);
  if (c_side == 0 && d_side == 0) {
    return between(a, b, c) || between(a, b, d) || between(c, d, a);
  }
  return c_side * d_side <= 0 && orientation(c, d, a) * orientation(c, d, b) <= 0;
}

inline bool segments_cross(const Exact& a, const Exact& b, const Exact& c, const Exact& d) {
  return orientation(a, b, c) * orientation(a, b, d) < 0 &&
         orientation(c, d, a) * orientation(c, d, b) < 0;
}

inline Rational squared_distance(const Exact& p, const Exact& q, const Exact& x) {
  const Exact along = q - p;
  const Exact to_x = x - p;
  const Rational t = dot(to_x, along) / dot(along, along);
  const Exact rest = to_x - std::clamp<Rational>(t, 0, 1) * along;
  return dot(rest, rest);
}

// 1 inside, 0 on the ring, -1 outside.
inline int location(const Ring& ring, const Exact& x) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Exact& p = ring[k];
    const Exact& q = next(ring, k);
    if ((p.y <= x.y) != (q.y <= x.y)) {
      const int side = orientation(p, q, x);
      if (side == 0) {
        return 0;
      }
      inside ^= (side > 0) == (p.y < q.y);
    } else if (p == x || (p.y == x.y && q.y == x.y && between(p, q, x))) {
      return 0;
    }
  }
  return inside ? 1 : -1;
}

// Counter-clockwise, from the smallest point, without collinear ones.
inline Ring hull(Ring points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto chain = [](auto first, auto last) {
    Ring half;
    for (; first != last; ++first) {
      while (half.size() > 1 && orientation(half.end()[-2], half.back(), *first) <= 0) {
        half.pop_back();
      }
      half.push_back(*first);
    }
    half.pop_back();
    return half;
  };
  Ring ring = chain(points.begin(), points.end());
  const Ring upper = chain(points.rbegin(), points.rend());
  ring.insert(ring.end(), upper.begin(), upper.end());
  return ring;
}

inline Ring sum_of_hulls(const Ring& a, const Ring& b) {
  Ring sum;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.size() || j < b.size()) {
    sum.push_back(a[i % a.size()] + b[j % b.size()]);
    int turn = i == a.size() ? -1 : 1;
    if (i < a.size() && j < b.size()) {
      turn = sign(cross(next(a, i) - a[i], next(b, j) - b[j]));
    }
    i += turn >= 0 ? 1 : 0;
    j += turn <= 0 ? 1 : 0;
  }
  return sum;
}

// ------------------------------------------------------------------------- box pairs --

struct Box {
  std::array<double, 2> low;
  std::array<double, 2> high;
};

inline Box box(const Exact& p, const Exact& q) {
  const auto& [x0, x1] = std::minmax(p.x, q.x);
  const auto& [y0, y1] = std::minmax(p.y, q.y);
  return {{below(x0), below(y0)}, {above(x1), above(y1)}};
}

inline std::vector<Box> edge_boxes(const Ring& ring) {
  std::vector<Box> boxes;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    boxes.push_back(box(ring[k], next(ring, k)));
  }
  return boxes;
}

// Calls visit(i, j) for all boxes p[i] and q[j] that overlap, until it returns false. A
// sweep along the axis on which the boxes are shorter.
inline void for_each_overlap(const std::vector<Box>& p, const std::vector<Box>& q,
                             const std::function<bool(std::size_t, std::size_t)>& visit) {
  std::array<double, 2> length{};
  for (const auto* boxes : {&p, &q}) {
    for (const Box& b : *boxes) {
      length[0] += b.high[0] / 4 - b.low[0] / 4;
      length[1] += b.high[1] / 4 - b.low[1] / 4;
    }
  }
  const std::size_t axis = length[1] < length[0] ? 1 : 0;
  struct Side {
    const std::vector<Box>& boxes;
    std::vector<std::size_t> order;
    std::vector<std::size_t> active;
    std::size_t begun = 0;
  };
  std::array<Side, 2> sides{Side{p, {}, {}}, Side{q, {}, {}}};
  for (Side& side : sides) {
    for (std::size_t k = 0; k < side.boxes.size(); ++k) {
      side.order.push_back(k);
    }
    std::sort(side.order.begin(), side.order.end(), [&](std::size_t k, std::size_t l) {
      return side.boxes[k].low[axis] < side.boxes[l].low[axis];
    });
  }
  const auto start = [&](const Side& side) {
    return side.begun == side.order.size() ? HUGE_VAL
                                           : side.boxes[side.order[side.begun]].low[axis];
  };
  while (sides[0].begun < p.size() || sides[1].begun < q.size()) {
    const std::size_t s = start(sides[1]) < start(sides[0]) ? 1 : 0;
    Side& mine = sides[s];
    Side& other = sides[1 - s];
    const std::size_t k = mine.order[mine.begun++];
    const Box& b = mine.boxes[k];
    std::erase_if(other.active,
                  [&](std::size_t l) { return other.boxes[l].high[axis] < b.low[axis]; });
    for (const std::size_t l : other.active) {
      const Box& c = other.boxes[l];
      if (b.low[1 - axis] <= c.high[1 - axis] && c.low[1 - axis] <= b.high[1 - axis] &&
          !(s == 0 ? visit(k, l) : visit(l, k))) {
        return;
      }
    }
    mine.active.push_back(k);
  }
}

// Two edges that meet where they should not.
inline std::optional<std::pair<std::size_t, std::size_t>> find_meeting(const Ring& ring) {
  std::optional<std::pair<std::size_t, std::size_t>> found;
  const auto folds_back = [&](std::size_t k) {
    const Exact in = next(ring, k) - ring[k];
    const Exact out = next(ring, (k + 1) % ring.size()) - next(ring, k);
    return sign(cross(in, out)) == 0 && sign(dot(in, out)) <= 0;
  };
  const std::vector<Box> boxes = edge_boxes(ring);
  for_each_overlap(boxes, boxes, [&](std::size_t i, std::size_t j) {
    const bool meet = j == (i + 1) % ring.size()
                          ? folds_back(i)
                          : i + 1 < j && (i != 0 || j + 1 != ring.size()) &&
                                segments_meet(ring[i], next(ring, i), ring[j], next(ring, j));
    if (meet) {
      found = {i, j};
    }
    return !meet;
  });
  return found;
}

inline bool polygons_meet(const Ring& a, const std::vector<Box>& boxes_of_a, const Ring& b) {
  bool meet = false;
  for_each_overlap(boxes_of_a, edge_boxes(b), [&](std::size_t i, std::size_t j) {
    meet = segments_meet(a[i], next(a, i), b[j], next(b, j));
    return !meet;
  });
  return meet || location(a, b[0]) >= 0 || location(b, a[0]) >= 0;
}

// `count` of the numbers below `total`, evenly spread.
inline std::vector<std::size_t> sample(std::size_t total, std::size_t count) {
  std::vector<std::size_t> numbers;
  const double step = std::max(1.0, static_cast<double>(total) / static_cast<double>(count + 1));
  for (double x = 0; x < static_cast<double>(total); x += step) {
    numbers.push_back(static_cast<std::size_t>(x));
  }
  return numbers;
}

// Are all the points within the distance of the ring?
inline bool all_near(const Ring& points, const Ring& ring, double distance) {
  const Rational d(distance);
  std::vector<Box> boxes;
  for (const Exact& p : points) {
    boxes.push_back({{below(p.x - d), below(p.y - d)}, {above(p.x + d), above(p.y + d)}});
  }
  std::vector<bool> near(points.size());
  for_each_overlap(boxes, edge_boxes(ring), [&](std::size_t i, std::size_t k) {
    near[i] = near[i] || squared_distance(ring[k], next(ring, k), points[i]) <= d * d;
    return true;
  });
  return std::find(near.begin(), near.end(), false) == near.end();
}

// The box grown by the distance.
inline Box around(Box b, double distance) {
  for (const std::size_t axis : {0U, 1U}) {
    b.low[axis] = below(Rational(b.low[axis]) - Rational(distance));
    b.high[axis] = above(Rational(b.high[axis]) + Rational(distance));
  }
  return b;
}

// Are all the points of the segment pq within the distance of some of these edges of the
// ring? It is where both of its ends are near one edge; else each of its halves has to be.
// After twelve halvings, one end has to do.
inline bool segment_near(const Exact& p, const Exact& q, const Ring& ring,
                         const std::vector<std::size_t>& edges, double distance, int halvings = 0) {
  const Rational d(distance);
  const auto near = [&](std::size_t k, const Exact& x) {
    return squared_distance(ring[k], next(ring, k), x) <= d * d;
  };
  const Box place = around(box(p, q), distance);
  std::vector<std::size_t> here;
  bool p_is_near = false;
  for (const std::size_t k : edges) {
    const Box b = box(ring[k], next(ring, k));
    if (b.low[0] <= place.high[0] && place.low[0] <= b.high[0] && b.low[1] <= place.high[1] &&
        place.low[1] <= b.high[1]) {
      here.push_back(k);
      if (near(k, p)) {
        p_is_near = true;
        if (near(k, q)) {
          return true;
        }
      }
    }
  }
  const Exact middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
  return p_is_near &&
         (halvings == 12 || (segment_near(p, middle, ring, here, distance, halvings + 1) &&
                             segment_near(middle, q, ring, here, distance, halvings + 1)));
}

// Are all the points of some edges of a ring, as many as given, within the distance of
// another one?
inline bool all_edges_near(const Ring& edges, const Ring& ring, double distance,
                           std::size_t samples) {
  std::vector<Box> boxes;
  std::vector<std::size_t> looked_at = sample(edges.size(), samples);
  for (const std::size_t k : looked_at) {
    boxes.push_back(around(box(edges[k], next(edges, k)), distance));
  }
  std::vector<std::vector<std::size_t>> near(boxes.size());
  for_each_overlap(boxes, edge_boxes(ring), [&](std::size_t i, std::size_t k) {
    near[i].push_back(k);
    return true;
  });
  for (std::size_t i = 0; i < looked_at.size(); ++i) {
    const std::size_t k = looked_at[i];
    if (!segment_near(edges[k], next(edges, k), ring, near[i], distance)) {
      return false;
    }
  }
  return true;
}

}  // namespace gcv::invariants
