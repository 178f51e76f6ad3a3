// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Only sums, products, quotients and square roots are used: these are correctly rounded, so that
// the same disc has the same bits everywhere. What they come to is checked exactly.
#include "disc.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "double_double.hpp"
#include "error.hpp"
#include "exact_numbers.hpp"

namespace gcv {

namespace {

struct Disc {
  Point centre;
  double radius;
  double tolerance;
  Rounding rounding;

  // Unit of the last place of its coordinates.
  [[nodiscard]] double unit() const {
    const double largest = std::max(std::abs(centre.x), std::abs(centre.y)) + 2 * radius;
    return std::ldexp(1.0, std::max(std::ilogb(largest) - 52, -1074));
  }
};

void check(const Disc& disc) {
  const auto& [x, y] = disc.centre;
  if (!std::isfinite(x) || !std::isfinite(y)) {
    throw Error(Status::not_finite, "disc: the %s coordinate of the centre is %g",
                std::isfinite(x) ? "y" : "x", std::isfinite(x) ? y : x);
  }
  if (!std::isfinite(disc.radius)) {
    throw Error(Status::not_finite, "disc: radius is %g", disc.radius);
  }
  if (!(disc.radius > 0)) {
    throw Error(Status::invalid_argument, "disc: radius is %g, not above 0", disc.radius);
  }
  if (!(disc.tolerance > 0 && std::isfinite(disc.tolerance))) {
    throw Error(Status::invalid_argument, "disc: tolerance is %g, not a finite number above 0",
                disc.tolerance);
  }
  if (!std::isfinite(std::max(std::abs(x), std::abs(y)) + 4 * disc.radius)) {
    throw Error(Status::range, "disc: radius %g at (%g, %g) is too near the largest double",
                disc.radius, x, y);
  }
}

// Unit vectors that cut the first quarter into 2^halvings parts, without (0, 1).
PointVector directions(int halvings) {
  PointVector quarter{{1, 0}, {0, 1}};
  for (int k = 0; k < halvings; ++k) {
    PointVector halved;
    halved.reserve(2 * quarter.size() - 1);
    for (std::size_t i = 0; i + 1 < quarter.size(); ++i) {
      const double x = quarter[i].x + quarter[i + 1].x;
      const double y = quarter[i].y + quarter[i + 1].y;
      const double length = std::sqrt(x * x + y * y);
      halved.push_back(quarter[i]);
      halved.push_back({x / length, y / length});
    }
    halved.push_back(quarter.back());
    quarter = std::move(halved);
  }
  quarter.pop_back();
  return quarter;
}

// The vertices in those directions, so far from the centre.
PointVector vertices_at(const Disc& disc, int halvings, double distance) {
  const double unit = disc.unit();
  PointVector offsets = directions(halvings);
  for (Point& p : offsets) {
    p = {std::nearbyint(distance * p.x / unit) * unit,
         std::nearbyint(distance * p.y / unit) * unit};
  }
  const std::size_t quarter = offsets.size();
  for (std::size_t k = quarter; k < 4 * quarter; ++k) {
    const Point p = offsets[k - quarter];
    offsets.push_back({0.0 - p.y, p.x});
  }
  for (Point& p : offsets) {
    p = {disc.centre.x + p.x, disc.centre.y + p.y};
  }
  return offsets;
}

// Is the edge from p to q at least radius - in from the centre, and p at most radius + out,
// exactly? With b bits in the grid, radii have b + 1, vectors b + 1, cross products 2b + 3.
bool is_within(const Disc& disc, const Point& p, const Point& q, double in, double out) {
  Grid grid{disc.centre, p, q, {disc.radius, in}};
  grid.include(out);
  Tally tally;
  return with_integers(4 * grid.bits() + 8, tally, [&]<class Integer>() {
    const auto to_p = vector_between<Integer>(grid, disc.centre, p);
    const auto to_q = vector_between<Integer>(grid, disc.centre, q);
    const auto edge = vector_between<Integer>(grid, p, q);
    const auto square = [](const Vector<Integer>& v) { return Integer(v.x * v.x + v.y * v.y); };
    const auto radius = grid.integer<Integer>(disc.radius);
    const Integer most = radius + grid.integer<Integer>(out);
    const Integer least = radius - grid.integer<Integer>(in);
    const Integer turn = cross(to_p, to_q);
    if (sign(turn) <= 0 || sign(Integer(most * most - square(to_p))) < 0) {
      return false;
    }
    return sign(least) <= 0 || sign(Integer(turn * turn - least * least * square(edge))) >= 0;
  });
}

bool is_within(const Disc& disc, const PointVector& vertices) {
  const double in = disc.rounding == Rounding::outward ? 0 : disc.tolerance;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Point& next = vertices[k + 1 == vertices.size() ? 0 : k + 1];
    if (!is_within(disc, vertices[k], next, in, disc.tolerance)) {
      return false;
    }
  }
  return true;
}

}  // namespace

// With v = 1 - cos(pi / n), edges of n vertices at distance d from the centre are (1 - v) d from
// it. Nearest: both are as far from the circle, d = r / (1 - v / 2). Outward: edges touch it,
// d = r / (1 - v), with room for roundings: half a unit for the offset of a vertex and half a unit
// for the vertex, in both coordinates, and 2 u for each halving.
Polygon make_disc(const Point& centre, double radius, double tolerance, Rounding rounding) {
  constexpr int most_halvings = 28;
  const Disc disc{{centre.x + 0.0, centre.y + 0.0}, radius, tolerance, rounding};
  check(disc);
  const bool is_outward = rounding == Rounding::outward;
  double versine = 1 - std::sqrt(0.5);
  for (int halvings = 0; halvings <= most_halvings; ++halvings) {
    const double room = 2 * disc.unit() + (4 * halvings + 8) * unit_roundoff * radius;
    const double share = is_outward ? versine : versine / 2;
    const double distance =
        std::max(radius / (1 - share) + (is_outward ? 2 * room : 0), disc.unit());
    if (distance + room <= radius + tolerance) {
      PointVector vertices = vertices_at(disc, halvings, distance);
      if (is_within(disc, vertices)) {
        Polygon polygon(std::move(vertices), "disc");
        if (polygon.outer.is_convex) {
          return polygon;
        }
      }
      break;  // of few units: more vertices would not lie better, but nearer to one another
    }
    versine = versine / 2 / (1 + std::sqrt(1 - versine / 2));
  }
  throw Error(Status::invalid_argument,
              "disc: tolerance %g is too small for doubles, with radius %g at (%g, %g)", tolerance,
              radius, centre.x, centre.y);
}

}  // namespace gcv
