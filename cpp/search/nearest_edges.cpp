// SPDX-License-Identifier: LGPL-3.0-or-later
#include "nearest_edges.hpp"

#include <cmath>
#include <limits>

#include "box.hpp"

namespace gcv {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double scale_for(const Box& box) {
  const double size = (box.x1 - box.x0) + (box.y1 - box.y0);
  return size > 0x1p400 ? 0x1p-600 : size < 0x1p-400 ? 0x1p600 : 1;
}

}  // namespace

NearestEdges::NearestEdges(const Operands& operands, WitnessSearch& search)
    : operands_(operands),
      search_(search),
      a_(operands.a.cover_index().chords),
      b_(operands.b.cover_index().chords),
      below_a_(all_edges_below(a_, operands.a, operands.directions.rank_a, operands.directions)),
      below_b_(all_edges_below(b_, operands.b, operands.directions.rank_b, operands.directions)),
      scale_(scale_for(operands.relative_bounds())) {}

double NearestEdges::square_of_distance(const Box& box) const {
  const double x = scale_ * std::max({0.0, box.x0 - from_.x, from_.x - box.x1});
  const double y = scale_ * std::max({0.0, box.y0 - from_.y, from_.y - box.y1});
  return x * x + y * y;
}

double NearestEdges::limit_of_squares(double reach) const {
  const double most = scale_ * (reach + 4 * search_.slack());
  return (1 + 0x1p-48) * most * most + std::numeric_limits<double>::min();
}

void NearestEdges::push(const Entry& entry) {
  heap_.push_back(entry);
  if (!(entry.square >= 0)) {
    heap_.back().square = 0;  // numbers have overflowed
  }
  std::push_heap(heap_.begin(), heap_.end(), is_further);
}

void NearestEdges::look_below(ChordTree::Node a, ChordTree::Node b, double limit) {
  const bool a_is_edge = a_.is_edge(a);
  const bool b_is_edge = b_.is_edge(b);
  if (a_is_edge && b_is_edge) {
    const Index i = a_.below(a);
    const Index j = b_.below(b);
    const PairEdge translated = operands_.translated(i, j);
    const PairEdge corner = operands_.corner(i, j);
    if (operands_.b_contributes(j, translated.rank)) {
      add_edge(translated, limit);
    }
    if (operands_.a_contributes(i, corner.rank)) {
      add_edge(corner, limit);
    }
    return;
  }
  const auto add = [&](ChordTree::Node p, ChordTree::Node q) {
    if (!have_superset_edges(below_a_[p], below_b_[q], ~Sectors{0})) {
      return;
    }
    const Box box = sum_of(a_.box(p), b_.box(q));
    const double square = square_of_distance(box);
    if (!(square > limit) && !search_.covers(box)) {
      push({square, Entry::nodes, p, q});
    }
  };
  const bool of_a = a_.extent(a) >= b_.extent(b);
  const std::uint32_t number = of_a ? a_.below(a) : b_.below(b);
  for_each_lane((of_a ? a_ : b_).blocks[number].lanes, [&](std::uint32_t lane) {
    const ChordTree::Node child = ChordTree::node(number, lane);
    of_a ? add(child, b) : add(a, child);
  });
}

void NearestEdges::add_edge(const PairEdge& edge, double limit) {
  const double square = square_of_uncovered(edge, limit);
  if (!(square > limit)) {
    push({square, edge.kind, edge.i, edge.j});
  }
}

// Goes both ways along the edge from its point that is nearest. Parameters seen from the other end
// are rounded so that none is left out.
double NearestEdges::square_of_uncovered(const PairEdge& edge, double limit) {
  if (!(search_.slack() < infinity)) {
    return 0;
  }
  const Point start = operands_.relative_start(edge);
  const Point end = operands_.relative_end(edge);
  const auto [from, to] = operands_.source(edge);
  const RelativeLine forwards{start, to.x - from.x, to.y - from.y};
  const RelativeLine backwards{end, from.x - to.x, from.y - to.y};
  const double x = scale_ * forwards.dx;
  const double y = scale_ * forwards.dy;
  const double foot =
      (x * (scale_ * (from_.x - start.x)) + y * (scale_ * (from_.y - start.y))) / (x * x + y * y);
  const double nearest = foot > 0 ? std::min(foot, 1.0) : 0;  // 0 if it is not a number
  if (square_of_distance(forwards.at(nearest)) > limit) {
    return infinity;
  }
  double square = infinity;
  search_.begin(forwards);
  if (const double reached = search_.reach(nearest); reached < 1) {
    square = square_of_distance(forwards.at(reached));
    if (reached == nearest) {
      return square;
    }
  }
  search_.begin(backwards);
  const double back = std::max(0.0, (1 - nearest) - 0x1p-50);
  if (const double reached = search_.reach(back); reached < 1) {
    square = std::min(square, square_of_distance(backwards.at(reached)));
  }
  return square;
}

}  // namespace gcv
