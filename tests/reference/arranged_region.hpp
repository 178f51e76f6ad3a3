// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What open sums cover, or leave free: its parts, by an arrangement.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sum_arrangement.hpp"

namespace gcv::reference::arranged {

// ---- Regions

using PointRing = std::vector<ExactPoint>;

inline bool less(const PointRing& r, const PointRing& s) {
  return std::lexicographical_compare(r.begin(), r.end(), s.begin(), s.end(),
                                      [](const ExactPoint& p, const ExactPoint& q) {
                                        return CGAL::lexicographically_xy_smaller(p, q);
                                      });
}

// Without its collinear vertices, from its smallest vertex.
inline PointRing canonical(const PointRing& points) {
  PointRing corners;
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (!CGAL::collinear(points[(k + n - 1) % n], points[k], points[(k + 1) % n])) {
      corners.push_back(points[k]);
    }
  }
  std::rotate(corners.begin(),
              std::min_element(corners.begin(), corners.end(),
                               [](const ExactPoint& p, const ExactPoint& q) {
                                 return CGAL::lexicographically_xy_smaller(p, q);
                               }),
              corners.end());
  return corners;
}

// Part of the plane, with its border.
struct Frame {
  Vector<Integer> low;
  Vector<Integer> high;
};

class Region {
 public:
  enum class Kind { sum, free_in_container, free_in_window };

  // The region is the closure of an open sum, or what is in none of some. In a window, that is cut,
  // and its closure taken; fits are those without the window, and stay where they are in it.
  Region(const std::vector<Summands>& sums, Kind kind, const std::optional<Frame>& window = {})
      : bits_(bits(sums)),
        is_sum_(kind == Kind::sum),
        is_covered_far_off_(kind == Kind::free_in_container) {
    if (window) {
      for (const auto& p : {window->low, window->high}) {
        bits_ = std::max({bits_, bits(p.x), bits(p.y)});
      }
    }
    std::vector<Traits::X_monotone_curve_2> segments;
    for (const Span& s : all_sums(sums)) {
      segments.emplace_back(point(s.from, bits_), point(s.to, bits_));
    }
    if (window) {
      const auto& [low, high] = *window;
      low_ = point(low, bits_);
      high_ = point(high, bits_);
      const ExactPoint corners[] = {*low_, point({high.x, low.y}, bits_), *high_,
                                    point({low.x, high.y}, bits_)};
      for (int k = 0; k < 4; ++k) {
        segments.emplace_back(corners[k], corners[(k + 1) % 4]);
      }
    }
    for (const Summands& sum : sums) {
      open_sums_.emplace_back(sum, bits_);
    }
    CGAL::insert(arrangement_, segments.begin(), segments.end());
    classify();
  }

  // The solids are 2^scale times as large as the parts.
  std::vector<RegionPart> parts(int scale, const Point& shift) {
    std::vector<RegionPart> result;
    const Rational unit(Integer(1) << bits_, Integer(1) << scale);
    const auto put = [&](int kind, std::uint32_t polygon, const PointRing& points) {
      RegionPart part{kind, polygon, {}};
      for (const ExactPoint& p : points) {
        const Rational x = unit * rational(p.x()) + Rational(shift.x);
        const Rational y = unit * rational(p.y()) + Rational(shift.y);
        part.vertices.push_back(fraction(x) + " " + fraction(y));
      }
      result.push_back(std::move(part));
    };
    std::uint32_t number = 0;
    for (const Polygon& polygon : polygons()) {
      put(1, number, polygon.outer);
      for (const PointRing& hole : polygon.holes) {
        put(2, number, hole);
      }
      ++number;
    }
    for (const PointRing& s : segments()) {
      put(3, 0xffffffff, s);
    }
    for (const PointRing& p : points()) {
      put(4, 0xffffffff, p);
    }
    return result;
  }

 private:
  struct Polygon {
    PointRing outer;
    std::vector<PointRing> holes;
  };

  Arrangement arrangement_;
  std::vector<OpenSum> open_sums_;
  int bits_;
  bool is_sum_;
  bool is_covered_far_off_;
  std::optional<ExactPoint> low_;  // of the window
  std::optional<ExactPoint> high_;

  static std::string fraction(const Rational& x) {
    return numerator(x).str() + "/" + denominator(x).str();
  }

  bool covers(const ExactPoint& p) {
    const About place = about(p);
    return std::any_of(open_sums_.begin(), open_sums_.end(),
                       [&](OpenSum& sum) { return sum.surely_covers(place); }) ||
           std::any_of(open_sums_.begin(), open_sums_.end(), [&](const OpenSum& sum) {
             return sum.covers(rational(p.x()), rational(p.y()));
           });
  }

  // On its border, too.
  bool in_window(const ExactPoint& p) const {
    return !low_ ||
           (low_->x() <= p.x() && p.x() <= high_->x() && low_->y() <= p.y() && p.y() <= high_->y());
  }

  // Its number is left to the caller.
  Mark mark(const Face& face) {
    if (face->is_unbounded()) {
      return {is_covered_far_off_, !low_};
    }
    const ExactPoint p = inner_point(face);
    return {covers(p), in_window(p)};
  }

  // What touches something that is not covered is not covered itself, for the sum is open.
  void classify() {
    std::size_t count = 0;
    for (Face face : arrangement_.face_handles()) {
      face->data() = mark(face);
      face->data().index = count++;
    }
    for (Halfedge edge : arrangement_.edge_handles()) {
      const ExactPoint middle = CGAL::midpoint(edge->source()->point(), edge->target()->point());
      const bool covered =
          edge->face()->data().covered && edge->twin()->face()->data().covered && covers(middle);
      edge->data() = edge->twin()->data() = {covered, in_window(middle)};
    }
    for (Vertex vertex : arrangement_.vertex_handles()) {
      bool covered = true;
      const auto first = vertex->incident_halfedges();
      auto edge = first;
      do {
        covered = covered && edge->data().covered;
      } while (++edge != first);
      vertex->data() = {covered && covers(vertex->point()), in_window(vertex->point())};
    }
  }

  bool in_region(const Face& face) const {
    return face->data().covered == is_sum_ && face->data().in_window;
  }

  // Has it the inside of the region on its left and not on its right?
  bool on_ring(const Halfedge& edge) const {
    return in_region(edge->face()) && !in_region(edge->twin()->face());
  }
  // Is it an exact fit, in the window or not?
  static bool fits(const Halfedge& edge) {
    return !edge->data().covered && edge->face()->data().covered &&
           edge->twin()->face()->data().covered;
  }
  static bool on_segment(const Halfedge& edge) { return fits(edge) && edge->data().in_window; }
  bool on_ring(const Vertex& vertex) const {
    const auto first = vertex->incident_halfedges();
    auto edge = first;
    do {
      if (in_region(edge->face()) != in_region(edge->twin()->face())) {
        return true;
      }
    } while (++edge != first);
    return false;
  }

  // Faces of the inside of the region: faces of the arrangement and the edges between them.
  std::vector<std::size_t> inner_faces() {
    std::vector<std::size_t> parent(arrangement_.number_of_faces());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t k) {
      while (parent[k] != k) {
        k = parent[k] = parent[parent[k]];
      }
      return k;
    };
    for (Halfedge edge : arrangement_.edge_handles()) {
      if (in_region(edge->face()) && in_region(edge->twin()->face())) {
        parent[root(edge->face()->data().index)] = root(edge->twin()->face()->data().index);
      }
    }
    for (std::size_t k = 0; k < parent.size(); ++k) {
      parent[k] = root(k);
    }
    return parent;
  }

  // The closed walk along the boundary of one inner face.
  std::vector<Vertex> walk(Halfedge edge) {
    std::vector<Vertex> vertices;
    while (!edge->data().visited) {
      edge->data().visited = true;
      vertices.push_back(edge->target());
      edge = edge->next();
      while (!on_ring(edge)) {
        edge = edge->twin()->next();
      }
    }
    return vertices;
  }

  // The walk, cut wherever it comes to a vertex again.
  static std::vector<PointRing> simple_rings(const std::vector<Vertex>& walk) {
    std::vector<PointRing> rings;
    std::vector<Vertex> open;
    const auto close = [&](std::vector<Vertex>::iterator from) {
      PointRing ring;
      std::transform(from, open.end(), std::back_inserter(ring),
                     [](const Vertex& v) { return v->point(); });
      rings.push_back(canonical(ring));
      open.erase(from, open.end());
    };
    for (const Vertex& v : walk) {
      const auto earlier = std::find(open.begin(), open.end(), v);
      if (earlier != open.end()) {
        close(earlier);
      }
      open.push_back(v);
    }
    close(open.begin());
    return rings;
  }

  // Canonical rings turn at their smallest vertex.
  static bool is_counter_clockwise(const PointRing& ring) {
    return CGAL::left_turn(ring.back(), ring[0], ring[1]);
  }

  std::vector<Polygon> polygons() {
    const std::vector<std::size_t> inner_face = inner_faces();
    std::map<std::size_t, Polygon> by_face;
    for (Halfedge edge : arrangement_.halfedge_handles()) {
      if (edge->data().visited || !on_ring(edge)) {
        continue;
      }
      Polygon& polygon = by_face[inner_face[edge->face()->data().index]];
      for (PointRing& ring : simple_rings(walk(edge))) {
        if (!is_counter_clockwise(ring)) {
          polygon.holes.push_back(std::move(ring));
        } else if (polygon.outer.empty()) {
          polygon.outer = std::move(ring);
        } else {
          throw std::logic_error("a face with two outer rings");
        }
      }
    }
    std::vector<Polygon> result;
    for (auto& [face, polygon] : by_face) {
      if (polygon.outer.empty()) {
        throw std::logic_error("a face without an outer ring");
      }
      std::sort(polygon.holes.begin(), polygon.holes.end(), less);
      result.push_back(std::move(polygon));
    }
    std::sort(result.begin(), result.end(),
              [](const Polygon& p, const Polygon& q) { return less(p.outer, q.outer); });
    return result;
  }

  // The next edge of the same segment, if the segment goes on where this one ends.
  std::optional<Halfedge> straight_on(const Halfedge& edge) const {
    const Vertex vertex = edge->target();
    if (on_ring(vertex)) {
      return std::nullopt;
    }
    const ExactPoint& p = edge->source()->point();
    const ExactPoint& q = vertex->point();
    const auto first = vertex->incident_halfedges();
    auto other = first;
    do {
      const ExactPoint& r = other->source()->point();
      if (on_segment(other->twin()) && CGAL::collinear(p, q, r) &&
          CGAL::collinear_are_strictly_ordered_along_line(p, q, r)) {
        return other->twin();
      }
    } while (++other != first);
    return std::nullopt;
  }

  std::vector<PointRing> segments() {
    std::vector<PointRing> result;
    for (Halfedge edge : arrangement_.halfedge_handles()) {
      if (!on_segment(edge) || edge->direction() != CGAL::ARR_LEFT_TO_RIGHT ||
          straight_on(edge->twin())) {
        continue;
      }
      Halfedge last = edge;
      while (const auto next = straight_on(last)) {
        last = *next;
      }
      result.push_back({edge->source()->point(), last->target()->point()});
    }
    std::sort(result.begin(), result.end(), less);
    return result;
  }

  // Of a fit that is alone, or of segments that end outside of the window.
  bool is_alone(const Vertex& vertex) const {
    if (vertex->data().covered || !vertex->data().in_window || on_ring(vertex)) {
      return false;
    }
    bool is_covered_around = true;
    bool has_fit = false;
    const auto first = vertex->incident_halfedges();
    auto edge = first;
    do {
      if (on_segment(edge)) {
        return false;
      }
      is_covered_around = is_covered_around && edge->data().covered;
      has_fit = has_fit || fits(edge);
    } while (++edge != first);
    return is_covered_around || has_fit;
  }

  std::vector<PointRing> points() {
    std::vector<PointRing> result;
    for (Vertex vertex : arrangement_.vertex_handles()) {
      if (is_alone(vertex)) {
        result.push_back({vertex->point()});
      }
    }
    std::sort(result.begin(), result.end(), less);
    return result;
  }
};

}  // namespace gcv::reference::arranged
