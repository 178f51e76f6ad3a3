// SPDX-License-Identifier: LGPL-3.0-or-later
#include "untangle.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "area.hpp"
#include "exact_numbers.hpp"
#include "overlapping_pairs.hpp"
#include "rounding.hpp"
#include "simplicity.hpp"
#include "to_double.hpp"

namespace gcv {

namespace {

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

  // A hot pixel, by its centre, and the first segment that makes it hot.
  struct HotPixel {
    Point centre;
    std::size_t segment;
  };

  void find_hot_pixels() {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      const Segment& s = segments_[i];
      boxes.push_back(box_of(s.low, s.high));
      hot_.push_back({pixel_of(s.low), i});
      hot_.push_back({pixel_of(s.high), i});
    }
    OverlappingPairs(boxes).visit_all([&](std::size_t i, std::size_t j) {
      if (cross(segments_[i], segments_[j])) {
        hot_.push_back({pixel_of_crossing(segments_[i], segments_[j]), std::min(i, j)});
      }
    });
    std::sort(hot_.begin(), hot_.end(), [](const HotPixel& a, const HotPixel& b) {
      return a.centre == b.centre ? a.segment < b.segment
                                  : lexicographically_less(a.centre, b.centre);
    });
    hot_.erase(
        std::unique(hot_.begin(), hot_.end(),
                    [](const HotPixel& a, const HotPixel& b) { return a.centre == b.centre; }),
        hot_.end());
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

  // Segments and pixels, in one tree, each pixel next to its segment: the pairs of one of each
  // whose boxes overlap.
  void find_passages() {
    struct Item {
      std::size_t segment;
      const Point* pixel;  // none: the segment itself
    };
    std::vector<Item> items;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      items.push_back({i, nullptr});
    }
    for (const HotPixel& hot : hot_) {
      items.push_back({hot.segment, &hot.centre});
    }
    std::stable_sort(items.begin(), items.end(),
                     [](const Item& a, const Item& b) { return a.segment < b.segment; });
    std::vector<Box> boxes;
    for (const Item& item : items) {
      const Segment& s = segments_[item.segment];
      boxes.push_back(item.pixel == nullptr
                          ? box_of(s.low, s.high)
                          : Box{item.pixel->x - unit_.x, item.pixel->y - unit_.y,
                                item.pixel->x + unit_.x, item.pixel->y + unit_.y});
    }
    OverlappingPairs(boxes).visit_all([&](std::size_t k, std::size_t l) {
      if ((items[k].pixel == nullptr) != (items[l].pixel == nullptr)) {
        const std::size_t i = items[items[k].pixel == nullptr ? k : l].segment;
        const Point& h = *items[items[k].pixel == nullptr ? l : k].pixel;
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
  void sort_along(const Segment& s, PointVector& chain) const {
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
  std::vector<HotPixel> hot_;
  std::vector<PointVector> chains_;
  Tally& tally_;
};

// The plane graph of segments that meet in their ends only. Vertices are numbered in lexicographic
// order.
class PlaneGraph {
 public:
  PlaneGraph(const std::vector<Segment>& segments, Tally& tally) {
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
    std::vector<std::size_t> place(first_.begin(), first_.end() - 1);
    for (const auto& [low, high] : ends) {
      neighbours_[place[low]++] = high;
      neighbours_[place[high]++] = low;
    }
    for (std::size_t p = 0; p < size(); ++p) {
      sort_round(p, tally);
    }
  }

  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] const Point& point(std::size_t p) const { return points_[p]; }
  [[nodiscard]] std::size_t number(const Point& p) const {
    return static_cast<std::size_t>(
        std::lower_bound(points_.begin(), points_.end(), p, lexicographically_less) -
        points_.begin());
  }

  // Counter-clockwise from the direction that points down.
  [[nodiscard]] std::span<const std::size_t> neighbours(std::size_t p) const {
    return {&neighbours_[first_[p]], first_[p + 1] - first_[p]};
  }

 private:
  void sort_round(std::size_t p, Tally& tally) {
    const Point& centre = points_[p];
    const auto begin = neighbours_.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(first_[p]),
              begin + static_cast<std::ptrdiff_t>(first_[p + 1]),
              [&](std::size_t q, std::size_t r) {
                return (q < p) != (r < p) ? r < p
                                          : orientation(centre, points_[q], points_[r], tally) > 0;
              });
  }

  PointVector points_;
  std::vector<std::size_t> first_;  // place of the first neighbour of each vertex
  std::vector<std::size_t> neighbours_;
};

// The walk round the unbounded face, counter-clockwise from the smallest vertex: in each
// vertex the first edge counter-clockwise from the way back.
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

// Of the simple cycles that a closed walk consists of, the one with the largest area.
std::vector<std::size_t> largest_cycle(const PlaneGraph& graph,
                                       const std::vector<std::size_t>& walk) {
  constexpr auto nowhere = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> largest;
  double largest_area = 0;
  std::vector<std::size_t> path;
  std::vector<std::size_t> place_in_path(graph.size(), nowhere);
  PointVector ring;
  const auto close_at = [&](std::size_t place) {
    ring.clear();
    for (std::size_t k = place; k < path.size(); ++k) {
      ring.push_back(graph.point(path[k]));
    }
    const double area = ring.size() < 3 ? 0 : ring_area(ring);
    if (area > largest_area) {
      largest_area = area;
      largest.assign(path.begin() + static_cast<std::ptrdiff_t>(place), path.end());
    }
    for (std::size_t k = place + 1; k < path.size(); ++k) {
      place_in_path[path[k]] = nowhere;
    }
    path.resize(place + 1);
  };
  for (const std::size_t p : walk) {
    if (place_in_path[p] == nowhere) {
      place_in_path[p] = path.size();
      path.push_back(p);
    } else {
      close_at(place_in_path[p]);
    }
  }
  close_at(0);
  return largest;
}

// At least the distance of the graph from the ring, which is part of it. The graph is
// connected: from each vertex of it a way leads to one of the ring, its anchor; and no
// point of a segment is further from the anchor of one end than both ends are.
double distance_left_out(const PlaneGraph& graph, const std::vector<std::size_t>& ring) {
  constexpr auto none = std::numeric_limits<std::size_t>::max();
  std::vector<std::size_t> anchor(graph.size(), none);
  std::vector<std::size_t> after(graph.size(), none);  // of a vertex of the ring, the next one
  for (std::size_t k = 0; k < ring.size(); ++k) {
    anchor[ring[k]] = ring[k];
    after[ring[k]] = ring[k + 1 == ring.size() ? 0 : k + 1];
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

}  // namespace

std::optional<UntangledRing> untangle(const PointVector& polyline, Tally& tally) {
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
  const PlaneGraph graph(pieces, tally);
  const std::vector<std::size_t> ring = largest_cycle(graph, outer_walk(graph));
  UntangledRing result;
  for (const std::size_t p : ring) {
    result.vertices.push_back(graph.point(p));
  }
  if (result.vertices.empty() || find_conflict(result.vertices)) {
    return std::nullopt;
  }
  // No point of a segment is further than a pixel's diagonal from its chain.
  result.error_bound = sum_bound(length_bound(unit.x, unit.y), distance_left_out(graph, ring));
  return result;
}

}  // namespace gcv
