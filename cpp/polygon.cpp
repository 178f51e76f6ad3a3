// SPDX-License-Identifier: LGPL-3.0-or-later
#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "error.hpp"
#include "predicates.hpp"
#include "simplicity.hpp"

namespace gcv {

namespace {

// A boundary under preparation: points with the caller's numbers of the vertex and of
// the edge behind it.
struct Chain {
  std::vector<Point> points;
  std::vector<Index> vertex;
  std::vector<Index> edge;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i == 0 ? size() : i) - 1; }

  void reserve(std::size_t n) {
    points.reserve(n);
    vertex.reserve(n);
    edge.reserve(n);
  }
  void append(const Point& point, Index vertex_number, Index edge_number) {
    points.push_back(point);
    vertex.push_back(vertex_number);
    edge.push_back(edge_number);
  }
};

void check_finite(std::span<const Point> boundary, const char* name) {
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    const Point& p = boundary[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      throw Error(Status::not_finite,
                  "%s: the %s coordinate of vertex %zu is %g, not a finite number", name,
                  std::isfinite(p.x) ? "y" : "x", i, std::isfinite(p.x) ? p.y : p.x);
    }
  }
}

// Without the closing vertex and without repeated vertices, of which the last stays:
// the edge behind it is the one that leads on.
Chain without_repetitions(std::span<const Point> boundary) {
  std::size_t count = boundary.size();
  while (count > 1 && boundary[count - 1] == boundary[0]) {
    --count;
  }
  Chain chain;
  chain.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Point& p = boundary[i];
    if (i + 1 < count && boundary[i + 1] == p) {
      continue;
    }
    // Adding 0 turns -0 into 0.
    chain.append({p.x + 0.0, p.y + 0.0}, static_cast<Index>(i), static_cast<Index>(i));
  }
  return chain;
}

bool all_collinear(const Chain& chain, Tally& tally) {
  for (std::size_t i = 2; i < chain.size(); ++i) {
    if (orientation(chain.points[0], chain.points[1], chain.points[i], tally) != 0) {
      return false;
    }
  }
  return true;
}

// Does the chain turn back at q? p, q, r are collinear, q differs from p and r.
bool turns_back(const Point& p, const Point& q, const Point& r) {
  return p.x == q.x ? (p.y < q.y) != (q.y < r.y) : (p.x < q.x) != (q.x < r.x);
}

bool points_up(const Point& p, const Point& q) { return p.y < q.y || (p.y == q.y && p.x < q.x); }

// Does the chain turn the same way at every vertex, and once round in all? Then it is the
// boundary of a convex polygon, and simple. Turning by less than half a turn each time, it
// goes round once where its edges change once from pointing up to pointing down.
bool is_convex_ring(const Chain& chain, Tally& tally) {
  const std::size_t n = chain.size();
  const auto turn_at = [&](std::size_t i) {
    return orientation(chain.points[chain.previous(i)], chain.points[i],
                       chain.points[chain.next(i)], tally);
  };
  const int sense = turn_at(0);
  std::size_t changes = 0;
  bool up = points_up(chain.points[n - 1], chain.points[0]);
  for (std::size_t i = 0; i < n; ++i) {
    if (sense == 0 || turn_at(i) != sense) {
      return false;
    }
    const bool was_up = std::exchange(up, points_up(chain.points[i], chain.points[chain.next(i)]));
    changes += was_up && !up ? 1 : 0;
  }
  return changes == 1;
}

void check_simple(const Chain& chain, const char* name, Tally& tally) {
  if (is_convex_ring(chain, tally)) {
    return;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t before = chain.previous(i);
    const Point& p = chain.points[before];
    const Point& q = chain.points[i];
    const Point& r = chain.points[chain.next(i)];
    if (orientation(p, q, r, tally) == 0 && turns_back(p, q, r)) {
      throw Error(Status::not_simple,
                  "%s: edges %u and %u overlap: the ring turns back at vertex %u (%.17g, %.17g)",
                  name, chain.edge[before], chain.edge[i], chain.vertex[i], q.x, q.y);
    }
  }
  if (const auto conflict = find_conflict(chain.points)) {
    const Point& p = chain.points[conflict->first];
    const Point& q = chain.points[conflict->second];
    throw Error(Status::not_simple,
                "%s: edges %u and %u meet; they start at (%.17g, %.17g) and (%.17g, %.17g)", name,
                chain.edge[conflict->first], chain.edge[conflict->second], p.x, p.y, q.x, q.y);
  }
}

Chain without_collinear(const Chain& chain, Tally& tally) {
  Chain corners;
  corners.reserve(chain.size());
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (orientation(chain.points[chain.previous(i)], chain.points[i], chain.points[chain.next(i)],
                    tally) != 0) {
      corners.append(chain.points[i], chain.vertex[i], chain.edge[i]);
    }
  }
  return corners;
}

// Turns a clockwise simple ring round. Edge i, from vertex i to i+1, becomes the edge
// that starts at vertex i+1; of the caller's edges on one straight line, the first
// along the new ring is the last of the old one, just before vertex i+1 in `chain`.
void make_counter_clockwise(Chain& corners, const Chain& chain) {
  if (is_counter_clockwise(corners.points)) {
    return;
  }
  std::size_t k = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    while (chain.vertex[k] != corners.vertex[i]) {
      ++k;
    }
    corners.edge[i] = chain.edge[chain.previous(k)];
  }
  std::reverse(corners.points.begin(), corners.points.end());
  std::reverse(corners.vertex.begin(), corners.vertex.end());
  std::reverse(corners.edge.begin(), corners.edge.end());
}

void start_at_lexicographic_min(Chain& chain) {
  const auto shift =
      std::min_element(chain.points.begin(), chain.points.end(), lexicographically_less) -
      chain.points.begin();
  std::rotate(chain.points.begin(), chain.points.begin() + shift, chain.points.end());
  std::rotate(chain.vertex.begin(), chain.vertex.begin() + shift, chain.vertex.end());
  std::rotate(chain.edge.begin(), chain.edge.begin() + shift, chain.edge.end());
}

// dx / (|dx| + |dy|), which falls as the angle of (dx, dy) grows from 0 to half a turn; NaN
// where that overflows. With u = 2^-53: each coordinate was rounded once, by u of itself at
// most, for differences of doubles do not underflow. That moves the exact quotient f by
// 2u |f| (1 - |f|) <= u / 2, and the sum and the quotient add u |f| <= u each; where the
// quotient underflows, 2^-1075. So a key is off by less than 3u, a difference of two keys,
// rounded by 2u, by less than 8u; key_tolerance is 16u. Keys that are further apart than
// that are in the exact order of their angles.
double direction_key(double dx, double dy) {
  const double size = std::abs(dx) + std::abs(dy);
  return std::isfinite(size) ? dx / size : std::numeric_limits<double>::quiet_NaN();
}
constexpr double key_tolerance = 8 * std::numeric_limits<double>::epsilon();

void sort_directions(Polygon& polygon, Tally& tally) {
  const Index n = polygon.size();
  polygon.upper.resize(n);
  std::vector<double> keys(n);
  for (Index i = 0; i < n; ++i) {
    const Point& p = polygon.vertices[i];
    const Point& q = polygon.vertices[polygon.next(i)];
    polygon.upper[i] = points_up(p, q);
    keys[i] = polygon.upper[i] != 0 ? direction_key(q.x - p.x, q.y - p.y)
                                    : direction_key(p.x - q.x, p.y - q.y);
  }
  const auto compare = [&](Index i, Index j) {
    const double difference = keys[i] - keys[j];
    if (std::abs(difference) > key_tolerance) {
      return difference > 0 ? 1 : -1;
    }
    const Index from_i = polygon.upper[i] != 0 ? i : polygon.next(i);
    const Index from_j = polygon.upper[j] != 0 ? j : polygon.next(j);
    const Index to_i = polygon.upper[i] != 0 ? polygon.next(i) : i;
    const Index to_j = polygon.upper[j] != 0 ? polygon.next(j) : j;
    return turn(polygon.vertices[from_i], polygon.vertices[to_i], polygon.vertices[from_j],
                polygon.vertices[to_j], tally);
  };
  std::vector<Index> order(n);
  std::iota(order.begin(), order.end(), Index{0});
  const auto before = [&](Index i, Index j) { return compare(i, j) > 0; };
  if (polygon.is_convex) {
    // The lowest vertex starts the edges that point up, the highest those that point down.
    const auto up = std::find_if(order.begin(), order.end(), [&](Index i) {
      return polygon.upper[i] != 0 && polygon.upper[polygon.previous(i)] == 0;
    });
    std::rotate(order.begin(), up, order.end());
    const auto down =
        std::find_if(order.begin(), order.end(), [&](Index i) { return polygon.upper[i] == 0; });
    std::inplace_merge(order.begin(), down, order.end(), before);
  } else {
    std::sort(order.begin(), order.end(), before);
  }
  polygon.line_of_edge.resize(n);
  polygon.edge_of_line.reserve(n);
  for (Index k = 0; k < n; ++k) {
    if (k == 0 || compare(order[k - 1], order[k]) != 0) {
      polygon.edge_of_line.push_back(order[k]);
    }
    polygon.line_of_edge[order[k]] = static_cast<Index>(polygon.edge_of_line.size() - 1);
  }
}

void mark_convex(Polygon& polygon, Tally& tally) {
  polygon.convex.resize(polygon.size());
  for (Index i = 0; i < polygon.size(); ++i) {
    polygon.convex[i] = orientation(polygon.vertices[polygon.previous(i)], polygon.vertices[i],
                                    polygon.vertices[polygon.next(i)], tally) > 0;
  }
  polygon.is_convex =
      std::find(polygon.convex.begin(), polygon.convex.end(), 0) == polygon.convex.end();
}

void prepare_searches(Polygon& polygon) {
  const Point& origin = polygon.vertices.front();
  polygon.bounds = {origin.x, origin.y, origin.x, origin.y};
  Box& bounds = polygon.bounds;
  polygon.relative.reserve(polygon.size());
  for (const Point& p : polygon.vertices) {
    polygon.relative.push_back({p.x - origin.x, p.y - origin.y});
    bounds = {std::min(bounds.x0, p.x), std::min(bounds.y0, p.y), std::max(bounds.x1, p.x),
              std::max(bounds.y1, p.y)};
  }
  polygon.tree = build_chain_tree(polygon.relative);
  polygon.capsules = build_capsules(polygon.tree, polygon.relative);
}

}  // namespace

Polygon make_polygon(std::span<const Point> boundary, const char* name) {
  constexpr std::size_t most = 0x7fffffff;
  if (boundary.size() > most) {
    throw Error(Status::invalid_argument, "%s: %zu vertices are more than %zu", name,
                boundary.size(), most);
  }
  check_finite(boundary, name);
  Tally tally;
  const Chain chain = without_repetitions(boundary);
  if (chain.size() < 3) {
    throw Error(Status::degenerate,
                "%s: %zu distinct consecutive vertices of %zu, at least 3 are needed", name,
                chain.size(), boundary.size());
  }
  if (all_collinear(chain, tally)) {
    throw Error(Status::degenerate, "%s: all %zu vertices lie on one line", name, boundary.size());
  }
  check_simple(chain, name, tally);
  Chain corners = without_collinear(chain, tally);
  make_counter_clockwise(corners, chain);
  start_at_lexicographic_min(corners);

  Polygon polygon;
  polygon.vertices = std::move(corners.points);
  polygon.vertex_number = std::move(corners.vertex);
  polygon.edge_number = std::move(corners.edge);
  polygon.lexicographic_max = static_cast<Index>(
      std::max_element(polygon.vertices.begin(), polygon.vertices.end(), lexicographically_less) -
      polygon.vertices.begin());
  mark_convex(polygon, tally);
  sort_directions(polygon, tally);
  prepare_searches(polygon);
  return polygon;
}

Polygon reflected(const Polygon& polygon) {
  Polygon result = polygon;
  // 0 - x rather than -x: the reflection of 0 is 0, not -0.
  for (Point& p : result.vertices) {
    p = {0.0 - p.x, 0.0 - p.y};
  }
  for (Point& p : result.relative) {
    p = {0.0 - p.x, 0.0 - p.y};
  }
  const auto reflect = [](Box& box) {
    box = {0.0 - box.x1, 0.0 - box.y1, 0.0 - box.x0, 0.0 - box.y0};
  };
  for (ChainTree::Block& block : result.tree.blocks) {
    for (unsigned k = 0; k < ChainTree::width; ++k) {
      Box box = block.box(k);
      reflect(box);
      block.put(k, box);
    }
  }
  for (CapsuleBlock& block : result.capsules) {
    for (std::uint32_t end = 0; end <= ChainTree::width; ++end) {
      block.x[end] = 0.0 - block.x[end];
      block.y[end] = 0.0 - block.y[end];
    }
  }
  reflect(result.tree.box);
  reflect(result.bounds);
  for (std::uint8_t& upper : result.upper) {
    upper ^= 1;
  }
  std::swap(result.lexicographic_min, result.lexicographic_max);
  return result;
}

}  // namespace gcv
