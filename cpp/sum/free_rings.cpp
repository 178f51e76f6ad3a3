// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_rings.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

#include "box.hpp"
#include "box_tree.hpp"
#include "cycle.hpp"
#include "error.hpp"
#include "exact_order.hpp"
#include "overlapping_pairs.hpp"
#include "piece.hpp"
#include "predicates.hpp"
#include "ring_predicates.hpp"
#include "task.hpp"
#include "tree_product.hpp"

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
    std::vector<std::size_t> last_place(ring.size());  // of each point in `open`, which may be over
    for (const Visit& visit : visits_of(ring)) {
      std::size_t& place = last_place[visit.point];
      if (place >= open.size() || open[place].point != visit.point) {
        place = open.size();
        open.push_back(visit);
        continue;
      }
      const auto earlier = open.begin() + static_cast<std::ptrdiff_t>(place);
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
      pace_.step(16);
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
          const EdgeName edge = edge_before(corner, ring[cyclic_next(k, n)], placed[on], way);
          visits.push_back({ring[on], points[on], edge, edge});
        }
      }
    }
    return visits;
  }

  // A superset edge that makes what comes right before a point of an edge of a ring, from one
  // corner to the next. `way`: the order of these.
  EdgeName edge_before(const RingVertex& corner, const RingVertex& next,
                       const ExactOrder::Placed& point, int way) {
    const auto comes = [&](const VertexSum& sum) {
      const EdgeName edge = corner.leaving();
      return way * order_.compare(order_.placed(RingVertex::sum(sum.i, sum.j, edge, edge)), point);
    };
    const auto makes = [&](const EdgeName& e) {
      return comes(start_of(e)) > 0 && comes(end_of(operands_, e)) <= 0;
    };
    for (const EdgeName& edge : {corner.leaving(), next.arriving()}) {
      if (makes(edge)) {
        return edge;
      }
    }
    // Several follow one another.
    if (!superset_) {
      superset_.emplace(operands_);
    }
    const PairEdge along = operands_.named(corner.leaving());
    const SumEdge line = coordinates(operands_.a, operands_.b, along);
    const Point start = operands_.relative_start(along);
    Piece piece(line, start, start, operands_.relative_end(next.arriving()), slack_of(operands_));
    std::optional<EdgeName> first;
    superset_->search(piece, [&](Index i, Index j) {
      superset_->for_each_edge(i, j, [&](const PairEdge& e) {
        if (e.rank == along.rank && !(first && first->key() < e.key()) &&
            side(line, operands_.start(e), tally_) == 0 && makes(e)) {
          first = e;
        }
      });
    });
    if (!first) {
      throw Error(Status::internal, "no edge makes a ring");
    }
    return *first;
  }

  bool lies_on_line(const EdgeName& edge, const RingVertex& v) {
    return side_of_vertex(operands_.a, operands_.b, coordinates(operands_.a, operands_.b, edge), v,
                          tally_) == 0;
  }

  const Operands& operands_;
  const ExactOrder& order_;
  Tally& tally_;
  Pace pace_;
  std::optional<TreeProduct> superset_;  // made when it is needed
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

// Finds the polygons that rings lie in.
class Holders {
 public:
  Holders(const Operands& operands, const ExactOrder& order,
          const std::vector<FreePolygon>& polygons, Tally& tally)
      : operands_(operands), order_(order), tally_(tally) {
    std::vector<Box> boxes;
    for (const FreePolygon& polygon : polygons) {
      const auto number = static_cast<Index>(firsts_.size());
      firsts_.push_back(edges_.size());
      ExactOrder::Placed from = order.placed(polygon.outer.back());
      for (const RingVertex& vertex : polygon.outer) {
        pace_.step(16);
        const ExactOrder::Placed to = order.placed(vertex);
        edges_.push_back({number, from, to});
        boxes.push_back(ExactOrder::box_of_edge(from, to));
        from = to;
      }
    }
    firsts_.push_back(edges_.size());
    tree_ = BoxTree(boxes);
  }

  // Of the polygons that it lies in, the innermost begins last.
  std::size_t find(const Ring& ring) {
    for (const RingVertex& vertex : ring) {
      const std::optional<std::size_t> holder = innermost(vertex);
      if (holder) {
        return *holder;
      }
    }
    return innermost_by_all(ring);
  }

 private:
  struct Edge {
    Index polygon;
    ExactOrder::Placed from;
    ExactOrder::Placed to;
  };
  enum class Place { beside, below, on };

  // Of a point and an edge: is it below, between its ends? Points are compared in lexicographic
  // order, so that no edge is upright.
  Place place(const ExactOrder::Placed& point, const Edge& edge) {
    const int before = order_.compare(edge.from, point);
    const int behind = order_.compare(edge.to, point);
    if (before == 0 || behind == 0) {
      return behind == 0 ? Place::on : Place::beside;
    }
    if (before * behind > 0) {
      return Place::beside;
    }
    // Turned rings have edges against their superset edges. The line is the same.
    const PairEdge line = operands_.named(edge.from.vertex.leaving());
    const int side =
        side_of_vertex(operands_.a, operands_.b, coordinates(operands_.a, operands_.b, line),
                       point.vertex, tally_);
    if (side == 0) {
      return Place::on;
    }
    // Does the line go to the right? Then a point on the right of it lies below.
    const auto [p, q] = operands_.source(line);
    return (side < 0) == lexicographically_less(p, q) ? Place::below : Place::beside;
  }

  // A point is inside where it is below an odd number of edges. Nothing if it lies on an edge.
  std::optional<std::size_t> innermost(const RingVertex& vertex) {
    pace_.step(64);
    const ExactOrder::Placed point = order_.placed(vertex);
    Box above = ExactOrder::box_of_edge(point, point);
    above.y1 = infinity;
    below_.clear();
    bool is_on = false;
    tree_.for_each_near(above, [&](std::uint32_t k, const Box&) {
      const Place found = place(point, edges_[k]);
      is_on = is_on || found == Place::on;
      if (found == Place::below) {
        below_.push_back(edges_[k].polygon);
      }
    });
    if (is_on) {
      return std::nullopt;
    }
    std::sort(below_.begin(), below_.end(), std::greater<>());
    for (auto first = below_.begin(); first != below_.end();) {
      const auto last = std::upper_bound(first, below_.end(), *first, std::greater<>());
      if ((last - first) % 2 != 0) {
        return *first;
      }
      first = last;
    }
    throw Error(Status::internal, "an island that lies in no face");
  }

  // All vertices lie on edges. Those of the holder go through one vertex at most, since its inside
  // is connected. Those of a polygon in the island go through none of its convex hull, where what
  // is blocked is a single sector. So each polygon leaves a vertex that tells whether it holds.
  std::size_t innermost_by_all(const Ring& ring) {
    for (std::size_t polygon = firsts_.size() - 1; polygon-- > 0;) {
      bool holds = false;
      for (const RingVertex& vertex : ring) {
        const ExactOrder::Placed point = order_.placed(vertex);
        bool is_on = false;
        bool is_inside = false;
        for (std::size_t k = firsts_[polygon]; k < firsts_[polygon + 1] && !is_on; ++k) {
          const Place found = place(point, edges_[k]);
          is_on = found == Place::on;
          is_inside = is_inside != (found == Place::below);
        }
        if (!is_on) {
          holds = is_inside;
          break;
        }
      }
      if (holds) {
        return polygon;
      }
    }
    throw Error(Status::internal, "an island that lies in no face");
  }

  const Operands& operands_;
  const ExactOrder& order_;
  Tally& tally_;
  std::vector<Edge> edges_;  // polygon after polygon
  std::vector<std::size_t> firsts_;
  BoxTree tree_;
  std::vector<Index> below_;
  Pace pace_;
};

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
  if (!holes.empty()) {
    Holders holders(operands, order, polygons, tally);
    for (Ring& hole : holes) {
      polygons[holders.find(hole)].holes.push_back(std::move(hole));
    }
  }
  return polygons;
}

}  // namespace gcv
