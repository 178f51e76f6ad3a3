// SPDX-License-Identifier: LGPL-3.0-or-later
#include "plane_graph.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <utility>

#include "area.hpp"
#include "cycle.hpp"
#include "vector.hpp"

namespace gcv {

PlaneGraph::PlaneGraph(const std::vector<Segment>& segments, Tally& tally) {
  assert(!segments.empty());
  for (const Segment& s : segments) {
    points_.push_back(s.low);
    points_.push_back(s.high);
  }
  std::sort(points_.begin(), points_.end(), lexicographically_less);
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  ends.reserve(segments.size());
  for (const Segment& s : segments) {
    ends.emplace_back(number(s.low), number(s.high));
  }
  first_.resize(points_.size() + 1);
  for (const auto& [low, high] : ends) {
    ++first_[low + 1];
    ++first_[high + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  neighbours_.resize(first_.back());
  std::vector<std::size_t> free(first_.begin(), first_.end() - 1);
  for (const auto& [low, high] : ends) {
    neighbours_[free[low]++] = high;
    neighbours_[free[high]++] = low;
  }
  for (std::size_t p = 0; p < size(); ++p) {
    sort_round(p, tally);
  }
}

std::size_t PlaneGraph::number(const Point& p) const {
  return static_cast<std::size_t>(
      std::lower_bound(points_.begin(), points_.end(), p, lexicographically_less) -
      points_.begin());
}

void PlaneGraph::sort_round(std::size_t p, Tally& tally) {
  const Point& centre = points_[p];
  const auto begin = neighbours_.begin();
  std::sort(begin + static_cast<std::ptrdiff_t>(first_[p]),
            begin + static_cast<std::ptrdiff_t>(first_[p + 1]), [&](std::size_t q, std::size_t r) {
              return (q < p) != (r < p) ? r < p
                                        : orientation(centre, points_[q], points_[r], tally) > 0;
            });
}

std::vector<std::size_t> outer_walk(const PlaneGraph& graph) {
  std::vector<std::size_t> walk;
  const std::size_t second = graph.neighbours(0).front();
  std::size_t from = 0;
  std::size_t at = second;
  do {
    walk.push_back(from);
    const std::span<const std::size_t> neighbours = graph.neighbours(at);
    const auto next = std::find(neighbours.begin(), neighbours.end(), from) + 1;
    from = at;
    at = next == neighbours.end() ? neighbours.front() : *next;
  } while (from != 0 || at != second);
  return walk;
}

std::vector<std::size_t> largest_cycle(const PlaneGraph& graph,
                                       const std::vector<std::size_t>& walk, const Point& unit) {
  constexpr auto nowhere = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> largest;
  double largest_area = 0;
  std::vector<std::size_t> path;
  std::vector<std::size_t> index_in_path(graph.size(), nowhere);
  PointVector ring;
  const auto close_at = [&](std::size_t start) {
    ring.clear();
    for (std::size_t k = start; k < path.size(); ++k) {
      const Point& p = graph.point(path[k]);
      ring.push_back({p.x / unit.x, p.y / unit.y});
    }
    const double area = ring.size() < 3 ? 0 : ring_area(ring);
    if (area > largest_area) {
      largest_area = area;
      largest.assign(path.begin() + static_cast<std::ptrdiff_t>(start), path.end());
    }
    for (std::size_t k = start + 1; k < path.size(); ++k) {
      index_in_path[path[k]] = nowhere;
    }
    path.resize(start + 1);
  };
  for (const std::size_t p : walk) {
    if (index_in_path[p] == nowhere) {
      index_in_path[p] = path.size();
      path.push_back(p);
    } else {
      close_at(index_in_path[p]);
    }
  }
  close_at(0);
  return largest;
}

// From each vertex of the graph a way leads to a vertex of the ring, its anchor. No point of a
// segment is further from the anchor of one end than the further end is.
double distance_left_out(const PlaneGraph& graph, const std::vector<std::size_t>& ring) {
  constexpr auto none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> anchor(graph.size(), none);
  std::vector<std::size_t> after(graph.size(), none);  // the next vertex of the ring
  for (std::size_t k = 0; k < ring.size(); ++k) {
    anchor[ring[k]] = ring[k];
    after[ring[k]] = ring[cyclic_next(k, ring.size())];
  }
  std::vector<std::size_t> queue = ring;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    for (const std::size_t q : graph.neighbours(queue[k])) {
      if (anchor[q] == none) {
        anchor[q] = anchor[queue[k]];
        queue.push_back(q);
      }
    }
  }
  assert(std::find(anchor.begin(), anchor.end(), none) == anchor.end());  // it is connected
  double distance = 0;
  for (std::size_t p = 0; p < graph.size(); ++p) {
    const Point& origin = graph.point(anchor[p]);
    const auto length = [&](std::size_t q) {
      return length_bound(graph.point(q).x - origin.x, graph.point(q).y - origin.y);
    };
    for (const std::size_t q : graph.neighbours(p)) {
      if (after[p] != q && after[q] != p) {
        distance = std::max({distance, length(p), length(q)});
      }
    }
  }
  return distance;
}

}  // namespace gcv
