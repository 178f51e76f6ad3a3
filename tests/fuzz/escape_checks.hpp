// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What must hold of the ways out of overlaps, whatever the polygons are.
#pragma once

#include "question_pair.hpp"

namespace gcv::fuzz {

// Is x near y, but for some roundings of numbers of that size?
inline bool is_near(double x, double y, double size) {
  return std::abs(x - y) <= 0x1p-48 * size + 8 * std::numeric_limits<double>::denorm_min();
}

inline void check_escape(const Pair& pair, const Point& t, const gcv_escape& escape,
                         const std::string& where) {
  const Point way{escape.translation[0], escape.translation[1]};
  const Point position{escape.position[0], escape.position[1]};
  const bool overlap = relation(pair.a.get(), pair.b.get(), t) == GCV_OVERLAPPING;
  check(
      escape.reserved == 0 && std::isfinite(escape.depth) && is_finite(way) && is_finite(position),
      "no way out" + where);
  check(escape.relation == relation(pair.a.get(), pair.b.get(), position),
        "another relation at the position" + where);
  if (!overlap) {
    check(escape.depth == 0 && way == Point{0, 0} && position == t && is_none(escape.contact),
          "a way out without an overlap" + where);
    return;
  }
  // A depth rounds to 0 below half of the smallest double.
  check(escape.depth > 0 || (escape.depth == 0 && way == Point{0, 0}),
        "no depth of an overlap" + where);
  check(is_near(escape.depth / 2, std::hypot(way[0] / 2, way[1] / 2), escape.depth),
        "a depth that is not the length of the way" + where);
  for (std::size_t k = 0; k < 2; ++k) {
    check(is_near(position[k] / 4, t[k] / 4 + way[k] / 4, std::abs(t[k]) + std::abs(way[k])),
          "a position elsewhere" + where);
  }
  // In one point where rings of both polygons touch, there may be none.
  check((pair.have_holes && is_none(escape.contact)) ||
            ((escape.contact.kind == GCV_CONTACT_EDGE_VERTEX ||
              escape.contact.kind == GCV_CONTACT_VERTEX_EDGE) &&
             escape.contact.gap == 0),
        "a way out to another contact, or to none" + where);
}

// Without some parts of what there is to go to. What is left out makes a way longer, or as long.
inline void check_left_out(const Pair& pair, const Point& t, const gcv_escape& whole,
                           const std::string& where) {
  const auto holes = penetration(pair.a.get(), pair.b.get(), t, GCV_LEAVE_OUT_HOLES);
  const auto fits = penetration(pair.a.get(), pair.b.get(), t, GCV_LEAVE_OUT_FITS);
  const auto both =
      penetration(pair.a.get(), pair.b.get(), t, GCV_LEAVE_OUT_HOLES | GCV_LEAVE_OUT_FITS);
  for (const auto& way : {holes, fits, both}) {
    if (way) {
      check_escape(pair, t, *way, where);
      check(whole.depth <= way->depth, "a shorter way with parts left out" + where);
    }
  }
  for (const auto& way : {holes, fits}) {
    check(!way || !both || way->depth <= both->depth, "a shorter way without more parts" + where);
  }
}

inline void check_penetration(const Pair& pair, const Point& t, const std::string& where) {
  const auto here = penetration(pair.a.get(), pair.b.get(), t);
  if (!here) {
    return;
  }
  check_escape(pair, t, *here, where);
  check_left_out(pair, t, *here, where);
  const auto exchanged = penetration(pair.b.get(), pair.a.get(), negated(t));
  check(!exchanged || here->depth == exchanged->depth,
        "another depth with a and b exchanged" + where);
}

// No depth changes by more than the way between two translations.
inline void check_depth_between(const Pair& pair, const Point& s, const Point& t) {
  if (s == t) {
    return;
  }
  const auto from = penetration(pair.a.get(), pair.b.get(), s);
  const auto to = penetration(pair.a.get(), pair.b.get(), t);
  if (from && to) {
    const double way = length_above(minus(s, t));
    check(from->depth <= (to->depth + way) * (1 + 0x1p-50) &&
              to->depth <= (from->depth + way) * (1 + 0x1p-50),
          "a depth that changes too much, from " + text_of(s) + " to " + text_of(t) + pair.text);
  }
}

}  // namespace gcv::fuzz
