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
using TreeEdge = std::pair<bg::model::segment<TreePoint>, std::size_t>;
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

// The smallest of the indices of the closest edges. The tree gives some of equally close ones: so
// it is asked for more, until one is further away.
std::size_t first_of_closest(const Tree& tree, const TreePoint& p) {
  std::vector<TreeEdge> edges;
  for (unsigned count = 4;; count *= 4) {
    edges.clear();
    tree.query(bg::index::nearest(p, count), std::back_inserter(edges));
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    std::size_t first = 0;
    for (const auto& [edge, index] : edges) {
      const double distance = bg::comparable_distance(p, edge);
      first = distance > least ? first : distance < least ? index : std::min(first, index);
      least = std::min(least, distance);
      most = std::max(most, distance);
    }
    if (most > least || edges.size() < count) {
      return first;
    }
  }
}

}  // namespace

std::vector<std::size_t> closest_edges(std::span<const Point> ring, const PointVector& points,
                                       Task& task) {
  std::vector<std::size_t> by_place(ring.size());
  for (std::size_t k = 0; k < ring.size(); ++k) {
    by_place[k] = k;
  }
  std::sort(by_place.begin(), by_place.end(), [&](std::size_t i, std::size_t j) {
    return ring[i] == ring[j] ? i < j : lexicographically_less(ring[i], ring[j]);
  });
  Tree tree;
  const Scale scale(box_of(ring));
  std::vector<std::size_t> indices;
  indices.reserve(points.size());
  for (const Point& p : points) {
    if (indices.size() % Task::portion == Task::portion - 1) {
      task.poll();
    }
    const auto equal = std::lower_bound(
        by_place.begin(), by_place.end(), p,
        [&](std::size_t k, const Point& q) { return lexicographically_less(ring[k], q); });
    if (equal != by_place.end() && ring[*equal] == p) {
      indices.push_back(*equal);
      continue;
    }
    if (tree.empty()) {
      std::vector<TreeEdge> edges;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        edges.push_back({{scale(ring[k]), scale(ring[cyclic_next(k, ring.size())])}, k});
      }
      tree = Tree(edges.begin(), edges.end());
    }
    indices.push_back(first_of_closest(tree, scale(p)));
  }
  return indices;
}

std::vector<std::uint64_t> exact_indices(const ExactRing& exact, const RoundedRing& rounded) {
  Task task;
  Tally tally;
  const Placement placement = place_nearest(exact, task, tally);
  const std::vector<std::size_t> indices = closest_edges(placement.places, rounded.vertices, task);
  return {indices.begin(), indices.end()};
}

}  // namespace gcv
