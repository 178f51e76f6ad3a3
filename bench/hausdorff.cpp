// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances from a convex set are convex functions. So no point of a segment is further
// from an edge of the other curve than the further one of its ends: where that is at most
// 1.05 times a distance which some point is known to have, the segment is done. Else it is
// halved. The nearest edge of a point is sought through a tree of boxes.
//
// Rounding: let u = 2^-113 and S the largest coordinate. Coordinates are off by at most u S,
// differences and products by relative errors of u. The computed foot of a perpendicular is
// off by some u S across the edge and, where the edge is short, by more along it, by at most
// its length; but at the foot the distance does not change along the edge in first order.
// In all a distance is off by less than 2^6 u S; 2^-100 S is taken.
#include "hausdorff.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gcv::bench {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 2, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;

constexpr double ratio = 1.05;        // of the bounds
constexpr double rounding = 0x1p-50;  // of some operations on doubles
constexpr std::size_t samples = 256;
constexpr std::size_t edges_ahead = 4;

WidePoint operator-(const WidePoint& p, const WidePoint& q) { return {p.x - q.x, p.y - q.y}; }
Wide dot(const WidePoint& p, const WidePoint& q) { return p.x * q.x + p.y * q.y; }

TreePoint to_tree(const WidePoint& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

Wide size_of(const WideRing& ring) {
  Wide size = 0;
  for (const WidePoint& p : ring) {
    size = std::max({size, p.x, -p.x, p.y, -p.y});
  }
  return size;
}

struct Nearest {
  std::size_t edge;
  Wide squared_distance;
};

class Curve {
 public:
  // Boxes of doubles are off by less than `box_slack`.
  Curve(const WideRing& ring, double box_slack) : ring_(ring), box_slack_(box_slack) {
    std::vector<std::pair<TreeBox, std::size_t>> boxes;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      TreeBox box;
      bg::envelope(bg::model::segment<TreePoint>(to_tree(ring[k]), to_tree(next(k))), box);
      boxes.emplace_back(box, k);
    }
    tree_ = Tree(boxes);
  }

  [[nodiscard]] std::size_t size() const { return ring_.size(); }
  [[nodiscard]] const WidePoint& operator[](std::size_t k) const { return ring_[k]; }
  [[nodiscard]] const WidePoint& next(std::size_t k) const {
    return ring_[k + 1 == ring_.size() ? 0 : k + 1];
  }

  [[nodiscard]] Wide squared_distance(const WidePoint& p, std::size_t edge) const {
    const WidePoint along = next(edge) - ring_[edge];
    const WidePoint to_p = p - ring_[edge];
    const Wide length = dot(along, along);
    const Wide t = length == 0 ? 0 : std::clamp<Wide>(dot(to_p, along) / length, 0, 1);
    const WidePoint rest{to_p.x - t * along.x, to_p.y - t * along.y};
    return dot(rest, rest);
  }

  [[nodiscard]] Nearest nearest(const WidePoint& p) const {
    const TreePoint place = to_tree(p);
    Nearest best{0, squared_distance(p, 0)};
    const auto count = static_cast<unsigned>(ring_.size());
    for (auto it = tree_.qbegin(bg::index::nearest(place, count)); it != tree_.qend(); ++it) {
      const double least = bg::distance(place, it->first) - box_slack_;
      if (least > 0 && Wide(least) * least > best.squared_distance) {
        break;
      }
      const Wide squared = squared_distance(p, it->second);
      if (squared < best.squared_distance) {
        best = {it->second, squared};
      }
    }
    return best;
  }

 private:
  using Tree = bg::index::rtree<std::pair<TreeBox, std::size_t>, bg::index::rstar<8>>;

  const WideRing& ring_;
  double box_slack_;
  Tree tree_;
};

// Of all points of both curves.
class Search {
 public:
  explicit Search(double slack) : slack_(slack) {}

  // Raises the lower bound by some points of p, so that few segments are halved in vain.
  void sample(const Curve& p, const Curve& q) {
    const std::size_t step = p.size() / samples + 1;
    for (std::size_t k = 0; k < p.size(); k += step) {
      place(p[k], q);
    }
  }

  // No point of p is further from q than upper() from now on.
  void cover(const Curve& p, const Curve& q) {
    std::size_t edge = 0;  // near the last segment
    for (std::size_t k = 0; k < p.size(); ++k) {
      const WidePoint& from = p[k];
      const WidePoint& to = p.next(k);
      std::size_t ahead = 0;
      while (ahead < edges_ahead && !is_near(from, to, q, (edge + ahead) % q.size())) {
        ++ahead;
      }
      edge =
          ahead < edges_ahead ? (edge + ahead) % q.size() : cover(place(from, q), place(to, q), q);
    }
  }

  [[nodiscard]] double lower() const { return lower_; }
  [[nodiscard]] double upper() const { return (ratio * lower_ + 2 * slack_) * (1 + rounding); }

 private:
  struct Place {
    WidePoint point;
    std::size_t nearest_edge;
  };

  Place place(const WidePoint& p, const Curve& q) {
    const Nearest nearest = q.nearest(p);
    const double distance = std::sqrt(static_cast<double>(nearest.squared_distance));
    lower_ = std::max(lower_, distance * (1 - rounding) - slack_);
    return {p, nearest.edge};
  }

  [[nodiscard]] bool is_near(const WidePoint& from, const WidePoint& to, const Curve& q,
                             std::size_t edge) const {
    const Wide distance = Wide(ratio) * lower_ + slack_;
    const Wide squared = distance * distance;
    return q.squared_distance(from, edge) <= squared && q.squared_distance(to, edge) <= squared;
  }

  // An edge that is near the last of the segment.
  std::size_t cover(const Place& from, const Place& to, const Curve& q) {
    for (const std::size_t edge : {to.nearest_edge, from.nearest_edge}) {
      if (is_near(from.point, to.point, q, edge)) {
        return edge;
      }
    }
    const Place middle =
        place({(from.point.x + to.point.x) / 2, (from.point.y + to.point.y) / 2}, q);
    cover(from, middle, q);
    return cover(middle, to, q);
  }

  double slack_;
  double lower_ = 0;
};

}  // namespace

Bounds hausdorff_distance(const WideRing& p, const WideRing& q) {
  const auto size = static_cast<double>(std::max(size_of(p), size_of(q)));
  const double box_slack = std::ldexp(size, -50);
  const Curve of_p(p, box_slack);
  const Curve of_q(q, box_slack);
  Search search(std::ldexp(size, -100));
  search.sample(of_p, of_q);
  search.sample(of_q, of_p);
  search.cover(of_p, of_q);
  search.cover(of_q, of_p);
  return {search.lower(), search.upper()};
}

}  // namespace gcv::bench
