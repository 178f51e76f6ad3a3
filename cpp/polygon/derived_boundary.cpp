// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boundaries that are made of others.
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

#include "boundary.hpp"
#include "box.hpp"
#include "double_double.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// p + position - (origin + at); infinite where that overflows.
double seen_from(double p, double position, double origin, double at) {
  const double sum = rounded_sum(p, position, -origin, -at);
  return std::isnan(sum) ? (p - origin) + (position - at) : sum;
}

// The vertices of joined boundaries, seen from the first one.
PointVector seen_from_first(const PointVector& vertices, const PointVector& positions) {
  const Point& origin = vertices.front();
  const Point& at = positions.front();
  PointVector seen(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    seen[i] = {seen_from(vertices[i].x, positions[i].x, origin.x, at.x),
               seen_from(vertices[i].y, positions[i].y, origin.y, at.y)};
  }
  return seen;
}

}  // namespace

Boundary joined(std::span<const PlacedBoundary> parts) {
  Boundary all;
  all.kind = parts.front().boundary.kind;
  bool is_first = true;
  Pace pace;
  for (const auto& [boundary, position] : parts) {
    pace.step(2 * std::uint64_t{boundary.size()});
    const Index ring_count = is_first ? 0 : all.layout.ring_count();
    if (boundary.solids.empty()) {
      all.solids.push_back(ring_count);
    }
    for (const Index ring : boundary.solids) {
      all.solids.push_back(ring_count + ring);
    }
    for (Index ring = 0; ring < boundary.layout.ring_count(); ++ring) {
      const Index size = boundary.layout.end(ring) - boundary.layout.begin(ring);
      if (is_first) {
        all.layout = RingLayout(size);
        is_first = false;
      } else {
        all.layout.add(size);
      }
    }
    all.joined_pieces_.add(boundary.convex_pieces(), all.size());
    all.vertices.insert(all.vertices.end(), boundary.vertices.begin(), boundary.vertices.end());
    all.corners.insert(all.corners.end(), boundary.corners.begin(), boundary.corners.end());
    all.positions.insert(all.positions.end(), boundary.size(), position);
  }
  all.relatives = seen_from_first(all.vertices, all.positions);
  if (all.solids.size() == 1) {
    all.solids.clear();
  }
  all.bounds = box_of(all.relatives);
  return all;
}

Boundary joined(const Boundary& outer, std::span<const Boundary* const> holes) {
  Boundary all = outer;
  all.mirror_ = nullptr;  // it has the outer ring alone
  for (const Boundary* const hole : holes) {
    all.vertices.insert(all.vertices.end(), hole->vertices.begin(), hole->vertices.end());
    all.corners.insert(all.corners.end(), hole->corners.begin(), hole->corners.end());
    all.layout.add(hole->size());
  }
  all.is_convex = outer.is_convex && holes.empty();
  return all;
}

Boundary Boundary::complement() const {
  Boundary result;
  result.layout = layout;
  result.vertices.resize(size());
  result.corners.resize(size());
  for (Index ring = 0; ring < layout.ring_count(); ++ring) {
    Index from = layout.begin(ring);
    for (Index i = from; i < layout.end(ring); ++i) {
      const Corner& corner = corners[from];
      const Index before = previous(from);
      result.vertices[i] = vertices[from];
      result.corners[i] = {corner.vertex_number, corners[before].edge_number, !corner.convex};
      from = before;
    }
  }
  result.kind = kind == Kind::outer ? Kind::hole : Kind::outer;
  for (Index ring = 0; layout.ring_count() > 1 && ring < layout.ring_count(); ++ring) {
    result.solids.push_back(ring);
  }
  result.bounds = bounds;
  result.lexicographic_min = lexicographic_min;
  result.lexicographic_max =
      lexicographic_max == 0 ? 0
                             : layout.end(layout.ring_of(lexicographic_max)) - lexicographic_max;
  return result;
}

Boundary Boundary::reflected(std::shared_ptr<const Boundary> ring) {
  assert(ring->size() >= 3);
  Boundary result = *ring;
  // 0 - x rather than -x: the reflection of 0 is 0, not -0.
  for (Point& p : result.vertices) {
    p = {0.0 - p.x, 0.0 - p.y};
  }
  const Box& bounds = ring->bounds;
  result.bounds = {0.0 - bounds.x1, 0.0 - bounds.y1, 0.0 - bounds.x0, 0.0 - bounds.y0};
  std::swap(result.lexicographic_min, result.lexicographic_max);
  result.mirror_ = std::move(ring);
  return result;
}

Boundary Boundary::scaled(double scale) const {
  Boundary result = *this;
  result.mirror_ = nullptr;  // it has another scale
  for (PointVector* const points : {&result.vertices, &result.positions}) {
    for (Point& p : *points) {
      p = {scale * p.x, scale * p.y};
    }
  }
  result.bounds = gcv::scaled(bounds, scale);
  if (!positions.empty()) {
    result.relatives = seen_from_first(result.vertices, result.positions);
    result.bounds = box_of(result.relatives);
  }
  if (crowd) {
    result.crowd = gcv::scaled(*crowd, scale);
  }
  return result;
}

}  // namespace gcv
