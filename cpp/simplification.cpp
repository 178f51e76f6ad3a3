// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The boundary is cut into chains, each as long as a segment between its ends can stand
// for it. Rounding outward, a chain is replaced by the part of its convex hull on the
// outer side, dents between hulls by segments over them, and runs of convex vertices by the
// point where the edges before and behind them meet.
//
// Distances. A chain within e of the segment between its ends passes every perpendicular of
// it, so no point of the segment is further than e from the chain. And the chain can be moved
// to the segment, each point in a straight line and by e at most: so what is inside one of the
// boundaries alone is within e of both.
//
// Containment. Every piece of the new boundary goes round the chain that it replaces on its
// outer side, so no winding number falls; where the new boundary is simple, its inside
// contains the polygon.
//
// Simplicity. Where edges of the new boundary meet, the tolerance is cut along the chains
// that they stand for, at last to 0, where the given boundary stays.
#include "simplification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "predicates.hpp"
#include "simplicity.hpp"

namespace gcv {

namespace {

constexpr double u = std::numeric_limits<double>::epsilon() / 2;

// The polygon's boundary in units of a power of two that none of its coordinates exceeds.
// What underflows in them, below 2^-1074, is covered by the bounds on distances.
class ScaledRing {
 public:
  explicit ScaledRing(const PointVector& vertices) {
    double largest = 0;
    for (const Point& p : vertices) {
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
    exponent_ = std::ilogb(largest) + 1;
    points_.reserve(vertices.size());
    for (const Point& p : vertices) {
      points_.push_back(scaled(p));
    }
  }

  // Of its box, width and height together: a larger tolerance allows nothing more.
  [[nodiscard]] double extent() const {
    const auto [x0, x1] = std::minmax_element(
        points_.begin(), points_.end(), [](const Point& p, const Point& q) { return p.x < q.x; });
    const auto [y0, y1] = std::minmax_element(
        points_.begin(), points_.end(), [](const Point& p, const Point& q) { return p.y < q.y; });
    return (x1->x - x0->x) + (y1->y - y0->y);
  }

  [[nodiscard]] Index size() const { return static_cast<Index>(points_.size()); }
  [[nodiscard]] const Point& operator[](Index i) const { return points_[i == size() ? 0 : i]; }
  [[nodiscard]] double scaled(double x) const { return std::ldexp(x, -exponent_); }
  [[nodiscard]] Point scaled(const Point& p) const { return {scaled(p.x), scaled(p.y)}; }
  [[nodiscard]] Point unscaled(const Point& p) const {
    return {std::ldexp(p.x, exponent_), std::ldexp(p.y, exponent_)};
  }
  // At least the length in the polygon's units.
  [[nodiscard]] double unscaled_bound(double length) const {
    const double unscaled = std::ldexp(length, exponent_);
    return scaled(unscaled) < length ? next_up(unscaled) : unscaled;
  }

 private:
  PointVector points_;
  int exponent_ = 0;
};

double dot(const Point& p, const Point& q) { return p.x * q.x + p.y * q.y; }
double cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }
// Is the scalar product, of vectors rounded once, positive?
bool surely_ahead(const Point& p, const Point& q) {
  return dot(p, q) >
         8 * u * (std::abs(p.x * q.x) + std::abs(p.y * q.y)) + std::numeric_limits<double>::min();
}
Point difference(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }

// Bounds on how far a point is from a segment ab, and on which side.
struct Distance {
  double bound;
  bool is_left;  // of the line, or nearly on it
};

// With q = p - a, rounded by u of each coordinate: the cross product is off by 4u |q| |ab|,
// so the distance from the line by 4u |q| and 4u of itself; and where the foot is wrongly
// taken to lie between a and b, it is beyond them by 4u |q| at most.
Distance distance(const Point& p, const Point& a, const Point& b) {
  const Point ab = difference(b, a);
  const Point q = difference(p, a);
  const double along = dot(q, ab);
  const double square = dot(ab, ab);
  const double across = cross(ab, q);
  constexpr double underflow = 1e-140;
  double length = 0;
  if (along > 0 && along < square && square > underflow * underflow) {
    length = std::abs(across) / std::sqrt(square);
  } else {
    const Point from_end = along > 0 ? difference(p, b) : q;
    length = std::sqrt(dot(from_end, from_end));
  }
  const double slack = 16 * u * (std::abs(q.x) + std::abs(q.y) + length) + underflow;
  return {length + slack, across >= 0};
}

// A vertex of the new boundary and the edge behind it.
struct NewVertex {
  Point place;
  Index first;  // of the given vertices that it stands for
  Index last;
  double error;    // how far both are from what they stand for
  double allowed;  // the tolerance there
};
using Boundary = std::vector<NewVertex>;

class Simplification {
 public:
  Simplification(const Polygon& polygon, double tolerance, Rounding rounding)
      : polygon_(polygon),
        ring_(polygon.vertices),
        rounding_(rounding),
        allowed_at_first_(std::min(ring_.scaled(tolerance), ring_.extent())),
        allowed_(polygon.size(), allowed_at_first_) {}

  // Nothing where more than so many vertices would be left.
  std::optional<Simplified> run(std::size_t most_vertices) {
    const std::vector<Index> corners = three_corners();
    for (int round = 0; round < most_rounds; ++round) {
      Boundary boundary = shortened(corners);
      if (rounding_ == Rounding::outward) {
        boundary = with_caps(without_dents(boundary));
      }
      if (boundary.size() > most_vertices) {
        return std::nullopt;
      }
      const std::vector<Index> wrong = wrong_edges(boundary);
      if (wrong.empty()) {
        return result(boundary);
      }
      cut_tolerance(boundary, wrong, round);
    }
    return std::nullopt;
  }

 private:
  static constexpr int most_rounds = 16;

  [[nodiscard]] const Point& vertex(Index i) const {
    return polygon_.vertices[i == polygon_.size() ? 0 : i];
  }
  [[nodiscard]] static const NewVertex& at(const Boundary& boundary, std::size_t k) {
    return boundary[k == boundary.size() ? 0 : k];
  }

  // Vertices that are never left out in favour of a segment, so that a triangle stays however
  // large the tolerance is, unless it is too thin for doubles. The first is there again as the
  // last.
  [[nodiscard]] std::vector<Index> three_corners() const {
    const Index far = polygon_.lexicographic_max;
    Index widest = 0;
    double width = 0;
    for (Index i = 1; i < polygon_.size(); ++i) {
      const double w =
          std::abs(cross(difference(ring_[far], ring_[0]), difference(ring_[i], ring_[0])));
      if (i != far && (widest == 0 || w > width)) {
        width = w;
        widest = i;
      }
    }
    return {0, std::min(far, widest), std::max(far, widest), polygon_.size()};
  }

  [[nodiscard]] Boundary shortened(const std::vector<Index>& corners) const {
    Boundary boundary;
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      for (Index i = corners[k]; i < corners[k + 1];) {
        const Index j = end_of_chain(i, corners[k + 1]);
        if (rounding_ == Rounding::nearest) {
          boundary.push_back(segment(i, j));
        } else {
          append_hull(i, j, boundary);
        }
        i = j;
      }
    }
    return boundary;
  }

  // A vertex j up to `limit` such that a segment can stand for the chain from i to j: by
  // steps that double, then by halving, so that each vertex is looked at O(log n) times.
  [[nodiscard]] Index end_of_chain(Index i, Index limit) const {
    Index good = i + 1;
    Index bad = limit + 1;
    while (good < limit && bad > limit) {
      const Index next = std::min(limit, good + (good - i));
      (fits(i, next) ? good : bad) = next;
    }
    while (bad - good > 1 && good < limit) {
      const Index middle = good + (bad - good) / 2;
      (fits(i, middle) ? good : bad) = middle;
    }
    return good;
  }

  // Is the chain near enough to the segment between its ends? Outward, its hull takes its
  // place, which is as far out as the chain is and has to be near what is furthest in, and
  // about half of the tolerance is left for longer edges over dents and for caps.
  [[nodiscard]] bool fits(Index i, Index j) const {
    double left = 0;
    double right = 0;
    double allowed = allowed_[i];
    for (Index k = i + 1; k < j; ++k) {
      allowed = std::min(allowed, allowed_[k]);
      const Distance d = distance(ring_[k], ring_[i], ring_[j]);
      double& side = d.is_left ? left : right;
      side = std::max(side, d.bound);
      const double needed =
          rounding_ == Rounding::nearest ? std::max(left, right) : 2 * (left + right);
      if (!(needed <= allowed)) {
        return false;
      }
    }
    return true;
  }

  // Vertex i with the segment to vertex j.
  [[nodiscard]] NewVertex segment(Index i, Index j) const {
    double error = 0;
    for (Index k = i + 1; k < j; ++k) {
      error = std::max(error, distance(ring_[k], ring_[i], ring_[j]).bound);
    }
    return {vertex(i), i, i, error, *std::min_element(allowed_.begin() + i, allowed_.begin() + j)};
  }

  // The segment from a to `end`, in place of that from a to b and the one behind b. Where
  // these are within e of their chains and b within d of the new one, it is within e + d: the
  // chains need not be looked at again, unless that is too much.
  [[nodiscard]] NewVertex joined(const NewVertex& a, const NewVertex& b, Index end) const {
    const double height = distance(ring_[b.first], ring_[a.first], ring_[end]).bound;
    const double error = (std::max(a.error, b.error) + height) * (1 + 2 * u);
    const double allowed = std::min(a.allowed, b.allowed);
    return error <= allowed ? NewVertex{a.place, a.first, a.first, error, allowed}
                            : segment(a.first, end);
  }

  // The outer hull of the chain from i to j, without j.
  void append_hull(Index i, Index j, Boundary& boundary) const {
    std::vector<Index> hull{i};
    Tally tally;
    for (Index k = i + 1; k <= j; ++k) {
      while (hull.size() > 1 && orientation(vertex(hull[hull.size() - 2]), vertex(hull.back()),
                                            vertex(k), tally) <= 0) {
        hull.pop_back();
      }
      hull.push_back(k);
    }
    for (std::size_t h = 0; h + 1 < hull.size(); ++h) {
      append_hull_edge(hull[h], hull[h + 1], boundary);
    }
  }

  // The segment from i to j, or the chain itself where that is not all on its left or is
  // too far from it: chains that turn round can have such hulls.
  void append_hull_edge(Index i, Index j, Boundary& boundary) const {
    const NewVertex with_segment = segment(i, j);
    Tally tally;
    bool stands = with_segment.error <= with_segment.allowed;
    for (Index k = i + 1; stands && k < j; ++k) {
      stands = orientation(vertex(i), vertex(j), vertex(k), tally) >= 0;
    }
    if (stands) {
      boundary.push_back(with_segment);
      return;
    }
    for (Index k = i; k < j; ++k) {
      boundary.push_back(segment(k, k + 1));
    }
  }

  // Without the reflex vertices that a segment can be drawn over. Those behind and before
  // such a vertex may become reflex, so the last ones are looked at again; each is kept once
  // it has been found too deep.
  [[nodiscard]] Boundary without_dents(const Boundary& boundary) const {
    Boundary filled{boundary.front()};
    std::size_t settled = 1;  // as many of the vertices of `filled` stay
    Tally tally;
    for (std::size_t k = 1; k <= boundary.size(); ++k) {
      const Index end = k == boundary.size() ? polygon_.size() : boundary[k].first;
      while (filled.size() > settled) {
        const NewVertex& before = filled[filled.size() - 2];
        if (orientation(before.place, filled.back().place, vertex(end), tally) > 0) {
          break;
        }
        const NewVertex longer = joined(before, filled.back(), end);
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
    for (std::size_t k = 0; k < filled.size(); ++k) {  // what was joined may be nearer
      const Index end = k + 1 == filled.size() ? polygon_.size() : filled[k + 1].first;
      filled[k].error = std::min(filled[k].error, segment(filled[k].first, end).error);
    }
    return filled;
  }

  // Runs of convex vertices replaced by one vertex each.
  [[nodiscard]] Boundary with_caps(const Boundary& boundary) const {
    Boundary capped{boundary.front()};
    for (std::size_t i = 0; i + 1 < boundary.size();) {
      if (const std::optional<Cap> cap = longest_cap(boundary, i)) {
        capped.push_back(cap->vertex);
        i = cap->edge;
      } else {
        capped.push_back(boundary[++i]);
      }
    }
    return capped;
  }

  struct Cap {
    NewVertex vertex;
    std::size_t edge;  // the one behind it
  };

  // In place of the longest run of convex vertices behind edge i that turns by less than a
  // quarter: the point where edge i and the edge j behind the run meet.
  //
  // The distance from the convex hull of the run and both edges is a convex function along
  // the new edges, and largest at that point; and every point of the run is the nearest one to
  // a point of them. So each is as near to the other as the point is to the run.
  [[nodiscard]] std::optional<Cap> longest_cap(const Boundary& boundary, std::size_t i) const {
    const auto scaled = [&](std::size_t k) { return ring_.scaled(at(boundary, k).place); };
    const Point before = difference(scaled(i + 1), scaled(i));
    std::optional<Cap> longest;
    double error = std::max(boundary[i].error, at(boundary, i + 1).error);
    double allowed = std::min(boundary[i].allowed, at(boundary, i + 1).allowed);
    std::size_t nearest = i + 1;
    for (std::size_t j = i + 2; j < boundary.size(); ++j) {
      error = std::max(error, boundary[j].error);
      allowed = std::min(allowed, boundary[j].allowed);
      const Point behind = difference(scaled(j + 1), scaled(j));
      if (!turns_left(boundary, j - 1) || !turns_left(boundary, j) ||
          !(dot(before, behind) > 0 && cross(before, behind) > 0)) {
        break;
      }
      const std::optional<Point> place = meeting_point(boundary, i, j);
      if (!place) {
        break;
      }
      const auto to_edge = [&](std::size_t k) {
        return distance(ring_.scaled(*place), scaled(k), scaled(k + 1)).bound;
      };
      // As j grows, the edge of the run that is nearest moves on.
      double height = to_edge(nearest);
      for (; nearest + 1 < j && to_edge(nearest + 1) <= height; ++nearest) {
        height = to_edge(nearest + 1);
      }
      const double needed = (error + height) * (1 + 2 * u);
      if (!(needed <= allowed)) {
        break;
      }
      longest = Cap{{*place, boundary[i + 1].first, boundary[j].last, needed, allowed}, j};
    }
    return longest;
  }

  [[nodiscard]] static bool turns_left(const Boundary& boundary, std::size_t k) {
    Tally tally;
    return orientation(boundary[k - 1].place, boundary[k].place, at(boundary, k + 1).place, tally) >
           0;
  }

  // A point on or to the right of edges i and j, a few units in the last place at most from
  // where their lines meet, behind edge i and before edge j.
  //
  // So the new edge on edge j, whose other end also lies on or to the right of it, has all
  // of edge j on its left, and what is left of edge j and beside it, too.
  [[nodiscard]] std::optional<Point> meeting_point(const Boundary& boundary, std::size_t i,
                                                   std::size_t j) const {
    const Point& a = boundary[i].place;
    const Point& b = boundary[i + 1].place;
    const Point& c = boundary[j].place;
    const Point& d = at(boundary, j + 1).place;
    const Point start = ring_.scaled(b);
    const Point ab = difference(start, ring_.scaled(a));
    const Point cd = difference(ring_.scaled(d), ring_.scaled(c));
    const double along = cross(difference(ring_.scaled(c), start), cd) / cross(ab, cd);
    const Point meeting{start.x + along * ab.x, start.y + along * ab.y};
    const Point outwards{ab.y + cd.y, -(ab.x + cd.x)};
    const double unit = 2 * u * std::max(std::abs(meeting.x), std::abs(meeting.y)) /
                        std::max(std::abs(outwards.x), std::abs(outwards.y));
    Tally tally;
    for (const double steps : {0, 1, 2, 4, 8}) {
      const Point place = ring_.unscaled({meeting.x + steps * unit * outwards.x + 0.0,
                                          meeting.y + steps * unit * outwards.y + 0.0});
      if (std::isfinite(place.x) && std::isfinite(place.y) &&
          surely_ahead(difference(ring_.scaled(place), start), ab) &&
          surely_ahead(difference(ring_.scaled(c), ring_.scaled(place)), cd) &&
          orientation(a, b, place, tally) <= 0 && orientation(c, d, place, tally) <= 0) {
        return place;
      }
    }
    return std::nullopt;
  }

  // The edges that keep the boundary from being simple.
  [[nodiscard]] static std::vector<Index> wrong_edges(const Boundary& boundary) {
    PointVector places;
    places.reserve(boundary.size());
    std::vector<Index> wrong;
    for (std::size_t k = 0; k < boundary.size(); ++k) {
      if (boundary[k].place == at(boundary, k + 1).place) {
        wrong.push_back(static_cast<Index>(k));
      }
      places.push_back(boundary[k].place);
    }
    if (!wrong.empty()) {
      return wrong;
    }
    for (const std::size_t edge : find_conflicting_edges(places)) {
      wrong.push_back(static_cast<Index>(edge));
    }
    if (wrong.empty() && !is_counter_clockwise(places)) {
      wrong.resize(boundary.size());
      std::iota(wrong.begin(), wrong.end(), Index{0});
    }
    return wrong;
  }

  // Along the chains that these edges stand for, to a quarter; from a hundredth of the first
  // tolerance on, or in late rounds, to 0.
  void cut_tolerance(const Boundary& boundary, const std::vector<Index>& edges, int round) {
    const double least = round < most_rounds / 2 ? allowed_at_first_ / 100 : HUGE_VAL;
    std::vector<std::uint8_t> is_cut(allowed_.size());
    for (const Index edge : edges) {
      const Index end = edge + 1 == boundary.size() ? polygon_.size() : boundary[edge + 1].last;
      std::fill(is_cut.begin() + boundary[edge].first, is_cut.begin() + end, std::uint8_t{1});
    }
    for (std::size_t k = 0; k < allowed_.size(); ++k) {
      if (is_cut[k] != 0) {
        allowed_[k] = allowed_[k] / 4 < least ? 0 : allowed_[k] / 4;
      }
    }
  }

  [[nodiscard]] Simplified result(const Boundary& boundary) const {
    PointVector places;
    places.reserve(boundary.size());
    double error = 0;
    for (const NewVertex& v : boundary) {
      places.push_back(v.place);
      error = std::max(error, v.error);
    }
    Polygon simplified = make_polygon(std::move(places), "simplified polygon");
    for (Polygon::Corner& corner : simplified.corners) {
      corner.vertex_number = polygon_.corners[boundary[corner.vertex_number].first].vertex_number;
      corner.edge_number = polygon_.corners[boundary[corner.edge_number].last].edge_number;
    }
    return {std::make_shared<const Polygon>(std::move(simplified)), ring_.unscaled_bound(error)};
  }

  const Polygon& polygon_;
  const ScaledRing ring_;
  const Rounding rounding_;
  const double allowed_at_first_;
  std::vector<double> allowed_;  // along each edge
};

}  // namespace

Simplified simplify(const std::shared_ptr<const Polygon>& polygon, double tolerance,
                    Rounding rounding, std::size_t most_vertices) {
  if (tolerance > 0 && most_vertices < polygon->size()) {
    if (std::optional<Simplified> simplified =
            Simplification(*polygon, tolerance, rounding).run(most_vertices)) {
      return *std::move(simplified);
    }
  }
  return {polygon, 0};
}

}  // namespace gcv
