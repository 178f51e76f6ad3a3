// SPDX-License-Identifier: LGPL-3.0-or-later
#include "untangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "area.hpp"
#include "exact_numbers.hpp"
#include "repair.hpp"
#include "rounding.hpp"
#include "simplicity.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

constexpr int rounds = 32;

struct LexicographicOrder {
  bool operator()(const Point& p, const Point& q) const { return lexicographically_less(p, q); }
};

SumEdge segment(const Point& p, const Point& q) {
  return {{p, {0, 0}}, p, q, q.x - p.x, q.y - p.y};
}

// The double point nearest to the crossing of the lines of two segments.
Point rounded_crossing(const SumEdge& s, const SumEdge& t, Tally& tally) {
  Grid grid;
  grid.include(s);
  grid.include(t);
  return with_integers(rounding_bits(crossing_bits(grid.bits())), tally, [&]<class Integer>() {
    const auto p = crossing<Integer>(grid, s, t, {0, 0});
    return Point{nearest_double(p.x, p.w, grid.exponent()).value,
                 nearest_double(p.y, p.w, grid.exponent()).value};
  });
}

// Cuts the edges of a closed polyline where they meet each other.
class Cutter {
 public:
  Cutter(const std::vector<Point>& ring, Tally& tally)
      : ring_(ring), cuts_(ring.size()), tally_(tally) {}

  // The polyline with its cuts; error_bound grows by what rounding them moved.
  std::vector<Point> run(double& error_bound) {
    for (const Conflict& conflict : find_all_conflicts(ring_)) {
      cut(conflict.first, conflict.second);
    }
    std::vector<Point> result;
    for (std::size_t e = 0; e < ring_.size(); ++e) {
      result.push_back(ring_[e]);
      const Point& p = ring_[e];
      std::sort(cuts_[e].begin(), cuts_[e].end(), [&](const Point& q, const Point& r) {
        return lexicographically_less(p, end(e)) ? lexicographically_less(q, r)
                                                 : lexicographically_less(r, q);
      });
      result.insert(result.end(), cuts_[e].begin(), cuts_[e].end());
    }
    error_bound += moved_;
    return snap(result).vertices;
  }

 private:
  [[nodiscard]] const Point& end(std::size_t e) const {
    return ring_[e + 1 == ring_.size() ? 0 : e + 1];
  }

  void cut(std::size_t e, std::size_t f) {
    bool touch = false;
    for (const Point& p : {ring_[f], end(f)}) {
      touch |= cut_at_vertex(e, p);
    }
    for (const Point& p : {ring_[e], end(e)}) {
      touch |= cut_at_vertex(f, p);
    }
    if (!touch) {
      const Point p =
          rounded_crossing(segment(ring_[e], end(e)), segment(ring_[f], end(f)), tally_);
      add(e, p);
      add(f, p);
      const double unit = unit_in_last_place(p);
      moved_ = std::max(moved_, unit);
    }
  }

  // Cuts e at p where p lies on it. Does e hold p?
  bool cut_at_vertex(std::size_t e, const Point& p) {
    const Point& from = ring_[e];
    const Point& to = end(e);
    const auto& [low, high] = std::minmax(from, to, lexicographically_less);
    if (lexicographically_less(p, low) || lexicographically_less(high, p) ||
        orientation(from, to, p, tally_) != 0) {
      return false;
    }
    add(e, p);
    return true;
  }

  void add(std::size_t e, const Point& p) {
    if (!(p == ring_[e]) && !(p == end(e))) {
      cuts_[e].push_back(p);
    }
  }

  const std::vector<Point>& ring_;
  std::vector<std::vector<Point>> cuts_;
  double moved_ = 0;
  Tally& tally_;
};

// The plane graph of a polyline that meets itself only in its vertices.
using Graph = std::map<Point, std::vector<Point>, LexicographicOrder>;

Graph plane_graph(const std::vector<Point>& ring, Tally& tally) {
  Graph graph;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point& p = ring[k];
    const Point& q = ring[k + 1 == ring.size() ? 0 : k + 1];
    graph[p].push_back(q);
    graph[q].push_back(p);
  }
  for (auto& [p, neighbours] : graph) {
    const Point& centre = p;
    // Counter-clockwise from the direction that points down.
    std::sort(neighbours.begin(), neighbours.end(), [&](const Point& q, const Point& r) {
      const bool q_is_left = lexicographically_less(q, centre);
      const bool r_is_left = lexicographically_less(r, centre);
      return q_is_left != r_is_left ? r_is_left : orientation(centre, q, r, tally) > 0;
    });
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  }
  return graph;
}

// The walk round the unbounded face, counter-clockwise from the smallest vertex: in each
// vertex the first edge counter-clockwise from the way back.
std::vector<Point> outer_walk(const Graph& graph) {
  std::vector<Point> walk;
  const Point start = graph.begin()->first;
  const Point second = graph.begin()->second.front();
  Point from = start;
  Point at = second;
  do {
    walk.push_back(from);
    const std::vector<Point>& neighbours = graph.at(at);
    auto next = std::find(neighbours.begin(), neighbours.end(), from) + 1;
    from = at;
    at = next == neighbours.end() ? neighbours.front() : *next;
  } while (!(from == start && at == second));
  return walk;
}

// Of the simple cycles that a closed walk consists of, the one with the largest area.
std::vector<Point> largest_cycle(const std::vector<Point>& walk) {
  std::vector<Point> largest;
  double largest_area = 0;
  std::vector<Point> path;
  std::map<Point, std::size_t, LexicographicOrder> place_in_path;
  const auto close_at = [&](std::size_t place) {
    const std::vector<Point> cycle(path.begin() + static_cast<std::ptrdiff_t>(place), path.end());
    const double area = cycle.size() < 3 ? 0 : ring_area(cycle);
    if (area > largest_area) {
      largest_area = area;
      largest = cycle;
    }
    for (std::size_t k = place + 1; k < path.size(); ++k) {
      place_in_path.erase(path[k]);
    }
    path.resize(place + 1);
  };
  for (const Point& p : walk) {
    const auto [place, is_new] = place_in_path.try_emplace(p, path.size());
    if (is_new) {
      path.push_back(p);
    } else {
      close_at(place->second);
    }
  }
  close_at(0);
  return largest;
}

// At least the distance from the ring of the polyline, which the ring is part of: a stretch
// that is not is no further from where it leaves the ring than its vertices are.
double distance_left_out(const std::vector<Point>& polyline, const std::vector<Point>& ring) {
  std::map<Point, Point, LexicographicOrder> successor;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    successor[ring[k]] = ring[k + 1 == ring.size() ? 0 : k + 1];
  }
  const auto on_ring = [&](const Point& p) { return successor.contains(p); };
  const auto is_edge = [&](const Point& p, const Point& q) {
    return on_ring(p) && on_ring(q) && (successor[p] == q || successor[q] == p);
  };
  const auto first = std::find_if(polyline.begin(), polyline.end(), on_ring);
  double distance = 0;
  Point left = *first;
  for (std::size_t k = 0; k < polyline.size(); ++k) {
    const std::size_t i =
        (static_cast<std::size_t>(first - polyline.begin()) + k) % polyline.size();
    const Point& p = polyline[i];
    const Point& q = polyline[i + 1 == polyline.size() ? 0 : i + 1];
    if (on_ring(p)) {
      left = p;
    }
    if (!is_edge(p, q)) {
      distance = std::max(distance, length_bound(q.x - left.x, q.y - left.y));
    }
  }
  return distance;
}

}  // namespace

std::optional<UntangledRing> untangle(std::vector<Point> polyline, Tally& tally) {
  UntangledRing result;
  for (int round = 0; round < rounds; ++round) {
    if (polyline.size() < 3) {
      return std::nullopt;
    }
    std::vector<Point> cut = Cutter(polyline, tally).run(result.error_bound);
    if (cut.size() == polyline.size()) {
      result.vertices = largest_cycle(outer_walk(plane_graph(polyline, tally)));
      if (result.vertices.empty() || find_conflict(result.vertices)) {
        return std::nullopt;
      }
      result.error_bound += distance_left_out(polyline, result.vertices);
      result.error_bound *= 1 + 0x1p-50;
      return result;
    }
    polyline = std::move(cut);
  }
  return std::nullopt;
}

}  // namespace gcv
