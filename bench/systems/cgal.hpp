// SPDX-License-Identifier: LGPL-3.0-or-later
//
// To and from CGAL's polygons (GPL: never included by what is shipped).
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <memory>
#include <utility>

#include "system.hpp"

namespace gcv::bench {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalPolygon = CGAL::Polygon_2<Kernel>;

inline CgalPolygon to_cgal(const Ring& ring) {
  CgalPolygon polygon;
  for (const Point& p : ring) {
    polygon.push_back(Kernel::Point_2(p.x, p.y));
  }
  return polygon;
}

inline Ring to_doubles(const CgalPolygon& polygon) {
  Ring ring;
  ring.reserve(polygon.size());
  for (const Kernel::Point_2& p : polygon.container()) {
    ring.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
  }
  return ring;
}

inline std::size_t count_corners(const CgalPolygon& polygon) {
  const std::size_t n = polygon.size();
  std::size_t corners = 0;
  for (std::size_t k = 0; k < n; ++k) {
    corners += CGAL::collinear(polygon[k], polygon[(k + 1) % n], polygon[(k + 2) % n]) ? 0 : 1;
  }
  return corners;
}

// The job of a function that gives the outer boundary of the sum of two of CGAL's polygons.
template <class Sum>
Job cgal_job(const Ring& a, const Ring& b, Sum sum) {
  auto boundary = std::make_shared<CgalPolygon>();
  return {[&a, &b, sum, boundary] {
            *boundary = sum(to_cgal(a), to_cgal(b));
            return to_doubles(*boundary);
          },
          [boundary] {
            return Observation{count_corners(*boundary), 0, 0, 0};
          }};
}

}  // namespace gcv::bench
