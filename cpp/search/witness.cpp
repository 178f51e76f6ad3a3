// SPDX-License-Identifier: LGPL-3.0-or-later
#include "witness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcv {

namespace {

double size_of(const Point& p) { return std::abs(p.x) + std::abs(p.y); }

}  // namespace

// Error bound, with uE as the unit, u times the extents of both polygons. Coordinates of the corner
// are off by 3, those of u and v by 3, and those of the point by 6, so that w is off by 10. If the
// computed inequalities hold, w is at most 1.1 (|u| + |v|) long. So w x v and u x w are off by less
// than 21 (|u| + |v|), the roundings of their own products included; the product of the radius and
// the length by 30 (|v|), for chords are off by 24. The slack is 64.
Witness::Witness(const Chord& p, const Chord& q, double slack)
    : corner{p.from.x + q.from.x, p.from.y + q.from.y} {
  Point u{p.to.x - p.from.x, p.to.y - p.from.y};
  Point v{q.to.x - q.from.x, q.to.y - q.from.y};
  double room_u = p.radius * p.length;
  double room_v = q.radius * q.length;
  double cross = u.x * v.y - u.y * v.x;
  if (cross < 0) {
    std::swap(u, v);
    std::swap(room_u, room_v);
    cross = -cross;
  }
  const double tolerance = (size_of(u) + size_of(v)) * slack + std::numeric_limits<double>::min();
  strips[0] = {v.y, v.x, room_v + tolerance, cross - (room_v + tolerance)};
  strips[1] = {-u.y, -u.x, room_u + tolerance, cross - (room_u + tolerance)};
  const auto low = [](double s, double t) { return std::min(s, 0.0) + std::min(t, 0.0); };
  const auto high = [](double s, double t) { return std::max(s, 0.0) + std::max(t, 0.0); };
  bounds = {corner.x + low(u.x, v.x), corner.y + low(u.y, v.y), corner.x + high(u.x, v.x),
            corner.y + high(u.y, v.y)};
}

// What it holds is convex. So it holds the line between two places that it holds.
double Witness::reach(const RelativeLine& line, double t) const {
  const auto holds_at = [&](double parameter) {
    const Point p = line.at(parameter);
    return holds(box_of(p, p));
  };
  if (!holds_at(t)) {
    return t;
  }
  double end = infinity;
  for (const Strip& strip : strips) {
    const double here = strip.p * (line.origin.x - corner.x) - strip.q * (line.origin.y - corner.y);
    const double step = strip.p * line.dx - strip.q * line.dy;
    if (step != 0) {
      end = std::min(end, ((step > 0 ? strip.most : strip.least) - here) / step);
    }
  }
  // Roundings may put the end outside.
  for (const double share : {1 - 0x1p-44, 1 - 0x1p-20}) {
    const double at = std::min(t + share * (end - t), 1.0);
    if (at > t && holds_at(at)) {
      return at;
    }
  }
  return t;
}

}  // namespace gcv
