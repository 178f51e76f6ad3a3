// SPDX-License-Identifier: LGPL-3.0-or-later
#include "witness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.hpp"

namespace gcv {

namespace {

double size_of(const Point& p) { return std::abs(p.x) + std::abs(p.y); }

// The least progress along a line that a witness is taken for.
constexpr double least_progress = 0x1p-20;

}  // namespace

// Error bound, with uE as the unit, u times the extents of both polygons. Coordinates of the corner
// are off by 3, those of u and v by 3, and those of the point by 6, so that w is off by 10. If the
// computed inequalities hold, w is at most 1.1 (|u| + |v|) long. So w x v and u x w are off by less
// than 21 (|u| + |v|), the roundings of their own products included; the product of the radius and
// the length by 30 (|v|), for chords are off by 24. The slack is 64.
Witness::Witness(const ChordNode& p, const ChordNode& q, double slack)
    : corner_{p.from.x + q.from.x, p.from.y + q.from.y},
      u_{p.to.x - p.from.x, p.to.y - p.from.y},
      v_{q.to.x - q.from.x, q.to.y - q.from.y} {
  double radius_u = p.radius;
  double radius_v = q.radius;
  double length_u = p.length;
  double length_v = q.length;
  double cross = u_.x * v_.y - u_.y * v_.x;
  if (cross < 0) {
    std::swap(u_, v_);
    std::swap(radius_u, radius_v);
    std::swap(length_u, length_v);
    cross = -cross;
  }
  const double tolerance =
      (size_of(u_) + size_of(v_)) * slack + std::numeric_limits<double>::min();
  least_u_ = radius_v * length_v + tolerance;
  least_v_ = radius_u * length_u + tolerance;
  most_u_ = cross - least_u_;
  most_v_ = cross - least_v_;
}

double Witness::reach(const RelativeLine& line, double t) const {
  const Point x = line.at(t);
  const double wx = x.x - corner_.x;
  const double wy = x.y - corner_.y;
  double length = 1 - t;
  const auto limit = [&](double value, double slope, double least, double most) {
    if (slope > 0) {
      length = std::min(length, (most - value) / slope);
    } else if (slope < 0) {
      length = std::min(length, (least - value) / slope);
    }
  };
  limit(wx * v_.y - wy * v_.x, line.dx * v_.y - line.dy * v_.x, least_u_, most_u_);
  limit(u_.x * wy - u_.y * wx, u_.x * line.dy - u_.y * line.dx, least_v_, most_v_);
  // What is held is convex. So only its end needs to be looked at.
  for (const double share : {1.0, 1 - 0x1p-20, 0.75}) {
    const double end = t + share * length;
    if (end > t && end <= 1 && holds(line.at(end))) {
      return end;
    }
  }
  return t;
}

WitnessSearch::WitnessSearch(const Operands& operands)
    : operands_(operands),
      trees_{&operands.a.index().tree, &operands.b.index().tree},
      chords_{&operands.a.chords(), &operands.b.chords()},
      slack_(slack_of(operands)),
      roots_{root(operands.a), root(operands.b)},
      bounds_(operands.relative_bounds()) {
  const double extents = 0x1p48 * slack_;
  if (!(extents * extents <= std::numeric_limits<double>::max())) {
    slack_ = std::numeric_limits<double>::infinity();  // nothing is certain in doubles
  }
  const double pairs = static_cast<double>(operands.a.size()) * operands.b.size();
  side_ = static_cast<std::uint32_t>(std::min(std::max(std::sqrt(pairs) / 8, 2.0), 128.0));
  cells_a_unit_x_ = side_ / (bounds_.x1 - bounds_.x0);
  cells_a_unit_y_ = side_ / (bounds_.y1 - bounds_.y0);
  cells_.resize(std::size_t{side_} * side_);
}

ChordNode WitnessSearch::root(const Boundary& polygon) {
  const Box& box = polygon.index().tree.box;
  return {{0, 0}, box, {box.x0, box.y0}, {box.x0, box.y0},
          std::numeric_limits<double>::infinity(), 0};
}

WitnessSearch::Family WitnessSearch::family(const Nodes& nodes) const {
  const auto extent = [](const Box& box) { return (box.x1 - box.x0) + (box.y1 - box.y0); };
  const bool a_is_edge = trees_[0]->is_edge(nodes.a.place);
  const bool b_is_edge = trees_[1]->is_edge(nodes.b.place);
  const bool of_a = b_is_edge || (!a_is_edge && extent(nodes.a.box) >= extent(nodes.b.box));
  const ChainTree& tree = *trees_[of_a ? 0 : 1];
  const ChordNode& parent = of_a ? nodes.a : nodes.b;
  const std::uint32_t number = tree.block_below(parent.place);
  return {tree, tree.blocks[number], (*chords_[of_a ? 0 : 1])[number], parent,
          of_a ? nodes.b : nodes.a, of_a};
}

WitnessSearch::Nodes WitnessSearch::Family::nodes(std::uint32_t lane) const {
  const ChordNode child{ChainTree::child(parent.place, lane), boxes.box(lane),
                        {chords.x0[lane], chords.y0[lane]}, {chords.x1[lane], chords.y1[lane]},
                        chords.radius[lane], chords.length[lane]};
  return is_of_a ? Nodes{child, other} : Nodes{other, child};
}

// The sum of two chains is within both radii of the parallelogram of the chords. Error bounds as for
// a witness. A point in the sum of the boxes is at most |u| + |v| + 4 radii from the corner.
WitnessSearch::Lanes WitnessSearch::lanes_at(const Family& family, const Point& x,
                                             double distance) const {
  const ChordNode& other = family.other;
  const ChordBlock& chords = family.chords;
  const DoubleMask apart = family.boxes.apart({x.x - distance - slack_ - other.box.x1,
                                               x.y - distance - slack_ - other.box.y1,
                                               x.x + distance + slack_ - other.box.x0,
                                               x.y + distance + slack_ - other.box.y0});
  const Point v{other.to.x - other.from.x, other.to.y - other.from.y};
  const SimdDouble x0 = SimdDouble::load(chords.x0);
  const SimdDouble y0 = SimdDouble::load(chords.y0);
  const SimdDouble ux = SimdDouble::load(chords.x1) - x0;
  const SimdDouble uy = SimdDouble::load(chords.y1) - y0;
  const SimdDouble length = SimdDouble::load(chords.length);
  const SimdDouble radius = SimdDouble::load(chords.radius);
  const SimdDouble wx = (x.x - other.from.x) - x0;
  const SimdDouble wy = (x.y - other.from.y) - y0;
  const SimdDouble along_u = v.y * wx - v.x * wy;
  const SimdDouble along_v = ux * wy - uy * wx;
  const SimdDouble cross = v.y * ux - v.x * uy;
  const SimdDouble lowest = smaller(cross, SimdDouble::of(0));
  const SimdDouble highest = larger(cross, SimdDouble::of(0));
  const SimdDouble size = magnitude(ux) + magnitude(uy) + (std::abs(v.x) + std::abs(v.y));
  const SimdDouble tolerance = slack_ * size + std::numeric_limits<double>::min();
  const SimdDouble least_u = tolerance + other.radius * other.length;
  const SimdDouble least_v = radius * length + tolerance;
  const DoubleMask uncovered = (along_u < lowest + least_u) | (along_u > highest - least_u) |
                               (along_v < lowest + least_v) | (along_v > highest - least_v);
  const SimdDouble radii = radius + (other.radius + distance);
  const SimdDouble room = slack_ * (size + 4 * radii) + std::numeric_limits<double>::min();
  const SimdDouble room_u = other.length * radii + room;
  const SimdDouble room_v = length * radii + room;
  const DoubleMask beside = (along_u < lowest - room_u) | (along_u > highest + room_u) |
                            (along_v < lowest - room_v) | (along_v > highest + room_v);
  const unsigned near = ~(apart | beside).bits() & SimdDouble::all;
  // Comparisons with what is not a number are false: the witness itself is asked once more.
  return {near, near & ~uncovered.bits()};
}

WitnessSearch::Cell& WitnessSearch::cell_of(const Point& x) {
  const auto number = [&](double offset, double cells_a_unit) {
    const double cell = offset * cells_a_unit;
    return cell > 0 ? static_cast<std::size_t>(std::min(cell, side_ - 1.0)) : std::size_t{0};
  };
  return cells_[side_ * number(x.y - bounds_.y0, cells_a_unit_y_) +
                number(x.x - bounds_.x0, cells_a_unit_x_)];
}

double WitnessSearch::remembered_reach(const Cell& cell, const RelativeLine& line, double t,
                                       double least) {
  const Point x = line.at(t);
  for (const std::optional<Witness>& witness : cell.witnesses) {
    if (witness && witness->holds(x)) {
      const double end = witness->reach(line, t);
      if (end >= least) {
        last_ = witness;
        return end;
      }
    }
  }
  return t;
}

double WitnessSearch::searched_reach(Cell& cell, const RelativeLine& line, double t,
                                     double least) {
  const Point x = line.at(t);
  queue_.clear();
  pairs_.clear();
  queue_.push_back(roots_);
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const Nodes parents = queue_[k];
    const Family children = family(parents);
    const Lanes lanes = lanes_at(children, x, 0);
    double end = t;
    for_each_lane(lanes.covering, [&](std::uint32_t lane) {
      const Nodes nodes = children.nodes(lane);
      const Witness witness(nodes.a, nodes.b, slack_);
      if (end < least && witness.holds(x)) {
        const double reach = witness.reach(line, t);
        if (reach >= least) {
          end = reach;
          last_ = witness;
          cell.witnesses[cell.next] = witness;
          cell.next = (cell.next + 1) % Cell::capacity;
        }
      }
    });
    if (end > t) {
      return end;
    }
    add_children(children, lanes.near);
  }
  return t;
}

void WitnessSearch::add_children(const Family& children, unsigned lanes) {
  for_each_lane(lanes, [&](std::uint32_t lane) {
    const Nodes nodes = children.nodes(lane);
    if (nodes.a.box.x0 > nodes.a.box.x1 || nodes.b.box.x0 > nodes.b.box.x1) {
      return;  // missing, seen where numbers have overflowed
    }
    if (are_edges(nodes)) {
      pairs_.push_back({nodes.a.place.index, nodes.b.place.index});
    } else {
      queue_.push_back(nodes);
    }
  });
}

double WitnessSearch::reach(const RelativeLine& line, double t) {
  const Point x = line.at(t);
  const double least = std::min(1.0, t + least_progress);
  if (last_ && last_->holds(x)) {
    const double end = last_->reach(line, t);
    if (end >= least) {
      return end;
    }
  }
  Cell& cell = cell_of(x);
  const double end = remembered_reach(cell, line, t, least);
  return end > t ? end : searched_reach(cell, line, t, least);
}

void WitnessSearch::find_pairs(const Point& x, double distance) {
  find_pairs_by([&](const Family& children) { return lanes_at(children, x, distance).near; });
}

void WitnessSearch::find_pairs(const Box& box) {
  const Box wide = widened(box, slack_);
  find_pairs_by([&](const Family& children) {
    const Box& other = children.other.box;
    return ~children.boxes
                .apart({wide.x0 - other.x1, wide.y0 - other.y1, wide.x1 - other.x0,
                        wide.y1 - other.y0})
                .bits() &
           SimdDouble::all;
  });
}

template <class NearLanes>
void WitnessSearch::find_pairs_by(NearLanes near_lanes) {
  queue_.clear();
  pairs_.clear();
  queue_.push_back(roots_);
  while (!queue_.empty()) {
    const Nodes parents = queue_.back();
    queue_.pop_back();
    const Family children = family(parents);
    add_children(children, near_lanes(children));
  }
}

}  // namespace gcv
