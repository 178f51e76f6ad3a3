// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solid.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace gcv::reference {

namespace {

using invariants::cross;
using invariants::next;
using invariants::on_segment;
using invariants::orientation;
using invariants::previous;

// A vertex, and the edge that starts at it.
struct Numbered {
  Exact place;
  std::uint32_t vertex;
  std::uint32_t edge;
};

using Chain = std::vector<Numbered>;

// Without repeated vertices. A vertex that is passed several times in a row has its last number.
// Closing vertices are the first one again.
Chain distinct_vertices(const invariants::Polygon& ring, std::uint32_t first_number) {
  std::size_t count = ring.size();
  while (count > 1 && ring[count - 1] == ring[0]) {
    --count;
  }
  Chain chain;
  for (std::size_t k = 0; k < count; ++k) {
    if (k + 1 == count || ring[k] != ring[k + 1]) {
      const std::uint32_t number = first_number + static_cast<std::uint32_t>(k);
      chain.push_back({invariants::exact(ring[k]), number, number});
    }
  }
  return chain;
}

bool is_counter_clockwise(const Chain& chain) {
  Rational twice_area = 0;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    twice_area += cross(chain[k].place, next(chain, k).place);
  }
  return twice_area > 0;
}

// The same ring the other way round. An edge keeps its number.
Chain reversed(const Chain& chain) {
  Chain result;
  for (std::size_t k = chain.size(); k-- > 0;) {
    result.push_back({chain[k].place, chain[k].vertex, previous(chain, k).edge});
  }
  return result;
}

// Merged edges have the number of the first one.
Chain without_collinear_vertices(const Chain& chain) {
  Chain result;
  for (std::size_t k = 0; k < chain.size(); ++k) {
    if (orientation(previous(chain, k).place, chain[k].place, next(chain, k).place) != 0) {
      result.push_back(chain[k]);
    }
  }
  return result;
}

// The crossing of the ray from x along d with the edge that is nearest to x, but is not x, as a
// multiple of d. The ray meets the boundary nowhere along an edge before that.
std::optional<Rational> first_hit(const std::vector<Edge>& edges, const Exact& x, const Exact& d) {
  std::optional<Rational> first;
  const auto take = [&](const Rational& s) {
    if (s > 0 && (!first || s < *first)) {
      first = s;
    }
  };
  for (const Edge& e : edges) {
    const Rational from = cross(d, e.from - x);
    const Rational to = cross(d, e.to - x);
    if (from == 0) {
      take(dot(e.from - x, d) / dot(d, d));
    }
    if ((from < 0) != (to < 0) && from != to) {
      const Exact place = e.from + (from / (from - to)) * (e.to - e.from);
      take(dot(place - x, d) / dot(d, d));
    }
  }
  return first;
}

// A point strictly inside, beside the edge: half of the way from the edge to what is opposite, if
// there is anything. The way starts between two places where other rings touch the edge.
Exact point_beside(const Edge& edge, const std::vector<Edge>& edges) {
  std::vector<Exact> places{edge.from, edge.to};
  for (const Edge& e : edges) {
    if (is_inside_edge(edge, e.from)) {
      places.push_back(e.from);
    }
  }
  std::sort(places.begin(), places.end());
  const Exact start = Rational(1, 2) * (places[0] + places[1]);
  const Exact along = edge.to - edge.from;
  const Exact inwards{-along.y, along.x};
  const std::optional<Rational> opposite = first_hit(edges, start, inwards);
  return start + (opposite ? *opposite / 2 : Rational(1)) * inwards;
}

}  // namespace

bool is_inside_edge(const Edge& edge, const Exact& x) {
  return on_segment(edge.from, edge.to, x) && !(x == edge.from) && !(x == edge.to);
}

Solid make_solid(const Rings& rings) {
  Solid solid;
  std::uint32_t first_number = 0;
  for (const invariants::Polygon& ring : rings) {
    Chain chain = distinct_vertices(ring, first_number);
    first_number += static_cast<std::uint32_t>(ring.size());
    const bool is_outer = &ring == &rings.front();
    if (is_counter_clockwise(chain) != is_outer) {
      chain = reversed(chain);
    }
    chain = without_collinear_vertices(chain);
    invariants::Ring places;
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const Exact& place = chain[k].place;
      places.push_back(place);
      solid.edges.push_back({place, next(chain, k).place, chain[k].edge});
      solid.corners.push_back(
          {previous(chain, k).place, place, next(chain, k).place, chain[k].vertex});
    }
    solid.rings.push_back(places);
  }
  for (const Edge& edge : solid.edges) {
    solid.inner_points.push_back(point_beside(edge, solid.edges));
  }
  return solid;
}

Solid complement(const Solid& polygon) {
  Solid solid;
  solid.is_complement = true;
  std::size_t end = 0;
  for (const invariants::Ring& ring : polygon.rings) {
    const std::size_t first = end;
    end += ring.size();
    solid.rings.emplace_back(ring.rbegin(), ring.rend());
    for (std::size_t k = end; k-- > first;) {
      const Corner& corner = polygon.corners[k];
      const Edge& edge = polygon.edges[k == first ? end - 1 : k - 1];  // that ends at the corner
      solid.corners.push_back({corner.after, corner.place, corner.before, corner.number});
      solid.edges.push_back({edge.to, edge.from, edge.number});
    }
  }
  for (const Edge& edge : solid.edges) {
    solid.inner_points.push_back(point_beside(edge, solid.edges));
  }
  return solid;
}

Solid moved(const Solid& solid, const Exact& t) {
  Solid result = solid;
  for (invariants::Ring& ring : result.rings) {
    for (Exact& place : ring) {
      place = place + t;
    }
  }
  for (Edge& edge : result.edges) {
    edge.from = edge.from + t;
    edge.to = edge.to + t;
  }
  for (Corner& corner : result.corners) {
    corner.before = corner.before + t;
    corner.place = corner.place + t;
    corner.after = corner.after + t;
  }
  for (Exact& x : result.inner_points) {
    x = x + t;
  }
  return result;
}

int location(const Solid& solid, const Exact& x) {
  bool inside = true;
  for (const invariants::Ring& ring : solid.rings) {
    const int side = invariants::location(ring, x);
    if (side == 0) {
      return 0;
    }
    inside = inside && (side > 0) == (&ring == &solid.rings.front());
  }
  return inside != solid.is_complement ? 1 : -1;
}

}  // namespace gcv::reference
