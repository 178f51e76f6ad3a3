// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two polygons, a motion of one of them, and the questions about them, one at a time.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "../core/contact_agreement.hpp"
#include "fuzz.hpp"
#include "grid_polygons.hpp"

namespace gcv::fuzz {

using test::text_of;

struct Pair {
  Polygon a;
  Polygon b;
  std::string text;
  bool have_holes;  // both: some rings of each may touch
};

struct Motion {
  Point translation;
  Point way;

  [[nodiscard]] std::string text() const {
    return "\nt: " + text_of(translation) + ", motion: " + text_of(way);
  }
};

inline Point minus(const Point& p, const Point& q) { return {p[0] - q[0], p[1] - q[1]}; }

inline Point negated(const Point& p) { return {0.0 - p[0], 0.0 - p[1]}; }

// Slightly more than the length of a vector, whatever was rounded.
inline double length_above(const Point& v) {
  return std::hypot(v[0], v[1]) * (1 + 0x1p-50) + 4 * std::numeric_limits<double>::denorm_min();
}

template <class Result>
bool same_bytes(const Result& p, const Result& q) {
  return std::memcmp(&p, &q, sizeof p) == 0;
}

inline bool is_none(const gcv_contact& contact) { return same_bytes(contact, gcv_contact{}); }

// ------------------------------------------------------------------- what is asked --

inline int relation(const gcv_polygon* a, const gcv_polygon* b, const Point& t) {
  std::int8_t out = 2;
  succeeds("gcv_relation", gcv_relation(a, b, t.data(), 1, nullptr, &out));
  return out;
}

// None beyond the largest double.
inline std::optional<gcv_separation> distance(const gcv_polygon* a, const gcv_polygon* b,
                                              const Point& t) {
  gcv_separation out{};
  const gcv_status status = gcv_distance(a, b, t.data(), 1, nullptr, &out);
  return succeeds("gcv_distance", status, {GCV_ERR_RANGE}) ? std::optional(out) : std::nullopt;
}

inline std::optional<gcv_impact> cast(const gcv_polygon* a, const gcv_polygon* b,
                                      const Motion& motion) {
  gcv_impact out{};
  const gcv_status status =
      gcv_cast(a, b, motion.translation.data(), motion.way.data(), 1, nullptr, &out);
  return succeeds("gcv_cast", status, {GCV_ERR_RANGE}) ? std::optional(out) : std::nullopt;
}

inline std::optional<gcv_escape> penetration(const gcv_polygon* a, const gcv_polygon* b,
                                             const Point& t, std::uint64_t leave_out = 0) {
  gcv_options options = GCV_OPTIONS_INIT;
  options.leave_out = leave_out;
  gcv_escape out{};
  const gcv_status status = gcv_penetration(a, b, t.data(), 1, &options, &out);
  return succeeds("gcv_penetration", status, {GCV_ERR_RANGE}) ? std::optional(out) : std::nullopt;
}

}  // namespace gcv::fuzz
