// SPDX-License-Identifier: LGPL-3.0-or-later
#include "decomposition_reference.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_nop_decomposition_2.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Rational_traits.h>
#include <CGAL/minkowski_sum_2.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <sstream>

namespace gcv::reference {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPoint = Kernel::Point_2;
using Vector = Kernel::Vector_2;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;
using Pieces = std::vector<Polygon>;

Polygon turned(Polygon polygon, bool counter_clockwise) {
  if (polygon.is_counterclockwise_oriented() != counter_clockwise) {
    polygon.reverse_orientation();
  }
  return polygon;
}

// The ring, or its reflection in the origin, without repeated vertices.
Polygon exact(const PointVector& ring, int sign, bool counter_clockwise) {
  Polygon polygon;
  for (const Point& p : ring) {
    const ExactPoint q(sign * p.x, sign * p.y);
    if (polygon.is_empty() || (q != *std::prev(polygon.end()) && q != *polygon.begin())) {
      polygon.push_back(q);
    }
  }
  return turned(polygon, counter_clockwise);
}

// Into triangles: CGAL's other decompositions do not take rings that touch.
void decompose(const PolygonWithHoles& polygon, Pieces& pieces) {
  CGAL::Polygon_triangulation_decomposition_2<Kernel>()(polygon, std::back_inserter(pieces));
}

Pieces pieces_of(const Rings& rings, int sign) {
  PolygonWithHoles polygon(exact(rings.front(), sign, true));
  for (std::size_t k = 1; k < rings.size(); ++k) {
    polygon.add_hole(exact(rings[k], sign, false));
  }
  Pieces pieces;
  decompose(polygon, pieces);
  return pieces;
}

PolygonSet union_of_sums(const Pieces& a, const Pieces& b) {
  const CGAL::Polygon_nop_decomposition_2<Kernel> as_it_is;
  Pieces sums;
  for (const Polygon& p : a) {
    for (const Polygon& q : b) {
      sums.push_back(CGAL::minkowski_sum_2(p, q, as_it_is).outer_boundary());
    }
  }
  PolygonSet result;
  result.join(sums.begin(), sums.end());
  return result;
}

Polygon rectangle(const CGAL::Bbox_2& box) {
  Polygon polygon;
  polygon.push_back(ExactPoint(box.xmin(), box.ymin()));
  polygon.push_back(ExactPoint(box.xmax(), box.ymin()));
  polygon.push_back(ExactPoint(box.xmax(), box.ymax()));
  polygon.push_back(ExactPoint(box.xmin(), box.ymax()));
  return polygon;
}

// ---- Rings

std::string fraction(const Kernel::FT& x) {
  using Rational = std::decay_t<decltype(x.exact())>;
  const CGAL::Rational_traits<Rational> traits;
  std::ostringstream text;
  text << traits.numerator(x.exact()) << '/' << traits.denominator(x.exact());
  return text.str();
}

std::vector<std::string> canonical(const std::vector<ExactPoint>& points, const Vector& shift) {
  std::vector<ExactPoint> corners;
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!CGAL::collinear(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) {
      corners.push_back(points[k]);
    }
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  std::vector<std::string> ring;
  for (const ExactPoint& p : corners) {
    const ExactPoint moved = p + shift;
    ring.push_back(fraction(moved.x()) + " " + fraction(moved.y()));
  }
  return ring;
}

// Cut wherever it comes to a vertex again.
void put_simple_rings(const std::vector<ExactPoint>& walk, const Vector& shift,
                      RegionRings& rings) {
  std::vector<ExactPoint> open;
  const auto close = [&](auto from) {
    rings.push_back(canonical({from, open.end()}, shift));
    open.erase(from, open.end());
  };
  for (const ExactPoint& p : walk) {
    const auto earlier = std::find(open.begin(), open.end(), p);
    if (earlier != open.end()) {
      close(earlier);
    }
    open.push_back(p);
  }
  close(open.begin());
}

// The edges of the set, each with the inside on its left. CGAL's own rings may go on round another
// part of the inside where rings touch. So they are linked anew.
class Edges {
 public:
  explicit Edges(const PolygonSet& set) {
    std::vector<PolygonWithHoles> polygons;
    set.polygons_with_holes(std::back_inserter(polygons));
    for (const PolygonWithHoles& polygon : polygons) {
      add(polygon.outer_boundary());
      for (const Polygon& hole : polygon.holes()) {
        add(hole);
      }
    }
  }

  RegionRings rings(const Vector& shift) {
    RegionRings result;
    for (auto& [from, edges] : edges_) {
      for (Edge& edge : edges) {
        std::vector<ExactPoint> walk;
        for (Edge* e = &edge; !e->visited; e = &next(*e)) {
          e->visited = true;
          walk.push_back(e->to);
        }
        if (!walk.empty()) {
          put_simple_rings(walk, shift, result);
        }
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

 private:
  struct Edge {
    Kernel::Direction_2 direction;
    ExactPoint to;
    bool visited = false;
  };

  std::map<ExactPoint, std::vector<Edge>> edges_;  // by their first end

  void add(const Polygon& ring) {
    for (const auto& edge : ring.edges()) {
      edges_[edge.source()].push_back({edge.direction(), edge.target()});
    }
  }

  // The next edge round the inside on the left: the first one clockwise from where this one comes
  // from.
  Edge& next(const Edge& edge) {
    std::vector<Edge>& from = edges_.at(edge.to);
    Edge* first = &from.front();
    for (Edge& e : from) {
      if (e.direction.counterclockwise_in_between(first->direction, -edge.direction)) {
        first = &e;
      }
    }
    return *first;
  }
};

RegionRings rings_of(const PolygonSet& set, const Point& shift) {
  return Edges(set).rings({shift.x, shift.y});
}

}  // namespace

RegionRings rings_of_sum(const Rings& a, const Rings& b, const Point& shift) {
  return rings_of(union_of_sums(pieces_of(a, 1), pieces_of(b, 1)), shift);
}

// In a window round all positions where the boxes of both meet, `moving` overlaps what is not in
// the container exactly if it overlaps one of its holes or a frame round it, as wide as `moving`.
RegionRings rings_of_inner_fit(const Rings& container, const Rings& moving,
                               const Point& reference) {
  const Polygon outer = exact(container.front(), 1, false);
  const CGAL::Bbox_2 box = outer.bbox();
  const CGAL::Bbox_2 part = exact(moving.front(), 1, true).bbox();
  const double width = part.xmax() - part.xmin();
  const double height = part.ymax() - part.ymin();
  PolygonWithHoles frame(rectangle({box.xmin() - 2 * width, box.ymin() - 2 * height,
                                    box.xmax() + 2 * width, box.ymax() + 2 * height}));
  frame.add_hole(outer);
  Pieces outside;
  decompose(frame, outside);
  for (std::size_t k = 1; k < container.size(); ++k) {
    decompose(PolygonWithHoles(exact(container[k], 1, true)), outside);
  }
  PolygonSet free(rectangle({box.xmin() - part.xmax(), box.ymin() - part.ymax(),
                             box.xmax() - part.xmin(), box.ymax() - part.ymin()}));
  free.difference(union_of_sums(outside, pieces_of(moving, -1)));
  return rings_of(free, reference);
}

}  // namespace gcv::reference
