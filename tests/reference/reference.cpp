// SPDX-License-Identifier: LGPL-3.0-or-later
#include "reference.hpp"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Rational_traits.h>
#include <CGAL/minkowski_sum_2.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace gcv::reference {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using ExactPoint = Kernel::Point_2;

ExactPoint exact_point(const SumPoint& p) {
  return {Kernel::FT(p.a.x) + Kernel::FT(p.b.x), Kernel::FT(p.a.y) + Kernel::FT(p.b.y)};
}

std::string fraction(const Kernel::FT& x) {
  using Rational = std::decay_t<decltype(x.exact())>;
  const CGAL::Rational_traits<Rational> traits;
  std::ostringstream text;
  text << traits.numerator(x.exact()) << '/' << traits.denominator(x.exact());
  return text.str();
}

// A counter-clockwise ring without its collinear vertices, from its smallest vertex.
FractionRing canonical(const std::vector<ExactPoint>& points) {
  std::vector<ExactPoint> corners;
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!CGAL::collinear(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) {
      corners.push_back(points[k]);
    }
  }
  std::rotate(corners.begin(),
              std::min_element(corners.begin(), corners.end(),
                               [](const ExactPoint& p, const ExactPoint& q) {
                                 return CGAL::lexicographically_xy_smaller(p, q);
                               }),
              corners.end());
  FractionRing ring;
  for (const ExactPoint& p : corners) {
    ring.push_back(fraction(p.x()) + " " + fraction(p.y()));
  }
  return ring;
}

CGAL::Polygon_2<Kernel> polygon(std::span<const Point> ring) {
  CGAL::Polygon_2<Kernel> result;
  for (const Point& p : ring) {
    result.push_back(ExactPoint(p.x, p.y));
  }
  return result;
}

}  // namespace

FractionRing arrangement_outer_face(std::span<const SupersetEdge> superset) {
  std::vector<Traits::X_monotone_curve_2> segments;
  for (const SupersetEdge& edge : superset) {
    segments.emplace_back(exact_point(edge.from), exact_point(edge.to));
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, segments.begin(), segments.end());
  const auto face = arrangement.unbounded_face();
  if (std::distance(face->inner_ccbs_begin(), face->inner_ccbs_end()) != 1) {
    throw std::runtime_error("the unbounded face of the arrangement is not bounded by one ring");
  }
  // The unbounded face lies to the left of its boundary, so that goes clockwise round the sum.
  std::vector<ExactPoint> points;
  const auto first = *face->inner_ccbs_begin();
  auto edge = first;
  do {
    points.push_back(edge->target()->point());
  } while (++edge != first);
  std::reverse(points.begin(), points.end());
  return canonical(points);
}

FractionRing reduced_convolution(std::span<const Point> a, std::span<const Point> b) {
  const auto sum = CGAL::minkowski_sum_by_reduced_convolution_2(polygon(a), polygon(b));
  const auto& outer = sum.outer_boundary();
  return canonical({outer.vertices_begin(), outer.vertices_end()});
}

std::vector<FractionRing> holes(std::span<const PointVector> a, std::span<const PointVector> b) {
  const auto with_holes = [](std::span<const PointVector> rings) {
    CGAL::Polygon_with_holes_2<Kernel> result;
    for (const PointVector& ring : rings) {
      CGAL::Polygon_2<Kernel> boundary = polygon(ring);
      if (boundary.is_clockwise_oriented() != (&ring != &rings.front())) {
        boundary.reverse_orientation();
      }
      if (&ring == &rings.front()) {
        result = CGAL::Polygon_with_holes_2<Kernel>(boundary);
      } else {
        result.add_hole(boundary);
      }
    }
    return result;
  };
  const auto sum = CGAL::minkowski_sum_by_reduced_convolution_2(with_holes(a), with_holes(b));
  std::vector<FractionRing> rings;
  for (const auto& hole : sum.holes()) {
    std::vector<ExactPoint> points(hole.vertices_begin(), hole.vertices_end());
    if (hole.is_clockwise_oriented()) {
      std::reverse(points.begin(), points.end());
    }
    rings.push_back(canonical(points));
  }
  return rings;
}

bool is_simple(std::span<const Point> ring) { return polygon(ring).is_simple(); }

}  // namespace gcv::reference
