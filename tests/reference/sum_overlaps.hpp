// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Do two solids overlap, with one of them at a place? Decided in integers, and by fixed widths
// where these suffice.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "sum_solid.hpp"

namespace gcv::reference::arranged {

// ---- Overlaps: do A and x - B have a common inner point? Exact for all x.

template <class N>
struct Homogeneous {
  N x;
  N y;
  N w;  // above 0
};

// Why the three questions of covers() suffice. If A and x - B have a common inner point, then the
// set of such points is open, and bounded, for B is. Follow its boundary: pieces of edges of A and
// of x - B which have it on their left. A piece ends where two edges cross properly (the first
// question), or where a vertex of one lies on an edge or vertex of the other. There the solid
// sectors of the two overlap (the second). If neither happens, the piece is an edge, its ends are
// inside the other solid (the third). On the other hand, each yes shows a common inner point: edges
// are cut at all vertices, so both solids are half-planes where edges cross properly.
template <class N>
struct Overlaps {
  struct Edge {
    Vector<N> from;
    Vector<N> to;
  };
  struct Side {
    std::vector<Vector<N>> vertices;
    std::vector<Edge> edges;
    bool is_unbounded;
  };
  struct Parallelogram {  // counter-clockwise: a corner, two sides, the area
    Vector<N> corner;
    Vector<N> u;
    Vector<N> v;
    N area;
  };

  Side a;
  Side b;
  std::vector<Parallelogram> crossings;  // of edges that are not parallel
  std::vector<Edge> slides;  // where a vertex of one and an edge of the other touch and overlap
  std::vector<Vector<N>> meetings;  // where two vertices touch and the solids overlap

  // Is x / w on the edge, without its ends?
  static bool on_open_edge(const Vector<N>& x, const N& w, const Edge& e) {
    const Vector<N> d = e.to - e.from;
    const Vector<N> y = x - w * e.from;
    return cross(d, y) == 0 && dot(d, y) > 0 && dot(d, w * e.to - x) > 0;
  }

  // Is x / w strictly inside the solid?
  static bool strictly_inside(const Side& side, const Vector<N>& x, const N& w) {
    bool inside = side.is_unbounded;
    for (const Edge& e : side.edges) {
      const Vector<N> p = w * e.from;
      const Vector<N> q = w * e.to;
      if (x == p || on_open_edge(x, w, e)) {
        return false;
      }
      if ((p.y > x.y) != (q.y > x.y)) {
        const bool to_the_left = cross(e.to - e.from, x - p) > 0;
        inside = inside != (to_the_left == (q.y > p.y));
      }
    }
    return inside;
  }

  [[nodiscard]] bool covers(const Homogeneous<N>& place) const {
    const N& w = place.w;
    const Vector<N> x{place.x, place.y};
    for (const Parallelogram& p : crossings) {
      const Vector<N> d = x - w * p.corner;
      const N s = cross(d, p.v);
      if (s <= 0 || s >= w * p.area) {
        continue;
      }
      const N t = cross(p.u, d);
      if (t > 0 && t < w * p.area) {
        return true;
      }
    }
    for (const Edge& e : slides) {
      if (on_open_edge(x, w, e)) {
        return true;
      }
    }
    for (const Vector<N>& p : meetings) {
      if (x == w * p) {
        return true;
      }
    }
    for (const Vector<N>& q : b.vertices) {
      if (strictly_inside(a, x - w * q, w)) {
        return true;
      }
    }
    for (const Vector<N>& p : a.vertices) {
      if (strictly_inside(b, x - w * p, w)) {
        return true;
      }
    }
    return false;
  }
};

inline Overlaps<Integer> make_overlaps(const Solid& a, const Solid& b) {
  Overlaps<Integer> result;
  const auto side = [](const Solid& solid) {
    Overlaps<Integer>::Side s{solid.vertices, {}, solid.is_unbounded};
    for (const auto& e : solid.edges) {
      s.edges.push_back({solid.vertices[e.from], solid.vertices[e.to]});
    }
    return s;
  };
  result.a = side(a);
  result.b = side(b);
  for (const auto& e : a.edges) {
    for (const auto& f : b.edges) {
      Direction u = a.direction(e);
      Direction v = b.direction(f);
      const Integer area = cross(u, v);
      if (area < 0) {
        std::swap(u, v);
      }
      if (area != 0) {
        result.crossings.push_back({a.vertices[e.from] + b.vertices[f.from], u, v, abs(area)});
      }
    }
  }
  const auto any_overlap = [](const std::vector<Sector>& of_a, const std::vector<Sector>& of_b) {
    return std::any_of(of_a.begin(), of_a.end(), [&](const Sector& s) {
      return std::any_of(of_b.begin(), of_b.end(),
                         [&](const Sector& t) { return overlap(s, reflected(t)); });
    });
  };
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    for (const auto& f : b.edges) {
      if (any_overlap(a.sectors[i], {left_of(b.direction(f))})) {
        result.slides.push_back(
            {a.vertices[i] + b.vertices[f.from], a.vertices[i] + b.vertices[f.to]});
      }
    }
    for (std::size_t j = 0; j < b.vertices.size(); ++j) {
      if (any_overlap(a.sectors[i], b.sectors[j])) {
        result.meetings.push_back(a.vertices[i] + b.vertices[j]);
      }
    }
  }
  for (std::size_t j = 0; j < b.vertices.size(); ++j) {
    for (const auto& e : a.edges) {
      if (any_overlap({left_of(a.direction(e))}, b.sectors[j])) {
        result.slides.push_back(
            {a.vertices[e.from] + b.vertices[j], a.vertices[e.to] + b.vertices[j]});
      }
    }
  }
  return result;
}

inline Vector<Wide> wide(const Vector<Integer>& p) {
  return {p.x.convert_to<std::int64_t>(), p.y.convert_to<std::int64_t>()};
}

inline Overlaps<Wide> wide(const Overlaps<Integer>& from) {
  Overlaps<Wide> result;
  const auto edge = [](const auto& e) { return Overlaps<Wide>::Edge{wide(e.from), wide(e.to)}; };
  const auto side = [&](const auto& s) {
    Overlaps<Wide>::Side to{{}, {}, s.is_unbounded};
    for (const auto& p : s.vertices) {
      to.vertices.push_back(wide(p));
    }
    for (const auto& e : s.edges) {
      to.edges.push_back(edge(e));
    }
    return to;
  };
  result.a = side(from.a);
  result.b = side(from.b);
  for (const auto& p : from.crossings) {
    const Vector<Wide> u = wide(p.u);
    const Vector<Wide> v = wide(p.v);
    result.crossings.push_back({wide(p.corner), u, v, cross(u, v)});
  }
  for (const auto& e : from.slides) {
    result.slides.push_back(edge(e));
  }
  for (const auto& p : from.meetings) {
    result.meetings.push_back(wide(p));
  }
  return result;
}

// Below 2 to the power of what?
inline int bits(const Integer& n) { return n == 0 ? 0 : static_cast<int>(msb(abs(n))) + 1; }

}  // namespace gcv::reference::arranged
