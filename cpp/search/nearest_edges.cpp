// SPDX-License-Identifier: LGPL-3.0-or-later
#include "nearest_edges.hpp"

#include <cmath>
#include <limits>

#include "box.hpp"
#include "vector.hpp"

namespace gcv {

NearestEdges::NearestEdges(const Operands& operands, WitnessSearch& search)
    : operands_(operands),
      search_(search),
      a_(operands.a.cover_index().chords),
      b_(operands.b.cover_index().chords),
      scale_(scale_for_squares(extents_of(operands.relative_bounds()))) {}

void NearestEdges::find_edges_below() {
  if (below_a_.empty()) {
    const Directions& directions = operands_.directions;
    below_a_ = all_edges_below(a_, operands_.a, directions.rank_a, directions);
    below_b_ = all_edges_below(b_, operands_.b, directions.rank_b, directions);
  }
}

void NearestEdges::set_goal(const Goal& goal) {
  goal_ = goal;
  least_ = -infinity;
  if (!goal.is_point()) {
    goal_.vector = unit_vector(goal.vector);
    furthest_ = 0;
    furthest_ = -cost(operands_.relative_bounds());
  }
}

void NearestEdges::leave_out_before(double distance) { least_ = distance - 8 * search_.slack(); }

double NearestEdges::distance(const Point& p) const {
  return goal_.is_point() ? length_of(p.x - goal_.vector.x, p.y - goal_.vector.y) : cost(p);
}

double NearestEdges::cost(const Box& box) const {
  const auto& [x, y] = goal_.vector;
  if (!goal_.is_point()) {
    return cost(Point{x < 0 ? box.x0 : box.x1, y < 0 ? box.y0 : box.y1});
  }
  return cost(Point{std::min(std::max(x, box.x0), box.x1), std::min(std::max(y, box.y0), box.y1)});
}

double NearestEdges::limit_of_costs(double reach) const {
  if (!goal_.is_point()) {
    return reach + 8 * search_.slack();
  }
  const double most = scale_ * (reach + 4 * search_.slack());
  return (1 + 0x1p-48) * most * most + std::numeric_limits<double>::min();
}

void NearestEdges::push(const Entry& entry) {
  heap_.push_back(entry);
  if (std::isnan(entry.cost)) {
    heap_.back().cost = -infinity;  // numbers have overflowed
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
    const double least = cost(box);
    if (!(least > limit) && !is_left_out(box) && !operands_.is_out_of_focus(box) &&
        !search_.covers(box)) {
      push({least, Entry::nodes, p, q});
    }
  };
  const bool of_a = a_.extent(a) >= b_.extent(b);
  const std::uint32_t number = of_a ? a_.below(a) : b_.below(b);
  for_each_lane((of_a ? a_ : b_).blocks[number].lanes, [&](std::uint32_t lane) {
    const ChordTree::Node child = ChordTree::node(number, lane);
    of_a ? add(child, b) : add(a, child);
  });
}

NearestEdges::Nearest NearestEdges::nearest_on(const PairEdge& edge) const {
  const Point start = operands_.relative_start(edge);
  const auto [from, to] = operands_.source(edge);
  const RelativeLine line{start, to.x - from.x, to.y - from.y};
  const Point& goal = goal_.vector;
  if (!goal_.is_point()) {
    const double parameter = goal.x * line.dx + goal.y * line.dy > 0 ? 1 : 0;
    return {line, parameter, cost(line.at(parameter))};
  }
  const double x = scale_ * line.dx;
  const double y = scale_ * line.dy;
  const double foot =
      (x * (scale_ * (goal.x - start.x)) + y * (scale_ * (goal.y - start.y))) / (x * x + y * y);
  const double parameter = foot > 0 ? std::min(foot, 1.0) : 0;  // 0 if it is not a number
  return {line, parameter, cost(line.at(parameter))};
}

void NearestEdges::add_edge(const PairEdge& edge, double limit) {
  const double least = nearest_on(edge).cost;
  if (!(least > limit)) {
    push({least, edge.kind, edge.i, edge.j});
  }
}

// Goes both ways along the edge from its point that is nearest. Parameters seen from the other end
// are rounded so that none is left out.
void NearestEdges::look_at(const Entry& entry, double limit) {
  Entry edge = entry;
  edge.is_looked_at = true;
  if (search_.slack() < infinity) {
    const PairEdge named = operands_.named(entry.edge());
    const auto [line, parameter, least] = nearest_on(named);
    const RelativeLine back{operands_.relative_end(named), -line.dx, -line.dy};
    edge.cost = cost_of_uncovered(line, parameter, limit);
    if (edge.cost > least) {
      const double from = std::max(0.0, (1 - parameter) - 0x1p-50);
      edge.cost = std::min(edge.cost, cost_of_uncovered(back, from, limit));
    }
  }
  if (!(edge.cost > limit)) {
    push(edge);
  }
}

double NearestEdges::cost_of_uncovered(const RelativeLine& line, double from, double limit) {
  double until = 1;
  if (goal_.is_point()) {
    // What is further than the limit does not matter.
    const double length = scale_ * length_of(line.dx, line.dy);
    until = from + (1 + 0x1p-40) * std::sqrt(limit) / length;
  }
  search_.begin(line);
  const double reached = search_.reach(from, until < 1 ? until : 1);
  return reached < 1 ? cost(line.at(reached)) : infinity;
}

}  // namespace gcv
