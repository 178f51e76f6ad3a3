// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Witnesses: open parallelograms that lie in the open sum int A + int B.
//
// 1. Let e be an edge of A and f an edge of B that are not parallel. The open parallelogram e + f
//    lies in the open sum: where e and x - f cross, the interiors of A and x - B meet.
// 2. Let P be a chain of A with the chord u, within r_a of it, and Q a chain of B with the chord v,
//    within r_b. A point x of the parallelogram u + v that is further than r_b from the lines of
//    its sides along v, and further than r_a from those along u, lies in the open sum. For the
//    boundary of the map (s, t) -> P(s) + Q(t) can be pulled straight to that of the parallelogram
//    without passing x. So it winds round x, and P crosses x - Q, also after a small move of B. If
//    the interiors were apart, B could be moved so that P and x - Q do not meet.
//
// Where rings touch in points of both polygons, the sum of two such points is no part of this. It
// may be free by itself (sum/cover.hpp).
//
// Fact 1 is decided exactly where it has to be (sum/contacts.hpp). Here both are decided in
// doubles, with a bound for all roundings: what is called covered is covered.
#pragma once

#include <cstdint>

#include "box.hpp"
#include "chord_tree.hpp"
#include "point.hpp"

namespace gcv {

// A line in relative coordinates, as a superset edge has it. The parameters of its points are
// exact. The points that are computed are off by at most 6 u times the extents of both polygons.
struct RelativeLine {
  Point origin;
  double dx;
  double dy;

  [[nodiscard]] Point at(double t) const { return {origin.x + t * dx, origin.y + t * dy}; }
};

// A chain of a polygon by its chord.
struct Chord {
  Point from;
  Point to;
  double radius;
  double length;

  static Chord of(const ChordTree& tree, ChordTree::Node node) {
    const ChordTree::Block& block = tree.block_of(node);
    const std::uint32_t lane = ChordTree::lane_of(node);
    return {{block.x0[lane], block.y0[lane]},
            {block.x1[lane], block.y1[lane]},
            block.radius[lane],
            block.length[lane]};
  }
};

// The part of the sum of two chords where the chains cover everything: what two strips share. A
// strip has the points at (x, y) from the corner for which p x - q y is between two bounds. A point
// that is off by as much as RelativeLine::at says counts as the exact one.
struct Witness {
  Witness(const Chord& p, const Chord& q, double slack);

  struct Strip {
    double p;
    double q;
    double least;
    double most;
  };

  // Does it hold the box?
  [[nodiscard]] bool holds(const Box& box) const {
    const auto is_in = [&](const Strip& s) {
      const double x0 = box.x0 - corner.x;
      const double x1 = box.x1 - corner.x;
      const double y0 = box.y0 - corner.y;
      const double y1 = box.y1 - corner.y;
      const double low = s.p * (s.p > 0 ? x0 : x1) - s.q * (s.q > 0 ? y1 : y0);
      const double high = s.p * (s.p > 0 ? x1 : x0) - s.q * (s.q > 0 ? y0 : y1);
      return low > s.least && high < s.most;
    };
    return is_in(strips[0]) && is_in(strips[1]);
  }

  // How far it holds the line from t on: a parameter up to 1; t if it does not hold t.
  [[nodiscard]] double reach(const RelativeLine& line, double t) const;

  Point corner;
  Strip strips[2]{};  // none of it is empty if least < most for both
  Box bounds{};       // of the whole sum of the chords
};

}  // namespace gcv
