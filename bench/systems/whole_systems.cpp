// SPDX-License-Identifier: LGPL-3.0-or-later
#include "whole.hpp"

namespace gcv::bench {

namespace {

invariants::Ring exact(const Ring& ring) {
  invariants::Ring result;
  for (const Point& p : ring) {
    result.push_back({invariants::Rational(p.x), invariants::Rational(p.y)});
  }
  return result;
}

// A system whose coordinates are doubles.
WholeSystem in_doubles(const char* name, WholeInDoubles (*sum)(const Ring&, const Ring&)) {
  return {name, sum, [sum](const Ring& a, const Ring& b) {
            const WholeInDoubles whole = sum(a, b);
            ExactWhole result;
            for (const Ring& ring : whole.outer) {
              result.outer.push_back(exact(ring));
            }
            for (const Ring& ring : whole.holes) {
              result.holes.push_back(exact(ring));
            }
            return result;
          }};
}

}  // namespace

std::vector<WholeSystem> whole_systems() {
  return {{"CGAL reduced convolution", cgal_reduced_whole, cgal_reduced_exact_whole},
          {"CGAL decomposition", cgal_decomposition_whole, cgal_decomposition_exact_whole},
          {"SFCGAL", sfcgal_whole, sfcgal_exact_whole},
#ifdef GCV_BENCH_CLIPPER2
          in_doubles("Clipper2, outlines", clipper2_outlines_whole),
          in_doubles("Clipper2, filled", clipper2_filled_whole),
#endif
          in_doubles("GEOS, parallelograms", geos_whole)};
}

}  // namespace gcv::bench
