// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Solids of integers for sums: closed regions whose boundary is made of rings, and where they are
// seen from their vertices.
#pragma once

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "region_reference.hpp"

namespace gcv::reference::arranged {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Rational = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Wide = __int128;

// ---- Vectors. Numbers are Integer, Wide, or Rational.

template <class N>
struct Vector {
  N x;
  N y;

  friend bool operator==(const Vector& p, const Vector& q) { return p.x == q.x && p.y == q.y; }
  friend bool operator>(const Vector& p, const Vector& q) { return q < p; }
  friend bool operator<(const Vector& p, const Vector& q) {
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  }
  friend Vector operator+(const Vector& p, const Vector& q) { return {p.x + q.x, p.y + q.y}; }
  friend Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y}; }
  friend Vector operator-(const Vector& p) { return {-p.x, -p.y}; }
  friend Vector operator*(const N& t, const Vector& p) { return {t * p.x, t * p.y}; }
};

template <class N>
N cross(const Vector<N>& p, const Vector<N>& q) {
  return p.x * q.y - p.y * q.x;
}
template <class N>
N dot(const Vector<N>& p, const Vector<N>& q) {
  return p.x * q.x + p.y * q.y;
}
template <class N>
bool on_open_segment(const Vector<N>& x, const Vector<N>& p, const Vector<N>& q) {
  return cross(q - p, x - p) == 0 && dot(x - p, q - x) > 0;
}

// ---- Sectors: open sets of directions, from `first` counter-clockwise to `last`.

using Direction = Vector<Integer>;
struct Sector {
  Direction first;
  Direction last;
};

// The quarter of directions, counted from d: d itself, left of d, opposite to d, right of d.
inline int quarter(const Direction& d, const Direction& e) {
  const Integer c = cross(d, e);
  return c > 0 ? 1 : c < 0 ? 3 : dot(d, e) > 0 ? 0 : 2;
}

// Turning counter-clockwise from d, is e met before f?
inline bool met_before(const Direction& d, const Direction& e, const Direction& f) {
  const int qe = quarter(d, e);
  const int qf = quarter(d, f);
  return qe != qf ? qe < qf : cross(e, f) > 0;
}

// Two arcs overlap if one of them begins inside the other, or both begin together.
inline bool overlap(const Sector& s, const Sector& t) {
  return met_before(s.first, t.first, s.last) || met_before(t.first, s.first, t.last);
}

inline Sector reflected(const Sector& s) { return {-s.first, -s.last}; }
inline Sector left_of(const Direction& d) { return {d, -d}; }

// ---- Solids: closed regions whose boundary is made of rings.

using ExactRing = std::vector<Vector<Integer>>;

// Without repeated and collinear vertices.
inline ExactRing cleaned(ExactRing ring) {
  for (std::size_t k = 0; k < ring.size();) {
    const std::size_t n = ring.size();
    const auto& p = ring[(k + n - 1) % n];
    const auto& q = ring[(k + 1) % n];
    if (cross(ring[k] - p, q - ring[k]) == 0) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    } else {
      ++k;
    }
  }
  return ring;
}

inline Integer twice_area(const ExactRing& ring) {
  Integer area = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    area += cross(ring[k], ring[(k + 1) % ring.size()]);
  }
  return area;
}

struct Solid {
  struct Edge {
    std::size_t from;
    std::size_t to;
  };

  // Each vertex once, also where rings touch.
  std::vector<Vector<Integer>> vertices;
  // The solid is left of each edge. Edges are cut where another ring touches them.
  std::vector<Edge> edges;
  // Where the solid is, seen from each vertex.
  std::vector<std::vector<Sector>> sectors;
  bool is_unbounded;

  [[nodiscard]] Direction direction(const Edge& e) const {
    return vertices[e.to] - vertices[e.from];
  }
};

// The polygon, or what is not in the polygon.
inline Solid make_solid(const std::vector<ExactRing>& rings, bool complement) {
  Solid solid;
  solid.is_unbounded = complement;
  std::map<Vector<Integer>, std::size_t> index;
  std::vector<ExactRing> turned;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    ExactRing ring = cleaned(rings[k]);
    const bool counter_clockwise = (k == 0) != complement;
    if ((twice_area(ring) > 0) != counter_clockwise) {
      std::reverse(ring.begin(), ring.end());
    }
    for (const auto& p : ring) {
      if (index.emplace(p, solid.vertices.size()).second) {
        solid.vertices.push_back(p);
      }
    }
    turned.push_back(std::move(ring));
  }
  for (const ExactRing& ring : turned) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto& p = ring[k];
      const auto& q = ring[(k + 1) % ring.size()];
      ExactRing places{p, q};
      for (const auto& x : solid.vertices) {
        if (on_open_segment(x, p, q)) {
          places.push_back(x);
        }
      }
      std::sort(places.begin(), places.end(),
                [&](const auto& x, const auto& y) { return dot(y - x, q - p) > 0; });
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        solid.edges.push_back({index[places[i]], index[places[i + 1]]});
      }
    }
  }
  // The solid begins left of an edge out of the vertex, and ends at the next edge into it.
  solid.sectors.resize(solid.vertices.size());
  for (const auto& out : solid.edges) {
    const Direction first = solid.direction(out);
    std::optional<Direction> last;
    for (const auto& in : solid.edges) {
      if (in.to == out.from) {
        const Direction back = -solid.direction(in);
        if (!last || met_before(first, back, *last)) {
          last = back;
        }
      }
    }
    solid.sectors[out.from].push_back({first, last.value()});
  }
  return solid;
}

// ---- Operands, scaled to integers

// How often a coordinate must be doubled to be an integer.
inline int binary_places(double x) {
  int places = 0;
  if (x != 0) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    places = 53 - exponent - __builtin_ctzll(static_cast<unsigned long long>(mantissa));
  }
  return std::max(places, 0);
}

inline int binary_places(const PointVector& points) {
  int places = 0;
  for (const Point& p : points) {
    places = std::max({places, binary_places(p.x), binary_places(p.y)});
  }
  return places;
}

inline int binary_places(const Rings& rings) {
  int places = 0;
  for (const PointVector& ring : rings) {
    places = std::max(places, binary_places(ring));
  }
  return places;
}

inline Vector<Integer> scaled(const Point& p, int scale) {
  const auto coordinate = [&](double x) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53 + scale;
    return shift >= 0 ? Integer(Integer(mantissa) << shift)
                      : Integer(mantissa / (Integer(1) << -shift));
  };
  return {coordinate(p.x), coordinate(p.y)};
}

// The rings, or their reflection, at a place.
inline std::vector<ExactRing> scaled(const Rings& rings, int scale, bool reflect = false,
                                     const Vector<Integer>& place = {0, 0}) {
  std::vector<ExactRing> result;
  for (const PointVector& ring : rings) {
    ExactRing exact;
    for (const Point& p : ring) {
      const Vector<Integer> q = scaled(p, scale);
      exact.push_back(place + (reflect ? -q : q));
    }
    result.push_back(std::move(exact));
  }
  return result;
}

}  // namespace gcv::reference::arranged
