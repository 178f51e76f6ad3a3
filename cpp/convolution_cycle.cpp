// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convolution_cycle.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <utility>

#include "overlapping_pairs.hpp"

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
class ConvolutionCycle::Tracing {
 public:
  explicit Tracing(const Operands& operands)
      : operands_(operands),
        convex_is_a_(operands.a.is_convex),
        convex_(convex_is_a_ ? operands.a : operands.b),
        other_(convex_is_a_ ? operands.b : operands.a),
        convex_ranks_(convex_is_a_ ? operands.directions.rank_a : operands.directions.rank_b),
        other_ranks_(convex_is_a_ ? operands.directions.rank_b : operands.directions.rank_a) {}

  // False where there are too many links, or too long gaps.
  bool run() {
    const std::size_t vertices = std::size_t{convex_.size()} + other_.size();
    const std::size_t most = std::min(most_links, most_links_per_vertex * vertices);
    if (vertices > most) {
      return false;
    }
    links.reserve(vertices + vertices / 4);
    Rank in = other_ranks_.back();
    Index k = first_vertex(in);
    for (Index i = 0; i < other_.size(); ++i) {
      const Rank out = other_ranks_[i];
      if (other_.corners[i].convex) {
        const Rank cone = angle(in, out);
        for (; angle(in, convex_ranks_[k]) <= cone; k = convex_.next(k)) {
          add(corner_, convex_ranks_[k], i, k);
        }
      } else {
        const Index from = k;
        const Rank cone = angle(out, in);
        while (angle(out, convex_ranks_[convex_.previous(k)]) <= cone) {
          k = convex_.previous(k);
        }
        if (k != from) {
          add_gap(i, from, i, k);
        }
      }
      add(translated_, out, i, k);
      if (convex_ranks_[k] == out && !other_.corners[other_.next(i)].convex) {
        const Index from = std::exchange(k, convex_.next(k));
        add_gap(other_.next(i), from, i, k);
        add(translated_, out, i, k);
      }
      if (links.size() > most || (gaps_ > short_gaps_ && gaps_are_long())) {
        return false;
      }
      in = out;
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
  [[nodiscard]] Rank angle(Rank from, Rank to) const {
    return operands_.directions.angle(from, to);
  }

  // The vertex of the convex polygon with which the cycle comes to vertex 0 of the other one, which
  // is convex, along an edge of that rank: behind an edge with the same rank, or else, if the
  // vertex before is reflex, in front of it.
  [[nodiscard]] Index first_vertex(Rank in) const {
    Index k = 0;
    const auto before = [&] { return convex_ranks_[convex_.previous(k)]; };
    while (angle(before(), in) >= angle(before(), convex_ranks_[k])) {
      k = convex_.next(k);
    }
    return before() == in && !other_.corners.back().convex ? convex_.previous(k) : k;
  }

  [[nodiscard]] double extent() const {
    const Box box = operands_.relative_bounds();
    return length({box.x0, box.y0}, {box.x1, box.y1});
  }

  [[nodiscard]] Point start(std::size_t number) const {
    return operands_.relative_start(links[number].edge);
  }

  // The edge from the sum of vertex i of the other polygon and vertex k of the convex one.
  void add(EdgeName::Kind kind, Rank rank, Index i, Index k) {
    links.push_back({{{kind, convex_is_a_ ? k : i, convex_is_a_ ? i : k}, rank}, false});
  }

  // The gap from there to another sum. There is none before the first edge, nor behind the last:
  // once round, the convex polygon has turned once, too.
  void add_gap(Index i, Index k, Index end_i, Index end_k) {
    add(corner_, 0, i, k);
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
  bool convex_is_a_;
  EdgeName::Kind translated_ = convex_is_a_ ? EdgeName::corner : EdgeName::translated;
  EdgeName::Kind corner_ = convex_is_a_ ? EdgeName::translated : EdgeName::corner;
  const Polygon& convex_;
  const Polygon& other_;
  const Ranks& convex_ranks_;
  const Ranks& other_ranks_;
  double gaps_ = 0;  // the sum of their lengths
  // Gaps of that length are not too long: a whole cycle goes there and back through the bounds.
  double short_gaps_ = 2 * most_gaps / (1 + most_gaps) * extent();
  std::size_t measured_ = 0;
  double length_ = 0;  // of so many links
};

std::optional<ConvolutionCycle> ConvolutionCycle::find(const Operands& operands) {
  if (operands.a.is_convex == operands.b.is_convex) {
    return std::nullopt;
  }
  Tracing tracing(operands);
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
  return static_cast<Index>(link - links_.begin());
}

}  // namespace gcv
