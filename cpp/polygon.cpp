// SPDX-License-Identifier: LGPL-3.0-or-later
#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "error.hpp"
#include "predicates.hpp"
#include "simplicity.hpp"

namespace gcv {

namespace {

// A boundary under preparation: points, with the caller's number of the vertex and of the
// edge behind it, and the sign of the turn at each: 1 left, -1 right, 0 none.
struct Chain {
  struct Mark {
    Index number;
    int turn;
  };
  PointVector points;
  Buffer<Mark> marks;

  [[nodiscard]] std::size_t size() const { return points.size(); }
  [[nodiscard]] std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  [[nodiscard]] std::size_t previous(std::size_t i) const { return (i == 0 ? size() : i) - 1; }
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
Chain without_repetitions(PointVector boundary) {
  std::size_t count = boundary.size();
  while (count > 1 && boundary[count - 1] == boundary[0]) {
    --count;
  }
  Chain chain{std::move(boundary), Buffer<Chain::Mark>(count)};
  std::size_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = chain.points[i];
    if (i + 1 < count && chain.points[i + 1] == p) {
      continue;
    }
    // Adding 0 turns -0 into 0.
    chain.points[kept] = {p.x + 0.0, p.y + 0.0};
    chain.marks[kept++].number = static_cast<Index>(i);
  }
  chain.points.resize(kept);
  chain.marks.resize(kept);
  return chain;
}

void find_turns(Chain& chain) {
  Tally tally;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    chain.marks[i].turn = orientation(chain.points[chain.previous(i)], chain.points[i],
                                      chain.points[chain.next(i)], tally);
  }
}

bool all_collinear(const Chain& chain) {
  return std::all_of(chain.marks.begin(), chain.marks.end(),
                     [](const Chain::Mark& mark) { return mark.turn == 0; });
}

// Does the chain turn back at q? p, q, r are collinear, q differs from p and r.
bool turns_back(const Point& p, const Point& q, const Point& r) {
  return p.x == q.x ? (p.y < q.y) != (q.y < r.y) : (p.x < q.x) != (q.x < r.x);
}

void check_simple(const Chain& chain, const Box& bounds, const char* name) {
  if (is_convex_ring(chain.points, [&](std::size_t i) { return chain.marks[i].turn; })) {
    return;
  }
  const auto conflict = find_conflict(chain.points, bounds);
  if (!conflict) {
    return;
  }
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const std::size_t before = chain.previous(i);
    const Point& q = chain.points[i];
    if (chain.marks[i].turn == 0 &&
        turns_back(chain.points[before], q, chain.points[chain.next(i)])) {
      throw Error(Status::not_simple,
                  "%s: edges %u and %u overlap: the ring turns back at vertex %u (%.17g, %.17g)",
                  name, chain.marks[before].number, chain.marks[i].number, chain.marks[i].number,
                  q.x, q.y);
    }
  }
  const Point& p = chain.points[conflict->first];
  const Point& q = chain.points[conflict->second];
  throw Error(Status::not_simple,
              "%s: edges %u and %u meet; they start at (%.17g, %.17g) and (%.17g, %.17g)", name,
              chain.marks[conflict->first].number, chain.marks[conflict->second].number, p.x, p.y,
              q.x, q.y);
}

// The corners of a simple chain, counter-clockwise from the lexicographically smallest one. Turned
// round, the edge behind a corner is the one that led to it; of the caller's edges on one straight
// line, the last is then the first.
void take_corners(const Chain& chain, Polygon& polygon) {
  const std::size_t first = lexicographic_min(chain.points);
  const int left = chain.marks[first].turn;  // no line passes through a smallest point
  const auto n = static_cast<std::size_t>(
      std::count_if(chain.marks.begin(), chain.marks.end(),
                    [](const Chain::Mark& mark) { return mark.turn != 0; }));
  polygon.vertices.resize(n);
  polygon.corners.resize(n);
  polygon.is_convex = true;
  std::size_t corner = 0;
  std::size_t i = first;
  do {
    const std::size_t before = chain.previous(i);
    if (chain.marks[i].turn != 0) {
      const bool is_convex = chain.marks[i].turn == left;
      polygon.vertices[corner] = chain.points[i];
      polygon.corners[corner] = {chain.marks[i].number, chain.marks[left > 0 ? i : before].number,
                                 is_convex};
      polygon.is_convex = polygon.is_convex && is_convex;
      ++corner;
    }
    i = left > 0 ? chain.next(i) : before;
  } while (i != first);
}

}  // namespace

Polygon make_polygon(PointVector boundary, const char* name) {
  constexpr std::size_t most = 0x7fffffff;
  const std::size_t given = boundary.size();
  if (given > most) {
    throw Error(Status::invalid_argument, "%s: %zu vertices are more than %zu", name, given, most);
  }
  check_finite(boundary, name);
  Chain chain = without_repetitions(std::move(boundary));
  if (chain.size() < 3) {
    throw Error(Status::degenerate,
                "%s: %zu distinct consecutive vertices of %zu, at least 3 are needed", name,
                chain.size(), given);
  }
  find_turns(chain);
  if (all_collinear(chain)) {
    throw Error(Status::degenerate, "%s: all %zu vertices lie on one line", name, given);
  }
  Polygon polygon;
  polygon.bounds = box_of(chain.points);
  check_simple(chain, polygon.bounds, name);
  take_corners(chain, polygon);
  polygon.lexicographic_max =
      static_cast<Index>(first_of(polygon.vertices, [](const Point& p, const Point& q) {
        return lexicographically_less(q, p);
      }));
  return polygon;
}

const ChainIndex& Polygon::index() const {
  return index_.get([this] {
    PointVector ring(std::size_t{size()} + 1);
    for (Index i = 0; i < size(); ++i) {
      ring[i] = relative(i);
    }
    ring.back() = ring.front();
    ChainIndex index{build_chain_tree(ring), {}};
    index.capsules = build_capsules(index.tree, ring);
    return index;
  });
}

Polygon reflected(const Polygon& polygon) {
  Polygon result = polygon;
  // 0 - x rather than -x: the reflection of 0 is 0, not -0.
  for (Point& p : result.vertices) {
    p = {0.0 - p.x, 0.0 - p.y};
  }
  result.bounds = {0.0 - polygon.bounds.x1, 0.0 - polygon.bounds.y1, 0.0 - polygon.bounds.x0,
                   0.0 - polygon.bounds.y0};
  std::swap(result.lexicographic_min, result.lexicographic_max);
  return result;
}

}  // namespace gcv
