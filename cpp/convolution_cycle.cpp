// SPDX-License-Identifier: LGPL-3.0-or-later
#include "convolution_cycle.hpp"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cstddef>
#include <utility>

#include "overlapping_pairs.hpp"

namespace gcv {

namespace {

// Beyond these, a search for each step takes less.
constexpr std::size_t most_links = 16384;
constexpr std::size_t most_links_per_vertex = 4;
constexpr std::size_t most_pairs_per_link = 8;
constexpr std::uint8_t most_near = 64;

}  // namespace

// The edges one after the other. At a convex vertex of the other polygon follow those edges of the
// convex one whose directions lie in its cone; at a reflex vertex, the convex one turns back. To an
// edge of the other polygon that is parallel to one of the convex one, both of its vertices
// contribute.
class ConvolutionCycle::Tracing {
 public:
  explicit Tracing(const Operands& operands)
      : operands_(operands),
        convex_is_a_(operands.a.is_convex),
        convex_(convex_is_a_ ? operands.a : operands.b),
        other_(convex_is_a_ ? operands.b : operands.a),
        convex_ranks_(convex_is_a_ ? operands.directions.rank_a : operands.directions.rank_b),
        other_ranks_(convex_is_a_ ? operands.directions.rank_b : operands.directions.rank_a) {}

  // False where there are too many.
  bool run() {
    const std::size_t vertices = std::size_t{convex_.size()} + other_.size();
    const std::size_t most = std::min(most_links, most_links_per_vertex * vertices);
    links.reserve(vertices + vertices / 4);
    starts.reserve(vertices + vertices / 4);
    Rank in = other_ranks_.back();
    Index k = first_vertex(in);
    for (Index i = 0; i < other_.size(); ++i) {
      const Rank out = other_ranks_[i];
      if (other_.corners[i].convex) {
        for (; angle(in, convex_ranks_[k]) <= angle(in, out); k = convex_.next(k)) {
          add_corner(i, k);
        }
      } else {
        while (angle(out, convex_ranks_[convex_.previous(k)]) <= angle(out, in)) {
          k = convex_.previous(k);
        }
      }
      add_translated(i, k);
      if (convex_ranks_[k] == out && !other_.corners[other_.next(i)].convex) {
        k = convex_.next(k);
        add_translated(i, k);
      }
      if (links.size() > most) {
        return false;
      }
      in = out;
    }
    go_to(first_);
    return true;
  }

  std::vector<Link> links;
  std::vector<Point> starts;  // of each link, in relative coordinates

 private:
  // Vertex i of the other polygon and vertex k of the convex one.
  struct Sum {
    Index i;
    Index k;
    friend bool operator==(const Sum&, const Sum&) = default;
  };

  [[nodiscard]] Rank angle(Rank from, Rank to) const {
    return operands_.directions.angle(from, to);
  }

  // Where the cycle is when it comes to vertex 0, which is convex, along an edge of that rank: at
  // the end of an edge of the convex polygon with the same rank, if the vertex before is convex.
  [[nodiscard]] Index first_vertex(Rank in) const {
    Index k = 0;
    const auto before = [&] { return convex_ranks_[convex_.previous(k)]; };
    while (angle(before(), in) >= angle(before(), convex_ranks_[k])) {
      k = convex_.next(k);
    }
    return before() == in && !other_.corners.back().convex ? convex_.previous(k) : k;
  }

  void add_translated(Index i, Index k) {
    add(translated_, other_ranks_[i], {i, k}, {other_.next(i), k});
  }
  void add_corner(Index i, Index k) {
    add(corner_, convex_ranks_[k], {i, k}, {i, convex_.next(k)});
  }

  // Behind a gap, where there is one.
  void add(EdgeName::Kind kind, Rank rank, const Sum& start, const Sum& end) {
    if (links.empty()) {
      first_ = start;
    } else {
      go_to(start);
    }
    link(kind, rank, start, false);
    end_ = end;
  }
  void go_to(const Sum& start) {
    if (!(start == end_)) {
      link(corner_, 0, end_, true);
    }
  }
  void link(EdgeName::Kind kind, Rank rank, const Sum& start, bool is_gap) {
    const Index i = convex_is_a_ ? start.k : start.i;
    const Index j = convex_is_a_ ? start.i : start.k;
    links.push_back({{{kind, i, j}, rank}, is_gap});
    starts.push_back(operands_.relative(i, j));
  }

  const Operands& operands_;
  bool convex_is_a_;
  EdgeName::Kind translated_ = convex_is_a_ ? EdgeName::corner : EdgeName::translated;
  EdgeName::Kind corner_ = convex_is_a_ ? EdgeName::translated : EdgeName::corner;
  const Polygon& convex_;
  const Polygon& other_;
  const Ranks& convex_ranks_;
  const Ranks& other_ranks_;
  Sum first_{};
  Sum end_{};
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
  cycle.links_ = std::move(tracing.links);
  if (!cycle.find_near(tracing.starts)) {
    return std::nullopt;
  }
  return cycle;
}

bool ConvolutionCycle::find_near(std::span<const Point> starts) {
  struct Pair {
    Index first;
    Index second;
  };
  boost::container::small_vector<Pair, 32> pairs;
  const auto size = static_cast<Index>(links_.size());
  const auto visit = [&](std::size_t p, std::size_t q) {
    const auto first = static_cast<Index>(p);
    const auto second = static_cast<Index>(q);
    const bool are_neighbours = first + 1 == second || (first == 0 && second + 1 == size);
    if (are_neighbours || links_[p].is_gap || links_[q].is_gap) {
      return true;
    }
    pairs.push_back({first, second});
    return ++links_[p].near_count <= most_near && ++links_[q].near_count <= most_near;
  };
  if (!OverlappingPairs(starts, OverlappingPairs::Points::rounded)
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
