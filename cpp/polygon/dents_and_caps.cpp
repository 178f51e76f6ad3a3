// SPDX-License-Identifier: LGPL-3.0-or-later
#include "dents_and_caps.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "predicates.hpp"

namespace gcv {

namespace {

constexpr double u = std::numeric_limits<double>::epsilon() / 2;

// Is the scalar product of two vectors positive? Their coordinates may be rounded once. False where
// that is not certain.
bool surely_ahead(const Point& p, const Point& q) {
  return dot(p, q) >
         8 * u * (std::abs(p.x * q.x) + std::abs(p.y * q.y)) + std::numeric_limits<double>::min();
}

// Replaces runs of convex vertices by caps.
class Capping {
 public:
  Capping(const ScaledRing& ring, const NewBoundary& boundary) : ring_(ring), boundary_(boundary) {}

  [[nodiscard]] NewBoundary run() const {
    NewBoundary capped{boundary_.front()};
    for (std::size_t i = 0; i + 1 < boundary_.size();) {
      if (const std::optional<Cap> cap = longest_cap(i)) {
        capped.push_back(cap->vertex);
        i = cap->edge;
      } else {
        capped.push_back(boundary_[++i]);
      }
    }
    return capped;
  }

 private:
  struct Cap {
    NewVertex vertex;
    std::size_t edge;  // the one behind the run
  };

  [[nodiscard]] const Point& point(std::size_t k) const { return at(boundary_, k).point; }
  [[nodiscard]] Point scaled(std::size_t k) const { return ring_.scaled(point(k)); }

  // The cap of the longest run behind edge i that turns by less than a quarter. It is the point
  // where edge i and edge j, the one behind the run, meet.
  //
  // Its error. The distance from the convex hull of the run and both edges is a convex function
  // along the new edges. So it is largest at the new point. Every point of the run is the nearest
  // one to some point of the new edges. So run and new edges are as near to each other as the new
  // point is to the run.
  [[nodiscard]] std::optional<Cap> longest_cap(std::size_t i) const {
    const Point before = difference(scaled(i + 1), scaled(i));
    std::optional<Cap> longest;
    double error = std::max(boundary_[i].error, at(boundary_, i + 1).error);
    double allowed = std::min(boundary_[i].allowed, at(boundary_, i + 1).allowed);
    std::size_t nearest = i + 1;
    for (std::size_t j = i + 2; j < boundary_.size(); ++j) {
      error = std::max(error, boundary_[j].error);
      allowed = std::min(allowed, boundary_[j].allowed);
      const Point behind = difference(scaled(j + 1), scaled(j));
      if (!turns_left(j - 1) || !turns_left(j) ||
          !(dot(before, behind) > 0 && cross(before, behind) > 0)) {
        break;
      }
      const std::optional<Point> meeting = meeting_point(i, j);
      if (!meeting) {
        break;
      }
      const auto to_edge = [&](std::size_t k) {
        return distance_bound(ring_.scaled(*meeting), scaled(k), scaled(k + 1)).bound;
      };
      // As j grows, the nearest edge of the run moves on.
      double height = to_edge(nearest);
      for (; nearest + 1 < j && to_edge(nearest + 1) <= height; ++nearest) {
        height = to_edge(nearest + 1);
      }
      const double needed = (error + height) * (1 + 2 * u);
      if (!(needed <= allowed)) {
        break;
      }
      longest = Cap{{*meeting, boundary_[i + 1].first, boundary_[j].last, needed, allowed}, j};
    }
    return longest;
  }

  [[nodiscard]] bool turns_left(std::size_t k) const {
    Tally tally;
    return orientation(point(k - 1), point(k), point(k + 1), tally) > 0;
  }

  // A point on or to the right of edges i and j, behind edge i and before edge j. It is a few units
  // in the last place at most from where their lines meet. Nothing where doubles have no such point
  // near there.
  //
  // Why the new boundary goes round the run. Both ends of the new edge along edge j lie on or to
  // the right of edge j. So edge j, what is left of it and what is beside it lie on the left of the
  // new edge. The same holds for edge i.
  [[nodiscard]] std::optional<Point> meeting_point(std::size_t i, std::size_t j) const {
    const Point start = scaled(i + 1);
    const Point ab = difference(start, scaled(i));
    const Point cd = difference(scaled(j + 1), scaled(j));
    const double along = cross(difference(scaled(j), start), cd) / cross(ab, cd);
    const Point meeting{start.x + along * ab.x, start.y + along * ab.y};
    const Point outwards{ab.y + cd.y, -(ab.x + cd.x)};
    const double unit = 2 * u * std::max(std::abs(meeting.x), std::abs(meeting.y)) /
                        std::max(std::abs(outwards.x), std::abs(outwards.y));
    Tally tally;
    for (const double steps : {0, 1, 2, 4, 8}) {
      const Point p = ring_.unscaled({meeting.x + steps * unit * outwards.x + 0.0,
                                      meeting.y + steps * unit * outwards.y + 0.0});
      if (std::isfinite(p.x) && std::isfinite(p.y) &&
          surely_ahead(difference(ring_.scaled(p), start), ab) &&
          surely_ahead(difference(scaled(j), ring_.scaled(p)), cd) &&
          orientation(point(i), point(i + 1), p, tally) <= 0 &&
          orientation(point(j), point(j + 1), p, tally) <= 0) {
        return p;
      }
    }
    return std::nullopt;
  }

  const ScaledRing& ring_;
  const NewBoundary& boundary_;
};

}  // namespace

// A filled dent may make the vertices before and behind it reflex. So the last vertices are tested
// again. A vertex that was found too deep stays for good.
NewBoundary without_dents(const Shortcuts& shortcuts, const NewBoundary& boundary) {
  const Index end_of_ring = shortcuts.ring().size();
  NewBoundary filled{boundary.front()};
  std::size_t settled = 1;  // so many of the vertices of `filled` stay
  Tally tally;
  for (std::size_t k = 1; k <= boundary.size(); ++k) {
    const Index end = k == boundary.size() ? end_of_ring : boundary[k].first;
    while (filled.size() > settled) {
      const NewVertex& before = filled[filled.size() - 2];
      if (orientation(before.point, filled.back().point, shortcuts.vertex(end), tally) > 0) {
        break;
      }
      const NewVertex longer = shortcuts.joined(before, filled.back(), end);
      if (!(longer.error <= longer.allowed)) {
        settled = filled.size();
        break;
      }
      filled.pop_back();
      filled.back() = longer;
    }
    if (k < boundary.size()) {
      filled.push_back(boundary[k]);
    }
  }
  // The error of a joined segment may be less than its bound.
  for (std::size_t k = 0; k < filled.size(); ++k) {
    const Index end = k + 1 == filled.size() ? end_of_ring : filled[k + 1].first;
    filled[k].error = std::min(filled[k].error, shortcuts.segment(filled[k].first, end).error);
  }
  return filled;
}

NewBoundary with_caps(const ScaledRing& ring, const NewBoundary& boundary) {
  assert(!boundary.empty());
  return Capping(ring, boundary).run();
}

}  // namespace gcv
