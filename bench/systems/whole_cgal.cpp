// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Small_side_angle_bisector_decomposition_2.h>
#include <CGAL/minkowski_sum_2.h>

#include "cgal.hpp"
#include "whole.hpp"

namespace gcv::bench {

namespace {

using CgalRegion = CGAL::Polygon_with_holes_2<Kernel>;

invariants::Ring to_fractions(const CgalPolygon& polygon) {
  const auto fraction = [](const Kernel::FT& x) {
    return invariants::Rational(CGAL::exact(x).get_mpq_t());
  };
  invariants::Ring ring;
  for (const Kernel::Point_2& p : polygon.container()) {
    ring.push_back({fraction(p.x()), fraction(p.y())});
  }
  return ring;
}

template <class AnyRing, class Convert>
Whole<AnyRing> converted(const CgalRegion& region, Convert convert) {
  Whole<AnyRing> whole;
  whole.outer.push_back(convert(region.outer_boundary()));
  for (const CgalPolygon& hole : region.holes()) {
    whole.holes.push_back(convert(hole));
  }
  return whole;
}

WholeInDoubles in_doubles(const CgalRegion& region) {
  return converted<Ring>(region, [](const CgalPolygon& p) { return to_doubles(p); });
}

ExactWhole in_fractions(const CgalRegion& region) {
  return converted<invariants::Ring>(region, to_fractions);
}

CgalRegion reduced(const Ring& a, const Ring& b) {
  return CGAL::minkowski_sum_by_reduced_convolution_2(to_cgal(a), to_cgal(b));
}

CgalRegion by_decomposition(const Ring& a, const Ring& b) {
  const CGAL::Small_side_angle_bisector_decomposition_2<Kernel> decomposition;
  return CGAL::minkowski_sum_2(to_cgal(a), to_cgal(b), decomposition);
}

}  // namespace

WholeInDoubles cgal_reduced_whole(const Ring& a, const Ring& b) {
  return in_doubles(reduced(a, b));
}
ExactWhole cgal_reduced_exact_whole(const Ring& a, const Ring& b) {
  return in_fractions(reduced(a, b));
}
WholeInDoubles cgal_decomposition_whole(const Ring& a, const Ring& b) {
  return in_doubles(by_decomposition(a, b));
}
ExactWhole cgal_decomposition_exact_whole(const Ring& a, const Ring& b) {
  return in_fractions(by_decomposition(a, b));
}

bool overlap_at(const Ring& a, const Ring& b, const invariants::Exact& x) {
  const auto number = [](const invariants::Rational& r) {
    return Kernel::FT(Kernel::Exact_kernel::FT(r.backend().data()));
  };
  CgalPolygon moved;
  for (const Point& p : b) {
    moved.push_back(Kernel::Point_2(number(x.x) - p.x, number(x.y) - p.y));
  }
  return CGAL::do_intersect(to_cgal(a), moved);
}

}  // namespace gcv::bench
