// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convolution_cycle.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "error.hpp"
#include "overlapping_pairs.hpp"
#include "predicates.hpp"

namespace gcv {

namespace {

// Beyond these, a search for each step takes less. Long gaps tell early that much of the cycle lies
// deep inside the sum, where all is near all.
constexpr std::size_t most_links = 16384;
constexpr std::size_t most_links_per_vertex = 4;
constexpr double most_gaps = 0.75;     // of the length of all edges
constexpr std::size_t few_links = 64;  // whose lengths tell little
constexpr std::size_t most_pairs_per_link = 8;
constexpr std::uint8_t most_near = 64;

}  // namespace

// The edges one after the other. At a convex vertex of the other polygon follow those edges of the
// convex one whose directions lie in its cone; at a reflex vertex, the convex one turns back.
//
// Where an edge of the other polygon has the direction of one of the convex one, the superset has
// two ways along the same line: first the one and then the other, or the other way round. If the
// former starts or ends in a convex vertex, both are whole and coincide, and one is taken. Else
// there are two translated edges, one from each end of the other's.
//
// Edge k of the convex polygon is the next one that a turn to the left passes: the direction of the
// other's last edge is that of the edge before k, or lies between both, or else is that of k. So
// all directions that are compared are less than half a turn apart.
class ConvolutionCycle::Tracing {
 public:
  Tracing(const Operands& operands, Tally& tally)
      : operands_(operands),
        tally_(tally),
        convex_is_a_(operands.a.is_convex),
        convex_(convex_is_a_ ? operands.a : operands.b),
        other_(convex_is_a_ ? operands.b : operands.a) {}

  // False where there are too many links, or too long gaps.
  bool run() {
    const std::size_t vertices = std::size_t{convex_.size()} + other_.size();
    const std::size_t most = std::min(most_links, most_links_per_vertex * vertices);
    if (vertices > most) {
      return false;
    }
    links.reserve(vertices + vertices / 4);
    find_first();
    for (Index i = 0; i < other_.size(); ++i) {
      if (other_.corners[i].convex) {
        turn_left(i);
      } else {
        turn_back(i);
      }
      if (links.size() > most || (gaps_ > short_gaps_ && gaps_are_long())) {
        return false;
      }
    }
    return true;
  }

  // The starts of all links in relative coordinates.
  [[nodiscard]] PointVector starts() const {
    PointVector starts(links.size());
    for (std::size_t number = 0; number < links.size(); ++number) {
      starts[number] = start(number);
    }
    return starts;
  }

  std::vector<Link> links;

 private:
  // The sign of the turn from edge k of the convex polygon to edge i of the other one.
  int turn_to(Index k, Index i) {
    return turn(convex_.vertices[k], convex_.vertices[convex_.next(k)], other_.vertices[i],
                other_.vertices[other_.next(i)], tally_);
  }

  // The cycle comes to vertex 0 of the other polygon, which is convex, along its last edge: behind
  // an edge of the same direction, or else, if the vertex before is reflex, in front of it.
  void find_first() {
    const Index last = other_.size() - 1;
    int from_before = turn_to(convex_.size() - 1, last);
    int from_k = turn_to(0, last);
    while (!(from_before >= 0 && from_k < 0)) {
      k_ = convex_.next(k_);
      from_before = std::exchange(from_k, turn_to(k_, last));
    }
    if (from_before == 0 && !other_.corners[last].convex) {
      k_ = convex_.previous(k_);
      is_along_k_ = true;
    }
  }

  // Along the edges of the convex polygon in the cone of convex vertex i, and edge i.
  void turn_left(Index i) {
    bool is_straight = std::exchange(is_along_k_, false);
    for (int order = turn_to(k_, i); order >= 0; order = turn_to(k_, i)) {
      add(corner_, i, k_, is_straight);
      is_straight = order == 0;
      k_ = convex_.next(k_);
    }
    add(translated_, i, k_, is_straight);
  }

  // Back over the edges in the turn at reflex vertex i, and along edge i: both ways round, where it
  // has the direction of one of those and no convex vertex is next.
  void turn_back(Index i) {
    const Index from = k_;
    is_along_k_ = false;
    for (Index before = convex_.previous(k_);; before = convex_.previous(k_)) {
      const int order = turn_to(before, i);
      if (order > 0) {
        break;
      }
      k_ = before;
      is_along_k_ = order == 0;
    }
    if (k_ != from) {
      add_gap(i, from, i, k_);
    }
    add(translated_, i, k_, false);
    if (is_along_k_ && !other_.corners[other_.next(i)].convex) {
      const Index passed = std::exchange(k_, convex_.next(k_));
      is_along_k_ = false;
      add_gap(other_.next(i), passed, i, k_);
      add(translated_, i, k_, false);
    }
  }

  [[nodiscard]] double extent() const {
    const Box box = operands_.relative_bounds();
    return length({box.x0, box.y0}, {box.x1, box.y1});
  }

  [[nodiscard]] Point start(std::size_t number) const {
    return operands_.relative_start(links[number].edge);
  }

  // The edge from the sum of vertex i of the other polygon and vertex k of the convex one.
  void add(EdgeName::Kind kind, Index i, Index k, bool is_straight) {
    links.push_back({{kind, convex_is_a_ ? k : i, convex_is_a_ ? i : k}, false, is_straight});
  }

  // The gap from there to another sum. There is none before the first edge, nor behind the last:
  // once round, the convex polygon has turned once, too.
  void add_gap(Index i, Index k, Index end_i, Index end_k) {
    add(corner_, i, k, false);
    links.back().is_gap = true;
    const Point end =
        convex_is_a_ ? operands_.relative(end_k, end_i) : operands_.relative(end_i, end_k);
    gaps_ += length(start(links.size() - 1), end);
  }

  // The larger one along an axis.
  static double length(const Point& p, const Point& q) {
    return std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
  }

  bool gaps_are_long() {
    for (; measured_ + 1 < links.size(); ++measured_) {
      length_ += length(start(measured_), start(measured_ + 1));
    }
    return measured_ > few_links && gaps_ > most_gaps * (length_ - gaps_);
  }

  const Operands& operands_;
  Tally& tally_;
  bool convex_is_a_;
  EdgeName::Kind translated_ = convex_is_a_ ? EdgeName::corner : EdgeName::translated;
  EdgeName::Kind corner_ = convex_is_a_ ? EdgeName::translated : EdgeName::corner;
  const Boundary& convex_;
  const Boundary& other_;
  Index k_ = 0;
  bool is_along_k_ = false;  // the other's last edge has the direction of edge k
  double gaps_ = 0;          // the sum of their lengths
  // Gaps of that length are not too long: a whole cycle goes there and back through the bounds.
  double short_gaps_ = 2 * most_gaps / (1 + most_gaps) * extent();
  std::size_t measured_ = 0;
  double length_ = 0;  // of so many links
};

std::optional<ConvolutionCycle> ConvolutionCycle::find(const Operands& operands, Tally& tally) {
  if (operands.a.is_convex == operands.b.is_convex) {
    return std::nullopt;
  }
  Tracing tracing(operands, tally);
  if (!tracing.run()) {
    return std::nullopt;
  }
  ConvolutionCycle cycle;
  const PointVector starts = tracing.starts();
  cycle.links_ = std::move(tracing.links);
  if (!cycle.find_near(starts, operands.relative_bounds())) {
    return std::nullopt;
  }
  return cycle;
}

bool ConvolutionCycle::find_near(std::span<const Point> starts, const Box& bounds) {
  struct Pair {
    Index first;
    Index second;
  };
  boost::container::small_vector<Pair, 32> pairs;
  const auto visit = [&](std::size_t p, std::size_t q) {
    const auto first = static_cast<Index>(p);
    const auto second = static_cast<Index>(q);
    const bool are_neighbours = first + 1 == second || (first == 0 && second + 1 == size());
    if (are_neighbours || is_gap(first) || is_gap(second)) {
      return true;
    }
    pairs.push_back({first, second});
    return ++links_[p].near_count <= most_near && ++links_[q].near_count <= most_near;
  };
  if (!OverlappingPairs(starts, bounds, OverlappingPairs::Points::rounded)
           .visit_some(most_pairs_per_link * links_.size(), visit)) {
    return false;
  }
  Index end = 0;
  for (Link& link : links_) {
    link.first_near = end += link.near_count;
  }
  near_.resize(end);
  for (const Pair& pair : pairs) {
    near_[--links_[pair.first].first_near] = pair.second;
    near_[--links_[pair.second].first_near] = pair.first;
  }
  return true;
}

Index ConvolutionCycle::first_from(Index i, Index j) const {
  const auto link = std::find_if(links_.begin(), links_.end(), [&](const Link& l) {
    return !l.is_gap && l.edge.i == i && l.edge.j == j;
  });
  if (link == links_.end()) {
    throw Error(Status::internal,
                "no edge of the convolution cycle starts in a vertex of the hull");
  }
  return static_cast<Index>(link - links_.begin());
}

}  // namespace gcv
