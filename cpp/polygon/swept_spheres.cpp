// SPDX-License-Identifier: LGPL-3.0-or-later
#include "swept_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "box.hpp"
#include "task.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

struct SweptSphere {
  Point from;
  Point to;
  double radius;
};

Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }

// A line-swept sphere in the given direction that holds the points: its segment is the middle of
// their box in that direction. The ends are not rounded off. The direction must not be null.
//
// Error bound. The unit vector is off by 5 u, so its square is off by 10 u. A point goes along and
// across the unit vector and back again, and is off by as much. Products and sums add less than 14
// u of the extents.
SweptSphere swept_sphere_along(const Point& direction, std::span<const Point> points) {
  const Point unit = unit_vector(direction);
  const Point& origin = points.front();
  Box box{0, 0, 0, 0};  // relative to the origin: x along the unit vector, y across
  for (const Point& p : points.subspan(1)) {
    const Point d = p - origin;
    const double along = unit.x * d.x + unit.y * d.y;
    const double across = unit.x * d.y - unit.y * d.x;
    box = {std::min(box.x0, along), std::min(box.y0, across), std::max(box.x1, along),
           std::max(box.y1, across)};
  }
  const double middle = (box.y0 + box.y1) / 2;
  const Point foot{origin.x - middle * unit.y, origin.y + middle * unit.x};
  return {{foot.x + box.x0 * unit.x, foot.y + box.x0 * unit.y},
          {foot.x + box.x1 * unit.x, foot.y + box.x1 * unit.y},
          (box.y1 - box.y0) / 2};
}

// The line-swept sphere of edges. The points are those of a chain, with one for each further edge,
// or both ends of each edge. It is the thinner one of two: along the chord, which suits a smooth
// chain, and along the longest edge, which suits a chain that goes to and fro.
SweptSphere swept_sphere_of(std::span<const Point> points, std::size_t points_an_edge) {
  if (points.size() == 2) {
    return {points.front(), points.back(), 0};
  }
  Point longest{0, 0};
  double longest_size = 0;
  for (std::size_t i = 1; i < points.size(); i += points_an_edge) {
    const Point edge = points[i] - points[i - 1];
    const double size = std::abs(edge.x) + std::abs(edge.y);
    if (size > longest_size) {
      longest_size = size;
      longest = edge;
    }
  }
  if (longest_size == 0) {  // all points were rounded to one
    return {points.front(), points.front(), 0};
  }
  const SweptSphere along_edge = swept_sphere_along(longest, points);
  const Point chord = points.back() - points.front();
  if (chord == Point{0, 0}) {
    return along_edge;
  }
  const SweptSphere along_chord = swept_sphere_along(chord, points);
  return along_edge.radius < along_chord.radius ? along_edge : along_chord;
}

// points(first, count): those of so many edges from the first of them on.
template <class Points>
std::vector<SweptSphereBlock> build(const ChainTree& tree, std::size_t n,
                                    std::size_t points_an_edge, Points points) {
  constexpr std::uint32_t width = ChainTree::width;
  std::vector<SweptSphereBlock> spheres(tree.blocks.size());
  std::size_t below = 1;  // edges below a node
  Pace pace;
  for (std::size_t depth = tree.first_block.size(); depth-- > 0; below *= width) {
    for (std::size_t node = 0; node * below < n; ++node) {
      const std::size_t first = node * below;
      const std::size_t edges = std::min(below, n - first);
      pace.step(edges);
      const SweptSphere sphere = swept_sphere_of(points(first, edges), points_an_edge);
      SweptSphereBlock& block = spheres[tree.first_block[depth] + node / width];
      const std::size_t lane = node % width;
      block.x0[lane] = sphere.from.x;
      block.y0[lane] = sphere.from.y;
      block.x1[lane] = sphere.to.x;
      block.y1[lane] = sphere.to.y;
      block.radius[lane] = sphere.radius;
    }
  }
  return spheres;
}

}  // namespace

std::vector<SweptSphereBlock> build_swept_spheres(const ChainTree& tree, const EdgeChain& chain,
                                                  std::span<const Index> order) {
  if (order.empty()) {
    return build(tree, chain.size(), 1, [&](std::size_t first, std::size_t count) {
      return chain.ends(static_cast<Index>(first), static_cast<Index>(count));
    });
  }
  PointVector points;
  points.reserve(2 * order.size());
  for (const Index edge : order) {
    const auto ends = chain.ends(edge, 1);
    points.push_back(ends.front());
    points.push_back(ends.back());
  }
  return build(tree, order.size(), 2, [&](std::size_t first, std::size_t count) {
    return std::span<const Point>(points).subspan(2 * first, 2 * count);
  });
}

}  // namespace gcv
