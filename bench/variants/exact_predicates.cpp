// SPDX-License-Identifier: LGPL-3.0-or-later
//
// cpp/exact/predicates.hpp without its filters: every predicate takes the exact tier, integers
// of the width that the operands need. crossing_parameter, which the search shortens
// edges by, encloses the quotient of two exact numbers.
#include "exact_predicates.hpp"

#include <cmath>
#include <limits>

#include "exact_numbers.hpp"
#include "predicates.hpp"

namespace gcv {

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally) {
  return exact::turn(p0, p1, q0, q1, tally);
}

int orientation(const Point& p, const Point& q, const Point& r, Tally& tally) {
  return exact::turn(p, q, p, r, tally);
}

int side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  return exact::side(s, point, tally);
}

int compare_sums(double a, double b, double c, double d, Tally& tally) {
  return exact::compare_sums(a, b, c, d, tally);
}

int compare_sums(double a, double b, double c, double d, double e, double f, Tally& tally) {
  return exact::compare_sums(a, b, c, d, e, f, tally);
}

int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& q, const SumEdge& r,
                      Tally& tally) {
  return exact::compare_crossings(s, t, q, r, tally);
}

// Converting an integer errs by 2u of it at most, and the division by u: less than 8u in all.
Interval crossing_parameter(const SumEdge& s, const SumEdge& t) {
  Grid grid;
  grid.include(s);
  grid.include(t);
  Tally tally;
  const double quotient = with_integers(2 * grid.bits() + 4, tally, [&]<class Integer>() {
    const auto along = vector_between<Integer>(grid, t.from, t.to);
    const Integer n = cross(vector_between<Integer>(grid, s.origin, t.origin), along);
    const Integer d = cross(vector_between<Integer>(grid, s.from, s.to), along);
    return static_cast<double>(n) / static_cast<double>(d);
  });
  const double error = 4 * std::numeric_limits<double>::epsilon() * std::abs(quotient) +
                       std::numeric_limits<double>::min();
  if (!std::isfinite(error)) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  return {quotient - error, quotient + error};
}

}  // namespace gcv
