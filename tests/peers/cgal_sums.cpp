// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sums of two polygons by the methods of CGAL that its own tests compare (GPL: in tests only).
//
// Reads lines "a RING; RING; ..." and "b RING; ...", and prints the sum after each line "b": first
// "method NAME", then the rings of what the method gives, each "ring p/q r/s, p/q r/s, ...". A RING
// is "x y, x y, ..." in doubles.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_convex_decomposition_2.h>
#include <CGAL/Polygon_triangulation_decomposition_2.h>
#include <CGAL/Polygon_vertical_decomposition_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Rational_traits.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <iostream>
#include <sstream>
#include <string>

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;

Polygon ring(const std::string& text, bool counter_clockwise) {
  Polygon polygon;
  std::istringstream vertices(text);
  for (std::string vertex; std::getline(vertices, vertex, ',');) {
    std::istringstream numbers(vertex);
    double x = 0;
    double y = 0;
    numbers >> x >> y;
    polygon.push_back({x, y});
  }
  if (polygon.is_counterclockwise_oriented() != counter_clockwise) {
    polygon.reverse_orientation();
  }
  return polygon;
}

PolygonWithHoles polygon_of(const std::string& text) {
  PolygonWithHoles polygon;
  std::istringstream rings(text);
  for (std::string vertices; std::getline(rings, vertices, ';');) {
    if (polygon.outer_boundary().is_empty()) {
      polygon = PolygonWithHoles(ring(vertices, true));
    } else {
      polygon.add_hole(ring(vertices, false));
    }
  }
  return polygon;
}

void print(const Kernel::FT& x) {
  using Rational = std::decay_t<decltype(x.exact())>;
  const CGAL::Rational_traits<Rational> traits;
  std::cout << traits.numerator(x.exact()) << '/' << traits.denominator(x.exact());
}

void print(const Polygon& ring) {
  const char* between = "ring ";
  for (const auto& p : ring.vertices()) {
    std::cout << between;
    print(p.x());
    std::cout << ' ';
    print(p.y());
    between = ", ";
  }
  std::cout << '\n';
}

void print(const char* method, const PolygonWithHoles& sum) {
  std::cout << "method " << method << '\n';
  print(sum.outer_boundary());
  for (const Polygon& hole : sum.holes()) {
    print(hole);
  }
}

template <typename Decomposition>
void print_decomposed(const char* method, const Polygon& a, const Polygon& b) {
  print(method, CGAL::minkowski_sum_2(a, b, Decomposition()));
}

void print_sums(const PolygonWithHoles& a, const PolygonWithHoles& b) {
  print("reduced_convolution", CGAL::minkowski_sum_by_reduced_convolution_2(a, b));
  const CGAL::Polygon_vertical_decomposition_2<Kernel> vertical;
  print("vertical", CGAL::minkowski_sum_2(a, b, vertical));
  const CGAL::Polygon_triangulation_decomposition_2<Kernel> triangulation;
  print("triangulation", CGAL::minkowski_sum_2(a, b, triangulation));
}

void print_sums_without_holes(const Polygon& a, const Polygon& b) {
  print("full_convolution", CGAL::minkowski_sum_by_full_convolution_2(a, b));
  print_decomposed<CGAL::Small_side_angle_bisector_decomposition_2<Kernel>>("angle_bisector", a, b);
  print_decomposed<CGAL::Optimal_convex_decomposition_2<Kernel>>("optimal", a, b);
  print_decomposed<CGAL::Hertel_Mehlhorn_convex_decomposition_2<Kernel>>("hertel_mehlhorn", a, b);
  print_decomposed<CGAL::Greene_convex_decomposition_2<Kernel>>("greene", a, b);
}

}  // namespace

int main() {
  PolygonWithHoles a;
  for (std::string line; std::getline(std::cin, line);) {
    const PolygonWithHoles polygon = polygon_of(line.substr(2));
    if (line.front() == 'a') {
      a = polygon;
      continue;
    }
    print_sums(a, polygon);
    if (!a.has_holes() && !polygon.has_holes()) {
      print_sums_without_holes(a.outer_boundary(), polygon.outer_boundary());
    }
    std::cout << std::flush;
  }
  return 0;
}
