// SPDX-License-Identifier: LGPL-3.0-or-later
//
// cpp/predicates.hpp without its filters: every predicate takes the exact tier, integers
// of the width that the operands need. crossing_parameter, which the search shortens
// edges by, encloses the quotient of two exact numbers.
#include <cmath>
#include <limits>

#include "exact_numbers.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// lambda_t = n / d.
template <class Integer>
struct Quotient {
  Integer n;
  Integer d;
};

template <class Integer>
Quotient<Integer> parameter(const Grid& grid, const SumEdge& s, const SumEdge& t) {
  const auto dt = vector_between<Integer>(grid, t.from, t.to);
  return {cross(vector_between<Integer>(grid, s.origin, t.origin), dt),
          cross(vector_between<Integer>(grid, s.from, s.to), dt)};
}

}  // namespace

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally) {
  const Grid grid{p0, p1, q0, q1};
  return with_integers(2 * grid.bits() + 3, tally, [&]<class Integer>() {
    return sign(
        cross(vector_between<Integer>(grid, p0, p1), vector_between<Integer>(grid, q0, q1)));
  });
}

int orientation(const Point& p, const Point& q, const Point& r, Tally& tally) {
  return turn(p, q, p, r, tally);
}

int side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  Grid grid{point.a, point.b};
  grid.include(s);
  return with_integers(2 * grid.bits() + 4, tally, [&]<class Integer>() {
    return sign(cross(vector_between<Integer>(grid, s.from, s.to),
                      vector_between<Integer>(grid, s.origin, point)));
  });
}

int compare_sums(double a, double b, double c, double d, Tally& tally) {
  const Grid grid{Point{a, b}, Point{c, d}};
  return with_integers(grid.bits() + 2, tally, [&]<class Integer>() {
    const Integer sum = grid.integer<Integer>(a) + grid.integer<Integer>(b);
    return sign(Integer(sum - grid.integer<Integer>(c) - grid.integer<Integer>(d)));
  });
}

int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& r, Tally& tally) {
  Grid grid;
  grid.include(s);
  grid.include(t);
  grid.include(r);
  return with_integers(4 * grid.bits() + 8, tally, [&]<class Integer>() {
    const auto of_t = parameter<Integer>(grid, s, t);
    const auto of_r = parameter<Integer>(grid, s, r);
    return sign(Integer(of_t.n * of_r.d - of_r.n * of_t.d)) * sign(of_t.d) * sign(of_r.d);
  });
}

// Converting an integer errs by 2u of it at most, and the division by u: less than 8u in all.
Interval crossing_parameter(const SumEdge& s, const SumEdge& t) {
  Grid grid;
  grid.include(s);
  grid.include(t);
  Tally tally;
  const double quotient = with_integers(2 * grid.bits() + 4, tally, [&]<class Integer>() {
    const auto exact = parameter<Integer>(grid, s, t);
    return static_cast<double>(exact.n) / static_cast<double>(exact.d);
  });
  const double error = 4 * std::numeric_limits<double>::epsilon() * std::abs(quotient) +
                       std::numeric_limits<double>::min();
  if (!std::isfinite(error)) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  return {quotient - error, quotient + error};
}

}  // namespace gcv
