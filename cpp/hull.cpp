// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The vertices of A and of B that are furthest in one direction, and of those the furthest
// a quarter turn counter-clockwise from it, add up to a vertex of the hull of the sum, which
// is a sum in no other way: both are unique. As the direction turns, the sums follow each
// other counter-clockwise.
#include "hull.hpp"

#include <algorithm>

#include "parallel.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// Arcs are of unequal length: more of them than threads are shared out better.
constexpr unsigned arcs_per_thread = 4;
constexpr unsigned most_arcs = 256;

// The k-th of 8 `eighth` directions: counter-clockwise round a square, from (-1, 0).
Point direction(unsigned k, unsigned eighth) {
  const double size = eighth;
  const double along = k % (2 * eighth);
  switch (k / (2 * eighth)) {
    case 0:
      return along <= size ? Point{-size, -along} : Point{along - 2 * size, -size};
    case 1:
      return along <= size ? Point{along, -size} : Point{size, along - 2 * size};
    case 2:
      return along <= size ? Point{size, along} : Point{2 * size - along, size};
    default:
      return along <= size ? Point{-along, size} : Point{-size, 2 * size - along};
  }
}

// The vertex that is furthest in the direction d. Only convex ones can be.
Index furthest(const Polygon& polygon, const Point& d) {
  const Point origin{0, 0};
  const Point quarter_turn{-d.y, d.x};
  Tally tally;
  Index best = polygon.lexicographic_min;
  for (Index i = 0; i < polygon.size(); ++i) {
    if (polygon.convex[i] == 0) {
      continue;
    }
    const Point& p = polygon.vertices[best];
    const Point& q = polygon.vertices[i];
    // With v = q - p: v x quarter_turn = <v, d>, and -v x d = <v, quarter_turn>.
    const int order = turn(p, q, origin, quarter_turn, tally);
    if (order > 0 || (order == 0 && turn(q, p, origin, d, tally) > 0)) {
      best = i;
    }
  }
  return best;
}

}  // namespace

std::vector<HullVertex> hull_vertices(const Polygon& a, const Polygon& b, unsigned threads) {
  std::vector<HullVertex> vertices{{a.lexicographic_min, b.lexicographic_min}};
  if (threads <= 1) {
    return vertices;
  }
  const unsigned eighth =
      (std::min(most_arcs / arcs_per_thread, threads) * arcs_per_thread + 7) / 8;
  std::vector<HullVertex> extremes(std::size_t{8} * eighth);
  for_each_in_parallel(extremes.size(), threads, [&](std::size_t k) {
    const Point d = direction(static_cast<unsigned>(k), eighth);
    extremes[k] = {furthest(a, d), furthest(b, d)};
  });
  for (const HullVertex& vertex : extremes) {
    const HullVertex& previous = vertices.back();
    if (vertex.i != previous.i || vertex.j != previous.j) {
      vertices.push_back(vertex);
    }
  }
  const HullVertex& last = vertices.back();
  if (vertices.size() > 1 && last.i == vertices.front().i && last.j == vertices.front().j) {
    vertices.pop_back();
  }
  return vertices;
}

}  // namespace gcv
