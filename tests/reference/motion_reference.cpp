// SPDX-License-Identifier: LGPL-3.0-or-later
#include "motion_reference.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace gcv::reference {

namespace {

using invariants::cross;
using invariants::dot;
using invariants::on_segment;

// The times from 0 to 1 at which a corner comes to an edge or leaves it. Between two of them the
// relation does not change.
std::vector<Rational> event_times(const Solid& a, const Solid& b, const Exact& motion) {
  std::vector<Rational> times{0, 1};
  // The corner moves along d.
  const auto take = [&](const Corner& corner, const Edge& edge, const Exact& d) {
    const Exact along = edge.to - edge.from;
    const Rational speed = cross(along, d);
    if (speed == 0) {
      return;
    }
    const Rational time = cross(along, edge.from - corner.place) / speed;
    if (time > 0 && time < 1 && on_segment(edge.from, edge.to, corner.place + time * d)) {
      times.push_back(time);
    }
  };
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    for (std::size_t j = 0; j < b.corners.size(); ++j) {
      take(b.corners[j], a.edges[i], motion);
      take(a.corners[i], b.edges[j], {-motion.x, -motion.y});
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// The translations of b at which a corner lies on an edge: from `first` to `second`.
using Segments = std::vector<std::pair<Exact, Exact>>;

Segments contact_segments(const Solid& a, const Solid& b) {
  Segments segments;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    for (std::size_t j = 0; j < b.corners.size(); ++j) {
      const Edge& e = a.edges[i];
      const Edge& f = b.edges[j];
      segments.emplace_back(e.from - b.corners[j].place, e.to - b.corners[j].place);
      segments.emplace_back(a.corners[i].place - f.from, a.corners[i].place - f.to);
    }
  }
  return segments;
}

// The point of the segment that is nearest to 0.
Exact nearest_point(const std::pair<Exact, Exact>& segment) {
  const auto& [from, to] = segment;
  const Exact along = to - from;
  const Rational t = -dot(from, along) / dot(along, along);
  return from + std::clamp<Rational>(t, 0, 1) * along;
}

// The nearest of the translations at which b does not overlap a.
std::optional<Exact> nearest_free(const Solid& a, const Solid& b, std::vector<Exact> translations) {
  std::vector<std::pair<Rational, Exact>> by_length;
  for (const Exact& v : translations) {
    by_length.emplace_back(dot(v, v), v);
  }
  std::sort(by_length.begin(), by_length.end());
  by_length.erase(std::unique(by_length.begin(), by_length.end()), by_length.end());
  for (const auto& [squared_length, v] : by_length) {
    if (!overlap(a, moved(b, v))) {
      return v;
    }
  }
  return {};
}

}  // namespace

Impact impact(const Solid& a, const Solid& b, const Exact& motion) {
  if (overlap(a, b)) {
    return {true, 0, {}};
  }
  const std::vector<Rational> times = event_times(a, b, motion);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    if (overlap(a, moved(b, ((times[k] + times[k + 1]) / 2) * motion))) {
      return {true, times[k], entered_contacts(a, moved(b, times[k] * motion), motion)};
    }
  }
  return {false, 1, {}};
}

// The nearest free translation is a contact without overlap, so it lies on some of the segments.
// Along a segment the relation changes only where another one meets it. So it is the nearest point
// of a segment, or a point in which two of them meet.
Exact escape(const Solid& a, const Solid& b) {
  if (!overlap(a, b)) {
    return {0, 0};
  }
  Segments segments = contact_segments(a, b);
  std::vector<Exact> candidates;
  for (const auto& segment : segments) {
    candidates.insert(candidates.end(), {segment.first, segment.second, nearest_point(segment)});
  }
  // There is one: the rightmost corner of b on the leftmost of a.
  const Exact bound = *nearest_free(a, b, candidates);
  std::erase_if(segments, [&](const auto& segment) {
    const Exact p = nearest_point(segment);
    return dot(p, p) > dot(bound, bound);
  });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto& [p, q] = segments[i];
      const auto& [r, s] = segments[j];
      const Rational denominator = cross(q - p, s - r);
      if (denominator != 0 && invariants::segments_meet(p, q, r, s)) {
        candidates.push_back(p + (cross(r - p, s - r) / denominator) * (q - p));
      }
    }
  }
  std::erase_if(candidates, [&](const Exact& v) { return dot(v, v) > dot(bound, bound); });
  return *nearest_free(a, b, candidates);
}

}  // namespace gcv::reference
