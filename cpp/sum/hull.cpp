// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The vertices of A and of B that are furthest in one direction, and of those the furthest
// a quarter turn counter-clockwise from it, add up to a vertex of the hull of the sum, which
// is a sum in no other way: both are unique. As the direction turns, the sums follow each
// other counter-clockwise.
#include "hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parallel.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// Arcs are of unequal length: more of them than threads are shared out better.
constexpr unsigned arcs_per_thread = 8;
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

// The vertex that is furthest in the direction d, whose coordinates are small integers. Only convex
// ones can be. Of the sums of two products, 4u of what they add up is more than their roundings;
// the bound is twice as large, and where it overflows, no vertex is left out.
Index furthest(const Boundary& polygon, const Point& d) {
  const auto along = [&](const Point& p) { return d.x * p.x + d.y * p.y; };
  const Box& box = polygon.bounds;
  const double size = std::abs(d.x) * std::max(std::abs(box.x0), std::abs(box.x1)) +
                      std::abs(d.y) * std::max(std::abs(box.y0), std::abs(box.y1));
  const double tolerance = 4 * std::numeric_limits<double>::epsilon() * size;
  double most = along(polygon.vertices.front());
  std::vector<Index> furthest_so_far;
  for (Index i = 0; i < polygon.size(); ++i) {
    const double distance = along(polygon.vertices[i]);
    if (distance < most - tolerance || !polygon.corners[i].convex) {
      continue;
    }
    if (distance > most + tolerance) {
      furthest_so_far.clear();
    }
    furthest_so_far.push_back(i);
    most = std::max(most, distance);
  }
  const Point origin{0, 0};
  const Point quarter_turn{-d.y, d.x};
  Tally tally;
  Index best = polygon.lexicographic_min;
  for (const Index i : furthest_so_far) {
    const Point& q = polygon.vertices[i];
    const Point& p = polygon.vertices[best];
    // With v = q - p: v x quarter_turn = <v, d>, and -v x d = <v, quarter_turn>.
    const int order = turn(p, q, origin, quarter_turn, tally);
    if (order > 0 || (order == 0 && turn(q, p, origin, d, tally) > 0)) {
      best = i;
    }
  }
  return best;
}

}  // namespace

HullVertices hull_vertices(const Boundary& a, const Boundary& b, unsigned threads) {
  HullVertices vertices{{a.lexicographic_min, b.lexicographic_min}};
  if (threads <= 1) {
    return vertices;
  }
  const unsigned eighth =
      (std::min(most_arcs / arcs_per_thread, threads) * arcs_per_thread + 7) / 8;
  std::vector<VertexSum> extremes(std::size_t{8} * eighth);
  for_each_in_parallel(extremes.size(), threads, [&](std::size_t k) {
    const Point d = direction(static_cast<unsigned>(k), eighth);
    extremes[k] = {furthest(a, d), furthest(b, d)};
  });
  for (const VertexSum& vertex : extremes) {
    const VertexSum& previous = vertices.back();
    if (vertex.i != previous.i || vertex.j != previous.j) {
      vertices.push_back(vertex);
    }
  }
  const VertexSum& last = vertices.back();
  if (vertices.size() > 1 && last.i == vertices.front().i && last.j == vertices.front().j) {
    vertices.pop_back();
  }
  return vertices;
}

}  // namespace gcv
