// SPDX-License-Identifier: LGPL-3.0-or-later
#include "penetration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "box.hpp"
#include "error.hpp"
#include "gap.hpp"
#include "outer_face.hpp"
#include "relation.hpp"

namespace gcv {

namespace {

Point negated(const Point& p) { return {-p.x, -p.y}; }

// The nearest of the free places that it is shown.
class NearestFree {
 public:
  NearestFree(const WaysOut& ways, EdgeCover& cover, const PlacedPair& placed, Tally& tally)
      : operands_(ways.operands()),
        wanted_(ways.wanted()),
        cover_(cover),
        from_(placed.b.translation),
        relative_(seen_from_first_vertices(operands_, from_)),
        slack_(cover.search().slack()),
        tally_(tally),
        reach_(distance_from_outside(operands_.relative_bounds(), relative_) + 4 * slack_) {}

  struct Found {
    ExactPoint point;
    Interval distance;
    PairEdge edge;  // it lies on the line of this superset edge,
    Interval parameter;
  };
  [[nodiscard]] const std::optional<Found>& found() const { return found_; }
  // Places further than this do not matter.
  [[nodiscard]] const double& reach() const { return reach_; }
  // The place to start from, in relative coordinates.
  [[nodiscard]] const Point& relative() const { return relative_; }

  // What covers show (sum/cover.hpp).
  void known_runs(const PlacesOnLine& /*places*/, std::vector<EdgeCover::Run>& /*runs*/) {}
  Place ring(const PlacesOnLine& places, const Place& from) {
    const Place to = cover_.end_of_free(places, from);
    if (wanted_.holes) {
      take(places, from, to);
    }
    return to;
  }
  void segment(const PlacesOnLine& places, const Place& from, const Place& to) {
    if (wanted_.fits) {
      take(places, from, to);
    }
  }
  void point(const PlacesOnLine& places, const Place& place) { segment(places, place, place); }

  // The places from one to another on a line.
  void take(const PlacesOnLine& places, const Place& from, const Place& to) {
    const SumEdge& s = places.line().at;
    const RelativeLine line{operands_.relative_start(places.line().edge), s.dx, s.dy};
    const Interval first = parameters_of(line, from);
    const Interval last = parameters_of(line, to);
    const double foot = foot_on(line);
    const double nearest = std::max(first.lo, std::min(foot, last.hi));
    if (distance_at(line, {nearest, nearest}).lo > reach_) {
      return;
    }
    const SumEdge across = perpendicular(s, {from_, {0, 0}});
    if (from_foot_to(s, from, across) >= 0) {
      compare(places, exact_point(s, from), line, first);
    } else if (from_foot_to(s, to, across) <= 0) {
      compare(places, exact_point(s, to), line, last);
    } else {
      compare(places, ExactPoint::of_crossing(s, across), line, {nearest, nearest});
    }
  }

  // May the distance of the sum of two vertices be within reach?
  [[nodiscard]] bool is_near(const VertexSum& sum) const {
    const Point p = operands_.relative(sum.i, sum.j);
    return !(std::hypot(p.x - relative_.x, p.y - relative_.y) - slack_ > reach_);
  }

 private:
  static Point seen_from_first_vertices(const Operands& operands, const Point& p) {
    const Point a = operands.a.origin();
    const Point b = operands.b.origin();
    return {rounded_sum(p.x, -a.x, -b.x), rounded_sum(p.y, -a.y, -b.y)};
  }

  // How far the nearest side of the box is. Outside of it all is free.
  static double distance_from_outside(const Box& box, const Point& p) {
    return std::max(0.0, std::min({p.x - box.x0, box.x1 - p.x, p.y - box.y0, box.y1 - p.y}));
  }

  [[nodiscard]] Interval parameters_of(const RelativeLine& line, const Place& place) const {
    if (!place.is_sum) {
      return place.parameter;
    }
    const Point p = operands_.relative(place.sum.i, place.sum.j);
    const double t = std::abs(line.dx) >= std::abs(line.dy) ? (p.x - line.origin.x) / line.dx
                                                            : (p.y - line.origin.y) / line.dy;
    const double error = 2 * slack_ / std::max(std::abs(line.dx), std::abs(line.dy));
    return {t - error, t + error};
  }
  // The parameter of the foot of the perpendicular from the place to start from.
  [[nodiscard]] double foot_on(const RelativeLine& line) const {
    const double size = std::hypot(line.dx, line.dy);
    const double x = line.dx / size;
    const double y = line.dy / size;
    return ((relative_.x - line.origin.x) * x + (relative_.y - line.origin.y) * y) / size;
  }
  // The distance of a place with a parameter in that interval.
  [[nodiscard]] Interval distance_at(const RelativeLine& line, const Interval& parameter) const {
    const Point p = line.at(parameter.lo);
    const double distance = std::hypot(p.x - relative_.x, p.y - relative_.y);
    const double error =
        4 * slack_ + 2 * (parameter.hi - parameter.lo) * std::hypot(line.dx, line.dy);
    return {distance - error, distance + error};
  }

  // Does the place lie ahead of the foot on s (1), behind it (-1), or on it (0)?
  [[nodiscard]] int from_foot_to(const SumEdge& s, const Place& place, const SumEdge& across) {
    return place.is_sum ? -side(across, point_of(place.sum), tally_)
                        : compare_crossings(s, line_of(place.crossing), across, tally_);
  }

  [[nodiscard]] SumPoint point_of(const VertexSum& sum) const {
    return {operands_.a.vertices[sum.i], operands_.b.vertices[sum.j]};
  }
  [[nodiscard]] SumEdge line_of(const EdgeName& edge) const {
    return coordinates(operands_.a, operands_.b, edge);
  }
  [[nodiscard]] ExactPoint exact_point(const SumEdge& s, const Place& place) const {
    return place.is_sum ? ExactPoint::of_sum(point_of(place.sum))
                        : ExactPoint::of_crossing(s, line_of(place.crossing));
  }

  void compare(const PlacesOnLine& places, const ExactPoint& point, const RelativeLine& line,
               const Interval& parameter) {
    const Interval distance = distance_at(line, parameter);
    if (found_ && !is_before(point, distance)) {
      return;
    }
    found_ = {point, distance, places.line().edge, parameter};
    reach_ = std::min(reach_, distance.hi);
  }
  [[nodiscard]] bool is_before(const ExactPoint& point, const Interval& distance) {
    if (distance.hi < found_->distance.lo || distance.lo > found_->distance.hi) {
      return distance.hi < found_->distance.lo;
    }
    const int order = compare_distances(point, found_->point, from_, tally_);
    return order < 0 || (order == 0 && compare_lexicographically(point, found_->point, tally_) < 0);
  }

  const Operands& operands_;
  const WantedParts wanted_;
  EdgeCover& cover_;
  const Point from_;
  const Point relative_;
  const double slack_;
  Tally& tally_;
  double reach_;
  std::optional<Found> found_;
};

// Shows the outer ring.
void show_outer_ring(const WaysOut& ways, NearestFree& nearest, Tally& tally) {
  const std::vector<RingVertex>& ring = ways.outer_ring();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const RingVertex& from = ring[k];
    const RingVertex& to = ring[k + 1 < ring.size() ? k + 1 : 0];
    const PlacesOnLine places(ways.operands(), ways.operands().named(from.leaving()), tally);
    nearest.take(places, places.place(from, from.arriving()), places.place(to, to.leaving()));
  }
}

// Does a superset edge hold the point?
bool holds(const Operands& operands, const PairEdge& edge, const ExactPoint& point, Tally& tally) {
  const SumEdge line = coordinates(operands.a, operands.b, edge);
  return side(line, point, tally) == 0 &&
         side(perpendicular(line, line.origin), point, tally) <= 0 &&
         side(perpendicular(line, operands.end(edge)), point, tally) >= 0;
}

// The contact in the place: of the superset edges that hold it, the first by kind and the caller's
// numbers.
Contact contact_in(const WaysOut& ways, WitnessSearch& search, const NearestFree::Found& found,
                   Tally& tally) {
  using Key = std::tuple<ContactKind, Index, Index>;
  const Operands& operands = ways.operands();
  const auto& of_a = operands.a.corners;
  const auto& of_b = operands.b.corners;
  std::optional<std::pair<Key, PairEdge>> first;
  const auto consider = [&](const PairEdge& edge, const Key& key) {
    if ((!first || key < first->first) && holds(operands, edge, found.point, tally)) {
      first = {key, edge};
    }
  };
  const SumEdge line = coordinates(operands.a, operands.b, found.edge);
  const bool is_certain = search.slack() < std::numeric_limits<double>::infinity();
  const Interval at = is_certain ? found.parameter : Interval{0, 1};
  // On an outer ring the place may lie beyond the end of the edge.
  double length = 1;
  while (at.hi > length) {
    length *= 2;
  }
  search.begin({operands.relative_start(found.edge), length * line.dx, length * line.dy});
  for (const auto& [i, j] : search.pairs_near(at.lo / length, at.hi / length)) {
    const PairEdge translated = operands.translated(i, j);
    if (operands.b_contributes(j, translated.rank)) {
      consider(translated, {ContactKind::edge_vertex, of_a[i].edge_number, of_b[j].vertex_number});
    }
    const PairEdge corner = operands.corner(i, j);
    if (operands.a_contributes(i, corner.rank)) {
      consider(corner, {ContactKind::vertex_edge, of_a[i].vertex_number, of_b[j].edge_number});
    }
  }
  if (!first) {
    return {};
  }
  const auto& [key, edge] = *first;
  Contact contact;
  std::tie(contact.kind, contact.a, contact.b) = key;
  contact.normal = outward_normal(coordinates(operands.a, operands.b, edge), tally);
  contact.on_a = contact.kind == ContactKind::edge_vertex
                     ? nearest_point(found.point, negated(operands.b.vertices[edge.j]), tally)
                     : operands.a.vertices[edge.i];
  contact.on_b = contact.on_a;
  return contact;
}

}  // namespace

WaysOut::WaysOut(const Polygon& a, const Polygon& reflected_b, const WantedParts& wanted,
                 Task& task, Tally& tally)
    : operands_{a.boundary(), reflected_b.boundary(),
                merge_directions(a.boundary(), reflected_b.boundary(), tally)},
      wanted_(wanted) {
  if (!wanted.holes) {
    outer_ring_ = walk_outer_face(a.outer, reflected_b.outer, task, tally).vertices;
  }
}

Escape EscapeSearch::find(const PlacedPair& placed, Task& task) {
  const Point& from = placed.b.translation;
  if (relation(placed, tally_) != Relation::overlapping) {
    const ExactPoint start = ExactPoint::of_sum({from, {0, 0}});
    return {0, {0, 0}, usable_position(placed.pair, start, tally_), {}};
  }
  NearestFree nearest(ways_, cover_, placed, tally_);
  if (!ways_.wanted().holes) {
    show_outer_ring(ways_, nearest, tally_);
  }
  if (ways_.wanted().holes || ways_.wanted().fits) {
    known_.clear();
    nearest_edges_.for_each(
        nearest.relative(), nearest.reach(), [&](const PairEdge& s) { return known_.hold(s); },
        [&](const PairEdge& s) { cover_.walk(s, nearest); }, [&] { task.advance(0); });
  }
  if (ways_.wanted().fits) {
    cover_.visit_touches(nearest, [&](const VertexSum& sum) { return nearest.is_near(sum); });
  }
  if (!nearest.found()) {
    throw Error(Status::internal, "no way out of an overlap");
  }
  const NearestFree::Found& found = *nearest.found();
  return {nearest_distance(found.point, from, tally_),
          nearest_point(found.point, negated(from), tally_),
          usable_position(placed.pair, found.point, tally_),
          contact_in(ways_, cover_.search(), found, tally_)};
}

}  // namespace gcv
