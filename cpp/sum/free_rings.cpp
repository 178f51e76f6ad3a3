// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_rings.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <utility>

#include "box.hpp"
#include "cycle.hpp"
#include "exact_order.hpp"
#include "overlapping_pairs.hpp"
#include "ring_predicates.hpp"

namespace gcv {

namespace {

using Ring = std::vector<RingVertex>;

// Cuts a ring where it visits a point twice: a corner on another corner, or on the inside of an
// edge.
class Cutter {
 public:
  Cutter(const Operands& operands, const ExactOrder& order, Tally& tally)
      : operands_(operands), order_(order), tally_(tally) {}

  // Appends the simple rings that the ring consists of.
  void cut(const Ring& ring, std::vector<Ring>& rings) {
    std::vector<Visit> open;
    for (const Visit& visit : visits_of(ring)) {
      const auto earlier = std::find_if(
          open.begin(), open.end(), [&](const Visit& other) { return other.point == visit.point; });
      if (earlier == open.end()) {
        open.push_back(visit);
        continue;
      }
      // What has closed ends with the edge that arrives now. The rest leaves by the edge that
      // leaves now.
      std::vector<Visit> closed(earlier, open.end());
      closed.front().arriving = visit.arriving;
      add(closed, rings);
      earlier->leaving = visit.leaving;
      open.erase(std::next(earlier), open.end());
    }
    add(open, rings);
  }

 private:
  // A ring in a point: in a corner, or on the inside of an edge that has a corner on it.
  struct Visit {
    RingVertex corner;
    Index point;  // the first corner there
    EdgeName arriving;
    EdgeName leaving;
  };

  [[nodiscard]] Rank rank(const EdgeName& edge) const { return operands_.named(edge).rank; }

  void add(const std::vector<Visit>& visits, std::vector<Ring>& rings) const {
    Ring ring;
    for (const auto& [corner, point, arriving, leaving] : visits) {
      if (rank(arriving) != rank(leaving)) {
        ring.push_back(corner.is_sum() ? RingVertex::sum(corner.i(), corner.j(), arriving, leaving)
                                       : RingVertex::crossing(arriving, leaving));
      }
    }
    if (ring.size() >= 3) {
      rings.push_back(std::move(ring));
    }
  }

  std::vector<Visit> visits_of(const Ring& ring) {
    const std::size_t n = ring.size();
    std::vector<ExactOrder::Placed> placed;
    for (const RingVertex& corner : ring) {
      placed.push_back(order_.placed(corner));
    }
    std::vector<Box> boxes(n);
    for (std::size_t k = 0; k < n; ++k) {
      boxes[k] = ExactOrder::box_of_edge(placed[k], placed[cyclic_next(k, n)]);
    }
    std::vector<Index> points(n);
    std::vector<std::vector<Index>> on_edges(n);
    for (std::size_t k = 0; k < n; ++k) {
      points[k] = static_cast<Index>(k);
    }
    const auto meet = [&](std::size_t edge, std::size_t corner) {
      const std::size_t next = cyclic_next(edge, n);
      if (corner == edge || corner == next) {
        return;
      }
      const int from = order_.compare(placed[edge], placed[corner]);
      if (from == 0) {
        points[std::max(edge, corner)] =
            std::min(points[std::max(edge, corner)], static_cast<Index>(std::min(edge, corner)));
      } else if (from * order_.compare(placed[corner], placed[next]) > 0 &&
                 lies_on_line(ring[edge].leaving(), ring[corner])) {
        on_edges[edge].push_back(static_cast<Index>(corner));
      }
    };
    OverlappingPairs(boxes).visit_all([&](std::size_t e, std::size_t f) {
      meet(e, f);
      meet(e, cyclic_next(f, n));
      meet(f, e);
      meet(f, cyclic_next(e, n));
    });
    std::vector<Visit> visits;
    for (std::size_t k = 0; k < n; ++k) {
      const RingVertex& corner = ring[k];
      visits.push_back({corner, points[k], corner.arriving(), corner.leaving()});
      const int way = order_.compare(placed[k], placed[cyclic_next(k, n)]);
      std::stable_sort(on_edges[k].begin(), on_edges[k].end(), [&](Index p, Index q) {
        return order_.compare(placed[p], placed[q]) * way > 0;
      });
      for (const Index on : on_edges[k]) {
        if (visits.back().point != points[on]) {
          visits.push_back({ring[on], points[on], corner.leaving(), corner.leaving()});
        }
      }
    }
    return visits;
  }

  bool lies_on_line(const EdgeName& edge, const RingVertex& v) {
    return side_of_vertex(operands_.a, operands_.b, coordinates(operands_.a, operands_.b, edge), v,
                          tally_) == 0;
  }

  const Operands& operands_;
  const ExactOrder& order_;
  Tally& tally_;
};

// The same ring, the other way round.
Ring turned_round(const Ring& ring) {
  Ring turned;
  turned.reserve(ring.size());
  for (const RingVertex& v : ring) {
    turned.push_back(v.is_sum() ? RingVertex::sum(v.i(), v.j(), v.leaving(), v.arriving())
                                : RingVertex::crossing(v.leaving(), v.arriving()));
  }
  std::reverse(turned.begin(), turned.end());
  return turned;
}

// 1 if the point lies inside the ring, 0 on it, -1 outside. Counts the edges above the point.
// Points are compared in lexicographic order, so that no edge is upright.
int locate(const Operands& operands, const ExactOrder& order, const Ring& ring,
           const RingVertex& point, Tally& tally) {
  bool is_inside = false;
  int last = order.compare(ring.back(), point);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RingVertex& from = ring[k == 0 ? ring.size() - 1 : k - 1];
    const int before = last;
    last = order.compare(ring[k], point);
    if (last == 0) {
      return 0;
    }
    if (before * last > 0) {
      continue;
    }
    // Turned rings have edges against their superset edges. The line is the same.
    const PairEdge line = operands.named(from.leaving());
    const int side = side_of_vertex(operands.a, operands.b,
                                    coordinates(operands.a, operands.b, line), point, tally);
    if (side == 0) {
      return 0;
    }
    // Does the line go to the right? Then a point on the right of it lies below.
    const auto [p, q] = operands.source(line);
    const bool is_below = (side < 0) == lexicographically_less(p, q);
    is_inside = is_inside != is_below;
  }
  return is_inside ? 1 : -1;
}

}  // namespace

std::vector<FreePolygon> free_polygons(const Operands& operands, std::vector<Ring> rings, bool cut,
                                       Tally& tally) {
  const ExactOrder order(operands.a, operands.b, {0, 0}, tally);
  if (cut) {
    Cutter cutter(operands, order, tally);
    std::vector<Ring> simple;
    for (const Ring& ring : rings) {
      cutter.cut(ring, simple);
    }
    rings = std::move(simple);
  }
  for (Ring& ring : rings) {
    ring = turned_round(ring);
  }
  order.sort(rings);
  std::vector<FreePolygon> polygons;
  std::vector<Ring> holes;
  for (Ring& ring : rings) {
    // Walked rings turn to the right in their smallest vertex round a face, to the left round an
    // island. Names are of walked edges: `leaving` arrives here.
    const RingVertex& first = ring.front();
    const Rank angle = operands.directions.angle(operands.named(first.leaving()).rank,
                                                 operands.named(first.arriving()).rank);
    if (angle > operands.directions.half_turn) {
      polygons.push_back({std::move(ring), {}});
    } else {
      holes.push_back(std::move(ring));
    }
  }
  for (Ring& hole : holes) {
    // Of the polygons that it lies in, the innermost begins last.
    const auto holds = [&](const FreePolygon& polygon) {
      for (const RingVertex& vertex : hole) {
        if (const int where = locate(operands, order, polygon.outer, vertex, tally); where != 0) {
          return where > 0;
        }
      }
      return true;
    };
    const auto polygon = std::find_if(polygons.rbegin(), polygons.rend(), holds);
    assert(polygon != polygons.rend());
    polygon->holes.push_back(std::move(hole));
  }
  return polygons;
}

}  // namespace gcv
