// SPDX-License-Identifier: LGPL-3.0-or-later
#include "untangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "area.hpp"
#include "exact_numbers.hpp"
#include "overlapping_pairs.hpp"
#include "rounding.hpp"
#include "simplicity.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

struct LexicographicOrder {
  bool operator()(const Point& p, const Point& q) const { return lexicographically_less(p, q); }
};

// A segment, from its smaller end to the larger one.
struct Segment {
  Point low;
  Point high;

  friend bool operator==(const Segment& s, const Segment& t) {
    return s.low == t.low && s.high == t.high;
  }
  friend bool operator<(const Segment& s, const Segment& t) {
    return s.low == t.low ? lexicographically_less(s.high, t.high)
                          : lexicographically_less(s.low, t.low);
  }
};

Segment segment(const Point& p, const Point& q) {
  return lexicographically_less(p, q) ? Segment{p, q} : Segment{q, p};
}

SumEdge as_edge(const Segment& s) {
  return {{s.low, {0, 0}}, s.low, s.high, s.high.x - s.low.x, s.high.y - s.low.y};
}

// Snap rounding (Guibas and Marimont, "Rounding arrangements dynamically", 1998): the plane
// is divided into pixels; those that hold an end or a crossing of segments are hot,
// and each segment becomes the chain of the centres of the hot pixels that it passes. Then
// segments meet in such centres only.
class SnapRounding {
 public:
  SnapRounding(const std::vector<Segment>& segments, const Point& unit, Tally& tally)
      : segments_(segments), unit_(unit), chains_(segments.size()), tally_(tally) {}

  // The pieces of the chains, each once.
  std::vector<Segment> run() {
    find_hot_pixels();
    find_passages();
    std::vector<Segment> pieces;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      sort_along(segments_[i], chains_[i]);
      for (std::size_t k = 1; k < chains_[i].size(); ++k) {
        pieces.push_back(segment(chains_[i][k - 1], chains_[i][k]));
      }
    }
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
    return pieces;
  }

 private:
  // The centre of the pixel that holds the coordinate n / w * 2^exponent.
  template <class Integer>
  [[nodiscard]] static double centre(Integer n, Integer w, int exponent, double unit) {
    const int shift = exponent - std::ilogb(unit);
    if (shift >= 0) {
      n <<= shift;
    } else {
      w <<= -shift;
    }
    const Integer twice = 2 * w;
    n = 2 * n + w;
    auto [quotient, remainder] = divide(n, twice);
    if (sign(remainder) < 0) {
      quotient -= 1;  // division truncates; this rounds down
    }
    return static_cast<double>(quotient) * unit;
  }

  [[nodiscard]] int largest_shift(const Grid& grid) const {
    return std::max(std::abs(grid.exponent() - std::ilogb(unit_.x)),
                    std::abs(grid.exponent() - std::ilogb(unit_.y)));
  }

  // That of the coordinate x. The unit is a power of two: where the quotient is not exact, it
  // underflows, and the pixel is that of 0. Adding 0 turns -0 into 0.
  [[nodiscard]] static double centre(double x, double unit) {
    const double place = x / unit;
    const double below = std::floor(place);
    return (place - below < 0.5 ? below : below + 1) * unit + 0.0;
  }

  [[nodiscard]] Point pixel_of(const Point& p) const {
    return {centre(p.x, unit_.x), centre(p.y, unit_.y)};
  }

  [[nodiscard]] Point pixel_of_crossing(const Segment& s, const Segment& t) {
    const SumEdge e = as_edge(s);
    const SumEdge f = as_edge(t);
    Grid grid;
    grid.include(e);
    grid.include(f);
    const int bits = crossing_bits(grid.bits()) + largest_shift(grid) + 3;
    return with_integers(bits, tally_, [&]<class Integer>() {
      const auto p = crossing<Integer>(grid, e, f, {0, 0});
      return Point{centre(p.x, p.w, grid.exponent(), unit_.x),
                   centre(p.y, p.w, grid.exponent(), unit_.y)};
    });
  }

  void find_hot_pixels() {
    std::vector<Box> boxes;
    for (const Segment& s : segments_) {
      boxes.push_back(box_of(s.low, s.high));
      hot_.push_back(pixel_of(s.low));
      hot_.push_back(pixel_of(s.high));
    }
    OverlappingPairs(boxes).visit_all([&](std::size_t i, std::size_t j) {
      if (cross(segments_[i], segments_[j])) {
        hot_.push_back(pixel_of_crossing(segments_[i], segments_[j]));
      }
    });
    std::sort(hot_.begin(), hot_.end(), lexicographically_less);
    hot_.erase(std::unique(hot_.begin(), hot_.end()), hot_.end());
  }

  // Ends that touch are hot anyway.
  [[nodiscard]] bool cross(const Segment& s, const Segment& t) {
    const bool share_an_end =
        s.low == t.low || s.low == t.high || s.high == t.low || s.high == t.high;
    return !share_an_end &&
           orientation(s.low, s.high, t.low, tally_) * orientation(s.low, s.high, t.high, tally_) <
               0 &&
           orientation(t.low, t.high, s.low, tally_) * orientation(t.low, t.high, s.high, tally_) <
               0;
  }

  // Segments and pixels, in one tree: the pairs of one of each whose boxes overlap.
  void find_passages() {
    struct Item {
      Point place;
      std::size_t index;
      bool is_pixel;
    };
    std::vector<Item> items;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      items.push_back({segments_[i].low, i, false});
    }
    for (std::size_t h = 0; h < hot_.size(); ++h) {
      items.push_back({hot_[h], h, true});
    }
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
      return lexicographically_less(a.place, b.place);
    });
    std::vector<Box> boxes;
    for (const Item& item : items) {
      const Point& p = item.place;
      boxes.push_back(item.is_pixel
                          ? Box{p.x - unit_.x, p.y - unit_.y, p.x + unit_.x, p.y + unit_.y}
                          : box_of(segments_[item.index].low, segments_[item.index].high));
    }
    OverlappingPairs(boxes).visit_all([&](std::size_t k, std::size_t l) {
      if (items[k].is_pixel != items[l].is_pixel) {
        const std::size_t i = items[items[k].is_pixel ? l : k].index;
        const Point& h = hot_[items[items[k].is_pixel ? k : l].index];
        if (passes(segments_[i], h)) {
          chains_[i].push_back(h);
        }
      }
    });
  }

  // Does the segment meet the closed pixel around h? Its corners are kept as sums.
  [[nodiscard]] bool passes(const Segment& s, const Point& h) {
    if (s.low == h || s.high == h) {
      return true;
    }
    const Point half{unit_.x / 2, unit_.y / 2};
    const Box box = box_of(s.low, s.high);
    if (compare_sums(box.x0, 0, h.x, half.x, tally_) > 0 ||
        compare_sums(box.x1, 0, h.x, -half.x, tally_) < 0 ||
        compare_sums(box.y0, 0, h.y, half.y, tally_) > 0 ||
        compare_sums(box.y1, 0, h.y, -half.y, tally_) < 0) {
      return false;
    }
    const SumEdge line = as_edge(s);
    int lowest = 1;
    int highest = -1;
    for (const double x : {-half.x, half.x}) {
      for (const double y : {-half.y, half.y}) {
        const int corner = side(line, {h, {x, y}}, tally_);
        lowest = std::min(lowest, corner);
        highest = std::max(highest, corner);
      }
    }
    return lowest <= 0 && highest >= 0;
  }

  // Along the longer axis; where two pixels share a place on it, along the other one.
  void sort_along(const Segment& s, std::vector<Point>& chain) const {
    const double dx = s.high.x - s.low.x;
    const double dy = s.high.y - s.low.y;
    const double sx = dx < 0 ? -1 : 1;
    const double sy = dy < 0 ? -1 : 1;
    const bool flat = std::abs(dx) / unit_.x >= std::abs(dy) / unit_.y;
    std::sort(chain.begin(), chain.end(), [&](const Point& p, const Point& q) {
      const std::pair along(sx * p.x, sx * q.x);
      const std::pair across(sy * p.y, sy * q.y);
      const auto& first = flat ? along : across;
      const auto& second = flat ? across : along;
      return first.first != first.second ? first.first < first.second
                                         : second.first < second.second;
    });
  }

  const std::vector<Segment>& segments_;
  Point unit_;  // the size of a pixel
  std::vector<Point> hot_;
  std::vector<std::vector<Point>> chains_;
  Tally& tally_;
};

// The plane graph of segments that meet in their ends only.
using Graph = std::map<Point, std::vector<Point>, LexicographicOrder>;

Graph plane_graph(const std::vector<Segment>& segments, Tally& tally) {
  Graph graph;
  for (const Segment& s : segments) {
    graph[s.low].push_back(s.high);
    graph[s.high].push_back(s.low);
  }
  for (auto& [p, neighbours] : graph) {
    const Point& centre = p;
    // Counter-clockwise from the direction that points down.
    std::sort(neighbours.begin(), neighbours.end(), [&](const Point& q, const Point& r) {
      const bool q_is_left = lexicographically_less(q, centre);
      const bool r_is_left = lexicographically_less(r, centre);
      return q_is_left != r_is_left ? r_is_left : orientation(centre, q, r, tally) > 0;
    });
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

// At least the distance of the graph from the ring, which is part of it. The graph is
// connected: from each vertex of it a way leads to one of the ring, its anchor; and no
// point of a segment is further from the anchor of one end than both ends are.
double distance_left_out(const Graph& graph, const std::vector<Point>& ring) {
  std::map<Point, Point, LexicographicOrder> anchors;
  std::vector<Point> queue = ring;
  for (const Point& p : ring) {
    anchors.emplace(p, p);
  }
  double distance = 0;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Point p = queue[k];
    const Point anchor = anchors.at(p);
    for (const Point& q : graph.at(p)) {
      if (anchors.emplace(q, anchor).second) {
        queue.push_back(q);
      }
    }
  }
  std::set<Segment> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    edges.insert(segment(ring[k], ring[k + 1 == ring.size() ? 0 : k + 1]));
  }
  for (const auto& [p, neighbours] : graph) {
    const Point& anchor = anchors.at(p);
    for (const Point& q : neighbours) {
      if (!edges.contains(segment(p, q))) {
        distance = std::max({distance, length_bound(p.x - anchor.x, p.y - anchor.y),
                             length_bound(q.x - anchor.x, q.y - anchor.y)});
      }
    }
  }
  return distance;
}

}  // namespace

std::optional<UntangledRing> untangle(const std::vector<Point>& polyline, Tally& tally) {
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < polyline.size(); ++k) {
    segments.push_back(segment(polyline[k], polyline[k + 1 == polyline.size() ? 0 : k + 1]));
  }
  if (segments.size() < 3) {
    return std::nullopt;
  }
  const double smallest = 2 * std::numeric_limits<double>::denorm_min();  // that has a half
  Point unit = units_in_last_place(polyline);
  unit = {std::max(unit.x, smallest), std::max(unit.y, smallest)};
  const std::vector<Segment> pieces = SnapRounding(segments, unit, tally).run();
  if (pieces.empty()) {
    return std::nullopt;
  }
  const Graph graph = plane_graph(pieces, tally);
  UntangledRing result{largest_cycle(outer_walk(graph)), 0};
  if (result.vertices.empty() || find_conflict(result.vertices)) {
    return std::nullopt;
  }
  // No point of a segment is further than a pixel's diagonal from its chain.
  result.error_bound =
      sum_bound(length_bound(unit.x, unit.y), distance_left_out(graph, result.vertices));
  return result;
}

}  // namespace gcv
