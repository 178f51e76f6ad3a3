// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Each edge of a ring of the region names the edges and vertices of A that it comes from. The
// distance of an edge of A from that segment is largest at one of its ends. Of several segments,
// each is the nearest one for a part of the edge, up to where the next one begins. An edge that
// nothing comes from has neighbours that are known: its points are no further away than along the
// boundary to these.
#include "region_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include "box.hpp"
#include "rounding.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

class Distances {
 public:
  Distances(const ExactRegion& region, const PointVector& places, double unit)
      : a_(*region.a.ring),
        unit_(unit),
        of_vertices_(a_.size(), infinity),
        of_edges_(a_.size(), infinity) {
    for (const RegionPart& part : region.parts) {
      for (std::size_t k = part.first; part.is_ring() && k < part.end(); ++k) {
        const std::size_t next = k + 1 < part.end() ? k + 1 : part.first;
        const EdgeName first = region.vertices[k].leaving();
        const EdgeName last = region.vertices[next].arriving();
        if (region.against_edges) {
          add(last, first, places[next], places[k]);
        } else {
          add(first, last, places[k], places[next]);
        }
      }
    }
  }

  [[nodiscard]] double largest() {
    bound_by_several();
    double result = 0;
    for (Index ring = 0; ring < a_.layout.ring_count(); ++ring) {
      result = std::max(result, largest_of(a_.layout.begin(ring), a_.layout.end(ring)));
    }
    return result;
  }

 private:
  // A segment that comes from what lies between two superset edges.
  void add(const EdgeName& begins, const EdgeName& ends, const Point& from, const Point& to) {
    const auto distance = [&](Index vertex) {
      const double bound = distance_bound(a_.vertices[vertex], from, to, unit_);
      of_vertices_[vertex] = std::min(of_vertices_[vertex], bound);
      return bound;
    };
    const bool is_one_ring = a_.layout.ring_of(begins.i) == a_.layout.ring_of(ends.i);
    const Index behind = ends.kind == EdgeName::corner ? ends.i : a_.next(ends.i);
    const Index end = is_one_ring ? behind : begins.i;
    Index i = begins.i;
    double at_start = distance(i);
    while (i != end) {
      const Index next = a_.next(i);
      const double at_end = distance(next);
      of_edges_[i] = std::min(of_edges_[i], std::max(at_start, at_end));
      keep(i, from, to);
      at_start = at_end;
      i = next;
    }
  }

  // A segment that comes from an edge of A.
  struct Segment {
    Index edge;
    double start;  // which part of the edge lies before the segment
    double end;
    Point from;
    Point to;
  };

  void keep(Index edge, const Point& from, const Point& to) {
    const Point& p = a_.vertices[edge];
    const Point& q = a_.vertices[a_.next(edge)];
    const double dx = q.x - p.x;
    const double dy = q.y - p.y;
    const double size = length_of(dx, dy);
    const auto along = [&](const Point& x) {
      return ((x.x - p.x) / size) * (dx / size) + ((x.y - p.y) / size) * (dy / size);
    };
    const Segment segment{edge, along(from), along(to), from, to};
    if (std::isfinite(segment.start) && std::isfinite(segment.end)) {
      segments_.push_back(segment);
    }
  }

  void bound_by_several() {
    std::sort(segments_.begin(), segments_.end(), [](const Segment& s, const Segment& t) {
      return std::tie(s.edge, s.start, s.end, s.from.x, s.from.y, s.to.x, s.to.y) <
             std::tie(t.edge, t.start, t.end, t.from.x, t.from.y, t.to.x, t.to.y);
    });
    for (std::size_t first = 0; first < segments_.size();) {
      const Index edge = segments_[first].edge;
      std::size_t end = first;
      while (end < segments_.size() && segments_[end].edge == edge) {
        ++end;
      }
      if (end - first > 1) {
        of_edges_[edge] = std::min(of_edges_[edge], distance_of_parts(first, end));
      }
      first = end;
    }
  }

  // Any point of the edge may end a part. So it does not matter how the segments lie.
  [[nodiscard]] double distance_of_parts(std::size_t first, std::size_t end) const {
    const Point& p = a_.vertices[segments_[first].edge];
    const Point& q = a_.vertices[a_.next(segments_[first].edge)];
    const double error = 8 * unit_;  // of a computed point on the edge
    double bound = 0;
    Point start = p;
    for (std::size_t k = first; k < end; ++k) {
      const Segment& segment = segments_[k];
      const double t = std::clamp(segment.end, 0.0, 1.0);
      const Point last = k + 1 == end ? q : Point{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      for (const Point& x : {start, last}) {
        const double distance = distance_bound(x, segment.from, segment.to, unit_);
        if (!(distance < infinity)) {
          return infinity;
        }
        bound = std::max(bound, distance);
      }
      start = last;
    }
    return sum_bound(bound, error);
  }

  [[nodiscard]] double length(Index edge) const {
    const Point& p = a_.vertices[edge];
    const Point& q = a_.vertices[a_.next(edge)];
    return length_bound(q.x - p.x, q.y - p.y);
  }

  double largest_of(Index begin, Index end) {
    // Twice round the ring each way, from what is known.
    for (int round = 0; round < 2; ++round) {
      for (Index i = begin; i < end; ++i) {
        double& next = of_vertices_[a_.next(i)];
        next = std::min(next, sum_bound(of_vertices_[i], length(i)));
      }
      for (Index i = end; i-- > begin;) {
        double& here = of_vertices_[i];
        here = std::min(here, sum_bound(of_vertices_[a_.next(i)], length(i)));
      }
    }
    double result = 0;
    for (Index i = begin; i < end; ++i) {
      const double along =
          (of_vertices_[i] + of_vertices_[a_.next(i)] + length(i)) * (0.5 + 0x1p-50);
      result = std::max(result, std::min(of_edges_[i], along));
    }
    return result < infinity ? result : extents(begin, end);
  }

  [[nodiscard]] double extents(Index begin, Index end) const {
    const Box box = box_of(std::span<const Point>(a_.vertices).subspan(begin, end - begin));
    return length_bound(box.x1 - box.x0, box.y1 - box.y0);
  }

  const Boundary& a_;
  double unit_;
  std::vector<double> of_vertices_;
  std::vector<double> of_edges_;
  std::vector<Segment> segments_;
};

}  // namespace

double distance_from_region(const ExactRegion& region, Task& task, Tally& tally) {
  const PointVector places = place_nearest(region, task, tally).places;
  const Point units = units_in_last_place(region.a.ring->vertices);
  return Distances(region, places, std::max(units.x, units.y)).largest();
}

}  // namespace gcv
