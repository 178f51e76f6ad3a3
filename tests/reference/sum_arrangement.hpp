// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The arrangement of all sums of an edge and a vertex, and points in its faces.
#pragma once

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "open_sum.hpp"

namespace gcv::reference::arranged {

// ---- The arrangement

using Traits = CGAL::Arr_segment_traits_2<Kernel>;
struct Mark {
  bool covered = false;   // in an open sum?
  bool in_window = true;  // or on its border?
  bool visited = false;   // of halfedges
  std::size_t index = 0;  // of faces
};
using Arrangement = CGAL::Arrangement_2<Traits, CGAL::Arr_extended_dcel<Traits, Mark, Mark, Mark>>;
using Halfedge = Arrangement::Halfedge_handle;
using Vertex = Arrangement::Vertex_handle;
using Face = Arrangement::Face_handle;

struct Span {
  Vector<Integer> from;
  Vector<Integer> to;
};

// All sums of an edge of one and a vertex of the other. Spans of one line that overlap are joined.
// This loses no vertex: other edges end where they end.
inline std::vector<Span> all_sums(const std::vector<Summands>& sums) {
  std::map<std::tuple<Integer, Integer, Integer>, std::vector<Span>> lines;
  const auto add = [&](const Solid& with_edges, const Solid& with_vertices) {
    for (const auto& e : with_edges.edges) {
      Direction d = with_edges.direction(e);
      const bool forward = d > Direction{0, 0};
      const Integer g = gcd(d.x, d.y);
      d = {d.x / g, d.y / g};
      if (!forward) {
        d = -d;
      }
      for (const auto& v : with_vertices.vertices) {
        const auto p = with_edges.vertices[forward ? e.from : e.to] + v;
        const auto q = with_edges.vertices[forward ? e.to : e.from] + v;
        lines[{d.x, d.y, cross(d, p)}].push_back({p, q});
      }
    }
  };
  for (const auto& [a, b] : sums) {
    add(a, b);
    add(b, a);
  }
  std::vector<Span> joined;
  for (auto& [line, spans] : lines) {
    std::sort(spans.begin(), spans.end(),
              [](const Span& s, const Span& t) { return s.from < t.from; });
    joined.push_back(spans.front());
    for (const Span& s : spans) {
      if (joined.back().to < s.from) {
        joined.push_back(s);
      } else if (joined.back().to < s.to) {
        joined.back().to = s.to;
      }
    }
  }
  return joined;
}

inline ExactPoint point(const Vector<Integer>& p, int scale) {
  const auto coordinate = [&](const Integer& n) {
    if (bits(n) <= 53 && scale < 1000) {
      return Kernel::FT(std::ldexp(n.convert_to<double>(), -scale));
    }
    return exact_number(Rational(n, Integer(1) << scale));
  };
  return {coordinate(p.x), coordinate(p.y)};
}

// Is the point strictly left of all edges of the face? Then it is inside.
inline bool is_left_of_all_edges(const ExactPoint& p, const Face& face) {
  const auto first = face->outer_ccb();
  auto edge = first;
  do {
    if (!CGAL::left_turn(edge->source()->point(), edge->target()->point(), p)) {
      return false;
    }
  } while (++edge != first);
  return true;
}

// From the middle of one of its edges half the way to the first other edge on its left.
inline ExactPoint left_of_an_edge(const Face& face) {
  using V = Vector<Kernel::FT>;
  std::vector<std::pair<V, V>> edges;
  const auto add = [&](auto first) {
    auto edge = first;
    do {
      const ExactPoint& p = edge->source()->point();
      const ExactPoint& q = edge->target()->point();
      edges.emplace_back(V{p.x(), p.y()}, V{q.x(), q.y()});
    } while (++edge != first);
  };
  add(face->outer_ccb());
  for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole) {
    add(*hole);
  }
  const auto [p, q] = edges.front();
  const V middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
  const V left{p.y - q.y, q.x - p.x};
  std::optional<Kernel::FT> nearest;
  const auto hit = [&](const Kernel::FT& t) {
    if (t > 0 && (!nearest || t < *nearest)) {
      nearest = t;
    }
  };
  for (const auto& [r, s] : edges) {
    const Kernel::FT side_of_r = cross(left, r - middle);
    const Kernel::FT side_of_s = cross(left, s - middle);
    if (side_of_r == 0) {
      hit(dot(left, r - middle) / dot(left, left));
    }
    if (side_of_s == 0) {
      hit(dot(left, s - middle) / dot(left, left));
    }
    if ((side_of_r < 0 && side_of_s > 0) || (side_of_r > 0 && side_of_s < 0)) {
      hit(cross(r - middle, s - r) / cross(left, s - r));
    }
  }
  const Kernel::FT half_way = nearest.value() / 2;
  return {middle.x + half_way * left.x, middle.y + half_way * left.y};
}

// A point inside a bounded face: the middle of its corners if it can be, for that is soon found,
// and sooner in doubles.
inline ExactPoint inner_point(const Face& face) {
  if (face->inner_ccbs_begin() == face->inner_ccbs_end()) {
    double rounded_x = 0;
    double rounded_y = 0;
    Kernel::FT x = 0;
    Kernel::FT y = 0;
    int count = 0;
    const auto first = face->outer_ccb();
    auto edge = first;
    do {
      const ExactPoint& p = edge->target()->point();
      rounded_x += CGAL::to_double(p.x());
      rounded_y += CGAL::to_double(p.y());
      x += p.x();
      y += p.y();
      ++count;
    } while (++edge != first);
    if (std::isfinite(rounded_x) && std::isfinite(rounded_y)) {
      const ExactPoint middle(rounded_x / count, rounded_y / count);
      if (is_left_of_all_edges(middle, face)) {
        return middle;
      }
    }
    const ExactPoint middle(x / count, y / count);
    if (count == 3 || is_left_of_all_edges(middle, face)) {
      return middle;
    }
  }
  return left_of_an_edge(face);
}

}  // namespace gcv::reference::arranged
