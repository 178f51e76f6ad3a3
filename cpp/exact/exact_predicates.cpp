// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_predicates.hpp"

#include <cassert>

#include "exact_numbers.hpp"

namespace gcv::exact {

int turn(const Point& p0, const Point& p1, const Point& q0, const Point& q1, Tally& tally) {
  const Grid grid{p0, p1, q0, q1};
  return with_integers(2 * grid.bits() + 3, tally, [&]<class Integer>() {
    return sign(
        cross(vector_between<Integer>(grid, p0, p1), vector_between<Integer>(grid, q0, q1)));
  });
}

int side(const SumEdge& s, const SumPoint& point, Tally& tally) {
  Grid grid;
  grid.include(point);
  grid.include(s);
  return with_integers(2 * grid.bits() + 5, tally, [&]<class Integer>() {
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

int compare_sums(double a, double b, double c, double d, double e, double f, Tally& tally) {
  const Grid grid{Point{a, b}, Point{c, d}, Point{e, f}};
  return with_integers(grid.bits() + 3, tally, [&]<class Integer>() {
    const Integer sum =
        grid.integer<Integer>(a) + grid.integer<Integer>(b) + grid.integer<Integer>(c);
    return sign(Integer(sum - grid.integer<Integer>(d) - grid.integer<Integer>(e) -
                        grid.integer<Integer>(f)));
  });
}

int compare_crossings(const SumEdge& s, const SumEdge& t, const SumEdge& q, const SumEdge& r,
                      Tally& tally) {
  Grid grid;
  for (const SumEdge* edge : {&s, &t, &q, &r}) {
    grid.include(*edge);
  }
  return with_integers(4 * grid.bits() + 9, tally, [&]<class Integer>() {
    const auto dt = vector_between<Integer>(grid, t.from, t.to);
    const auto dr = vector_between<Integer>(grid, r.from, r.to);
    const Integer nt = cross(vector_between<Integer>(grid, s.origin, t.origin), dt);
    const Integer nr = cross(vector_between<Integer>(grid, q.origin, r.origin), dr);
    const Integer det = cross(vector_between<Integer>(grid, s.from, s.to), dt);
    const Integer der = cross(vector_between<Integer>(grid, q.from, q.to), dr);
    assert(sign(det) != 0 && sign(der) != 0);
    return sign(Integer(nt * der - nr * det)) * sign(det) * sign(der);
  });
}

}  // namespace gcv::exact
