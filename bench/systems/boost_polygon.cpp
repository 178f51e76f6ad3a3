// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Boost.Polygon's way to Minkowski sums: the union of the sums of all pairs of edges, which
// are parallelograms, and of one translate of each polygon.
#include <boost/polygon/polygon.hpp>
#include <iterator>
#include <stdexcept>

#include "grid.hpp"

namespace gcv::bench {

namespace {

namespace bp = boost::polygon;
using BoostPoint = bp::point_data<int>;
using BoostPolygon = bp::polygon_data<int>;
using BoostRing = std::vector<BoostPoint>;

BoostRing to_boost(const IntegerGrid<int>& grid, const Ring& ring) {
  BoostRing result;
  for (const Point& p : ring) {
    result.emplace_back(grid.to_grid(p.x), grid.to_grid(p.y));
  }
  return result;
}

BoostPoint sum(const BoostPoint& p, const BoostPoint& q) { return {p.x() + q.x(), p.y() + q.y()}; }

BoostPolygon translated(BoostRing ring, const BoostPoint& by) {
  for (BoostPoint& p : ring) {
    p = sum(p, by);
  }
  return {ring.begin(), ring.end()};
}

BoostPolygon parallelogram(const BoostPoint& p0, const BoostPoint& p1, const BoostPoint& q0,
                           const BoostPoint& q1) {
  const BoostPoint corners[] = {sum(p0, q0), sum(p1, q0), sum(p1, q1), sum(p0, q1)};
  return {std::begin(corners), std::end(corners)};
}

BoostPolygon minkowski_sum(const BoostRing& a, const BoostRing& b) {
  bp::polygon_set_data<int> parts;
  parts.insert(translated(a, b[0]));
  parts.insert(translated(b, a[0]));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      parts.insert(parallelogram(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]));
    }
  }
  std::vector<bp::polygon_with_holes_data<int>> sums;
  parts.get(sums);
  if (sums.empty()) {
    throw std::runtime_error("empty");
  }
  const auto largest = std::max_element(sums.begin(), sums.end(), [](const auto& p, const auto& q) {
    return bp::area(p) < bp::area(q);
  });
  return {largest->begin(), largest->end()};
}

}  // namespace

Job boost_polygon(const Ring& a, const Ring& b, double cells_per_unit) {
  return {[&a, &b, cells_per_unit] {
    const IntegerGrid<int> grid(cells_per_unit);
    const BoostPolygon boundary = minkowski_sum(to_boost(grid, a), to_boost(grid, b));
    Ring ring;
    for (const BoostPoint& p : boundary) {
      ring.push_back({grid.from_grid(p.x()), grid.from_grid(p.y())});
    }
    return ring;
  }};
}

}  // namespace gcv::bench
