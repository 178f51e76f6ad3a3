// SPDX-License-Identifier: LGPL-3.0-or-later
#include "snap_rounding.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include "box.hpp"
#include "cycle.hpp"
#include "exact_numbers.hpp"
#include "overlapping_pairs.hpp"
#include "plane_graph.hpp"
#include "predicates.hpp"
#include "simplicity.hpp"
#include "to_double.hpp"
#include "units.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

SumEdge as_edge(const Segment& s) {
  return {{s.low, {0, 0}}, s.low, s.high, s.high.x - s.low.x, s.high.y - s.low.y};
}

// Snap rounding: the plane is divided into pixels. A pixel that holds an end or a crossing of
// segments is hot. Each segment becomes the chain of the centres of the hot pixels that it passes.
// Then segments meet in such centres only. Source: Guibas and Marimont, "Rounding arrangements
// dynamically", 1998.
class SnapRounding {
 public:
  // Do all sides of a pixel belong to it, or the left and the lower one alone? Chains of segments
  // that cross in a corner of closed pixels can cross between their centres.
  enum class Pixels : std::uint8_t { closed, half_open };

  SnapRounding(const std::vector<Segment>& segments, const Point& unit, Pixels pixels, Tally& tally)
      : segments_(segments),
        unit_(unit),
        pixels_(pixels),
        chains_(segments.size()),
        tally_(tally) {}

  // The edges of the chains, each once.
  std::vector<Segment> run() {
    find_hot_pixels();
    find_passages();
    std::vector<Segment> edges;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      sort_along(segments_[i], chains_[i]);
      for (std::size_t k = 1; k < chains_[i].size(); ++k) {
        edges.push_back(segment(chains_[i][k - 1], chains_[i][k]));
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
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
      quotient -= 1;  // division truncates, but this must round down
    }
    return static_cast<double>(quotient) * unit;
  }

  [[nodiscard]] int largest_shift(const Grid& grid) const {
    return std::max(std::abs(grid.exponent() - std::ilogb(unit_.x)),
                    std::abs(grid.exponent() - std::ilogb(unit_.y)));
  }

  // The centre of the pixel that holds the coordinate x. The unit is a power of two. If the
  // quotient is not exact, it underflows, and the pixel is that of 0. Adding 0 turns -0 into 0.
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

  // A hot pixel: its centre, and the first segment that makes it hot.
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

  // Do the segments cross? Touching ends do not count, because the pixels of ends are hot anyway.
  [[nodiscard]] bool cross(const Segment& s, const Segment& t) {
    const bool share_an_end =
        s.low == t.low || s.low == t.high || s.high == t.low || s.high == t.high;
    return !share_an_end &&
           orientation(s.low, s.high, t.low, tally_) * orientation(s.low, s.high, t.high, tally_) <
               0 &&
           orientation(t.low, t.high, s.low, tally_) * orientation(t.low, t.high, s.high, tally_) <
               0;
  }

  // Finds the hot pixels that each segment passes. Segments and pixels are in one tree, each pixel
  // next to its segment. Pairs of a segment and a pixel whose boxes overlap are tested.
  void find_passages() {
    struct Item {
      std::size_t segment;
      const Point* pixel;  // null for the segment itself
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

  // Does the segment meet the pixel around h? It meets a half-open one where, moved to the right by
  // next to nothing and upwards by much less, it meets what is strictly inside. The corners of the
  // pixel are sums of two doubles.
  [[nodiscard]] bool passes(const Segment& s, const Point& h) {
    if (s.low == h || s.high == h) {
      return true;
    }
    const Point half{unit_.x / 2, unit_.y / 2};
    const Box box = box_of(s.low, s.high);
    const int beyond = pixels_ == Pixels::closed ? 1 : 0;
    if (compare_sums(box.x0, 0, h.x, half.x, tally_) >= beyond ||
        compare_sums(box.x1, 0, h.x, -half.x, tally_) < 0 ||
        compare_sums(box.y0, 0, h.y, half.y, tally_) >= beyond ||
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
    if (pixels_ == Pixels::closed) {
      return lowest <= 0 && highest >= 0;
    }
    // Corners on the line are on this side of the line that was moved.
    const int moved = line.dy != 0 ? (line.dy > 0 ? 1 : -1) : (line.dx > 0 ? -1 : 1);
    return (lowest < 0 || (lowest == 0 && moved < 0)) &&
           (highest > 0 || (highest == 0 && moved > 0));
  }

  // Sorts pixels along the longer axis of the segment. Pixels with equal coordinates there are
  // sorted along the other axis.
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
  Pixels pixels_;
  std::vector<HotPixel> hot_;
  std::vector<PointVector> chains_;
  Tally& tally_;
};

std::optional<SnapRoundedRing> snap_round(const std::vector<Segment>& segments, const Point& unit,
                                          SnapRounding::Pixels pixels, Tally& tally) {
  const std::vector<Segment> edges = SnapRounding(segments, unit, pixels, tally).run();
  if (edges.empty()) {
    return std::nullopt;
  }
  const PlaneGraph graph(edges, tally);
  const std::vector<std::size_t> ring = largest_cycle(graph, outer_walk(graph), unit);
  SnapRoundedRing result;
  for (const std::size_t p : ring) {
    result.vertices.push_back(graph.point(p));
  }
  if (result.vertices.empty() || find_conflict(result.vertices)) {
    return std::nullopt;
  }
  assert(is_counter_clockwise(result.vertices));
  // No point of a segment is further than a pixel's diagonal from its chain.
  result.error_bound = sum_bound(length_bound(unit.x, unit.y), distance_left_out(graph, ring));
  return result;
}

}  // namespace

std::optional<SnapRoundedRing> snap_round(const PointVector& polyline, Tally& tally) {
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < polyline.size(); ++k) {
    segments.push_back(segment(polyline[k], polyline[cyclic_next(k, polyline.size())]));
  }
  if (segments.size() < 3) {
    return std::nullopt;
  }
  const double smallest = 2 * std::numeric_limits<double>::denorm_min();  // can be halved
  Point unit = units_in_last_place(polyline);
  unit = {std::max(unit.x, smallest), std::max(unit.y, smallest)};
  using Pixels = SnapRounding::Pixels;
  std::optional<SnapRoundedRing> ring = snap_round(segments, unit, Pixels::closed, tally);
  // A walk along chains that cross may leave out nearly all of the ring.
  constexpr double few = 8;
  if (ring && ring->error_bound <= few * length_bound(unit.x, unit.y)) {
    return ring;
  }
  std::optional<SnapRoundedRing> other = snap_round(segments, unit, Pixels::half_open, tally);
  return ring && !(other && other->error_bound < ring->error_bound) ? ring : other;
}

}  // namespace gcv
