// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_indices.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "box.hpp"
#include "cycle.hpp"

namespace gcv {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::d2::point_xy<double>;
using Segment = bg::model::segment<TreePoint>;
using TreeEdge = std::pair<Segment, std::size_t>;
using Tree = bg::index::rtree<TreeEdge, bg::index::quadratic<16>>;

// Points near the origin and of the size 1, so that distances neither overflow nor underflow.
class Scale {
 public:
  explicit Scale(const Box& box)
      : origin_{box.x0 / 2 + box.x1 / 2, box.y0 / 2 + box.y1 / 2},
        size_(std::max({box.x1 / 2 - box.x0 / 2, box.y1 / 2 - box.y0 / 2,
                        std::numeric_limits<double>::denorm_min()})) {}

  [[nodiscard]] TreePoint operator()(const Point& p) const {
    return {(p.x - origin_.x) / size_, (p.y - origin_.y) / size_};
  }

 private:
  Point origin_;
  double size_;
};

double distance(const TreePoint& p, const Segment& segment) {
  const double dx = segment.second.x() - segment.first.x();
  const double dy = segment.second.y() - segment.first.y();
  const double x = p.x() - segment.first.x();
  const double y = p.y() - segment.first.y();
  const double square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp((x * dx + y * dy) / square, 0.0, 1.0) : 0;
  return std::sqrt((x - t * dx) * (x - t * dx) + (y - t * dy) * (y - t * dy));
}

// An edge of one ring among those of another.
class ClosestEdge {
 public:
  ClosestEdge(const TreePoint& from, const TreePoint& to)
      : from_(from), to_(to), middle_((from.x() + to.x()) / 2, (from.y() + to.y()) / 2) {}

  // The first of the closest ones. No edge is further from the middle than from both ends. So more
  // and more of those near that are looked at, until the others are too far away, with room for
  // roundings: which of those that are as near the tree gives first depends on how it was made.
  [[nodiscard]] std::size_t in(const Tree& tree) const {
    std::vector<TreeEdge> edges;
    for (unsigned count = 4;; count *= 4) {
      edges.clear();
      tree.query(bg::index::nearest(middle_, count), std::back_inserter(edges));
      double least = infinity;
      double furthest = 0;
      std::size_t first = 0;
      for (const auto& [edge, index] : edges) {
        const double d = distance_of(edge);
        first = d > least ? first : d < least ? index : std::min(first, index);
        least = std::min(least, d);
        furthest = std::max(furthest, distance(middle_, edge));
      }
      if (furthest > least + 0x1p-45 || edges.size() < count) {
        return first;
      }
    }
  }

 private:
  [[nodiscard]] double distance_of(const Segment& edge) const {
    const double dx = to_.x() - from_.x();
    const double dy = to_.y() - from_.y();
    const bool is_against =
        dx * (edge.second.x() - edge.first.x()) + dy * (edge.second.y() - edge.first.y()) < 0;
    return std::max(distance(from_, edge), distance(to_, edge)) +
           (is_against ? std::sqrt(dx * dx + dy * dy) : 0);
  }

  TreePoint from_;
  TreePoint to_;
  TreePoint middle_;
};

Tree tree_of(std::span<const Point> ring, const Scale& scale) {
  std::vector<TreeEdge> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    edges.push_back({{scale(ring[k]), scale(ring[cyclic_next(k, ring.size())])}, k});
  }
  Tree tree(edges.begin(), edges.end());
  return tree;
}

}  // namespace

DistinctPlaces distinct_places(std::span<const Point> places, std::size_t first,
                               bool from_smallest) {
  std::size_t size = places.size();
  while (size > 1 && places[size - 1] == places[0]) {
    --size;  // these belong to the first place
  }
  DistinctPlaces distinct;
  distinct.places.reserve(size);
  distinct.indices.reserve(size);
  for (std::size_t k = 0; k < size; ++k) {
    if (k == 0 || !(places[k] == places[k - 1])) {
      distinct.places.push_back(places[k]);
      distinct.indices.push_back(first + k);
    }
  }
  if (from_smallest) {
    const auto smallest = static_cast<std::ptrdiff_t>(lexicographic_min(distinct.places));
    std::rotate(distinct.places.begin(), distinct.places.begin() + smallest, distinct.places.end());
    std::rotate(distinct.indices.begin(), distinct.indices.begin() + smallest,
                distinct.indices.end());
  }
  return distinct;
}

std::vector<std::size_t> closest_edges(std::span<const Point> other, const PointVector& ring,
                                       Task& task) {
  std::vector<std::size_t> by_place(other.size());
  for (std::size_t k = 0; k < other.size(); ++k) {
    by_place[k] = k;
  }
  std::sort(by_place.begin(), by_place.end(), [&](std::size_t i, std::size_t j) {
    return other[i] == other[j] ? i < j : lexicographically_less(other[i], other[j]);
  });
  Tree tree;
  const Scale scale(box_of(other));
  std::vector<std::size_t> indices;
  indices.reserve(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    if (k % Task::portion == Task::portion - 1) {
      task.poll();
    }
    const Point& p = ring[k];
    const auto equal = std::lower_bound(
        by_place.begin(), by_place.end(), p,
        [&](std::size_t i, const Point& q) { return lexicographically_less(other[i], q); });
    if (equal != by_place.end() && other[*equal] == p) {
      indices.push_back(*equal);
      continue;
    }
    if (tree.empty()) {
      tree = tree_of(other, scale);
    }
    const Point& q = ring[cyclic_next(k, ring.size())];
    indices.push_back(ClosestEdge(scale(p), scale(q)).in(tree));
  }
  return indices;
}

std::vector<std::uint64_t> exact_indices(const ExactRing& exact, const RoundedRing& rounded) {
  Task task;
  Tally tally;
  Placement placement = place_nearest(exact, task, tally);
  const PointVector nearest = placement.places;
  if (make_simple(exact, placement, task, tally)) {
    DistinctPlaces distinct = distinct_places(placement.places, 0, true);
    if (distinct.places == rounded.vertices) {
      return std::move(distinct.indices);
    }
  }
  const std::vector<std::size_t> indices = closest_edges(nearest, rounded.vertices, task);
  return {indices.begin(), indices.end()};
}

}  // namespace gcv
