// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a line is near the sums of chains, and what these cover of it.
#include <cmath>
#include <limits>

#include "simd.hpp"
#include "witness_search.hpp"

namespace gcv {

// A point x of the line has the parameter t. Its coordinates in the parallelogram u + v, w x v and
// u x w, are linear in t. So are its own. That gives a range of parameters for each of the bounds.
// A bound is crossed at a parameter that is computed with three roundings. For parameters up to 2
// they are worth less than 16 uE (|u| + |v|) in the bound. With what a witness allows for the
// others, twice the slack is enough. Comparisons with what is not a number are false. So such a
// range is near, and covers nothing.
WitnessSearch::Ranges WitnessSearch::ranges(const Family& family) const {
  if (!(slack_ < infinity)) {
    return {{-2, -2, -2, -2}, {2, 2, 2, 2}, {2, 2, 2, 2}, {-2, -2, -2, -2}};
  }
  const ChordTree::Block& chords = family.children;
  const std::uint32_t lane = ChordTree::lane_of(family.other);
  const ChordTree::Block& of_other = family.of_other;
  const double dx = line_.dx;
  const double dy = line_.dy;
  const Point from{of_other.x0[lane], of_other.y0[lane]};
  const Point v{of_other.x1[lane] - from.x, of_other.y1[lane] - from.y};
  const double other_radius = of_other.radius[lane];
  const double other_length = of_other.length[lane];
  const double slack = 2 * slack_;
  constexpr double smallest = std::numeric_limits<double>::min();

  const SimdDouble x0 = SimdDouble::load(chords.x0);
  const SimdDouble y0 = SimdDouble::load(chords.y0);
  const SimdDouble ux = SimdDouble::load(chords.x1) - x0;
  const SimdDouble uy = SimdDouble::load(chords.y1) - y0;
  const SimdDouble length = SimdDouble::load(chords.length);
  const SimdDouble radius = SimdDouble::load(chords.radius);
  const SimdDouble wx = (line_.origin.x - from.x) - x0;
  const SimdDouble wy = (line_.origin.y - from.y) - y0;
  const SimdDouble along_u = v.y * wx - v.x * wy;
  const SimdDouble along_v = ux * wy - uy * wx;
  const SimdDouble inverse_u = SimdDouble::of(1 / (dx * v.y - dy * v.x));
  const SimdDouble inverse_v = 1 / (dy * ux - dx * uy);
  const SimdDouble cross = v.y * ux - v.x * uy;
  const SimdDouble lowest = smaller(cross, SimdDouble::of(0));
  const SimdDouble highest = larger(cross, SimdDouble::of(0));
  const SimdDouble size = magnitude(ux) + magnitude(uy) + (std::abs(v.x) + std::abs(v.y));
  const SimdDouble radii = radius + other_radius;
  const SimdDouble tolerance = slack * size + smallest;
  const SimdDouble room = slack * (size + 4 * radii) + smallest;
  const SimdDouble room_u = other_length * radii + room;
  const SimdDouble room_v = length * radii + room;
  const SimdDouble least_u = tolerance + other_radius * other_length;
  const SimdDouble least_v = radius * length + tolerance;

  // Takes what lies between two parameters.
  const auto cut = [](SimdDouble& first, SimdDouble& last, const SimdDouble& s,
                      const SimdDouble& t) {
    first = larger(smaller(s, t), first);
    last = smaller(larger(s, t), last);
  };
  SimdDouble near_from = SimdDouble::of(-2);
  SimdDouble near_to = SimdDouble::of(2);
  cut(near_from, near_to, (lowest - room_u - along_u) * inverse_u,
      (highest + room_u - along_u) * inverse_u);
  cut(near_from, near_to, (lowest - room_v - along_v) * inverse_v,
      (highest + room_v - along_v) * inverse_v);
  // The boxes of the children, moved by that of the other node, in a frame.
  const auto cut_by = [&](const TurnedBoxes::Boxes& boxes, const Box& beside, const Point& origin,
                          const Point& way) {
    const double inverse_x = 1 / way.x;
    const double inverse_y = 1 / way.y;
    cut(near_from, near_to,
        inverse_x * (SimdDouble::load(boxes.x0) + (beside.x0 - slack - origin.x)),
        inverse_x * (SimdDouble::load(boxes.x1) + (beside.x1 + slack - origin.x)));
    cut(near_from, near_to,
        inverse_y * (SimdDouble::load(boxes.y0) + (beside.y0 - slack - origin.y)),
        inverse_y * (SimdDouble::load(boxes.y1) + (beside.y1 + slack - origin.y)));
  };
  cut_by(chords.boxes, of_other.boxes.box(lane), line_.origin, {dx, dy});
  if (!turned_.empty()) {
    const std::uint32_t block_of_other = family.other / ChordTree::width;
    cut_by(turned_.of_block(family.is_of_a, family.number),
           turned_.of_block(!family.is_of_a, block_of_other).box(lane), turned_origin_,
           turned_way_);
  }
  SimdDouble covered_from = SimdDouble::of(-2);
  SimdDouble covered_to = SimdDouble::of(2);
  cut(covered_from, covered_to, (lowest + least_u - along_u) * inverse_u,
      (highest - least_u - along_u) * inverse_u);
  cut(covered_from, covered_to, (lowest + least_v - along_v) * inverse_v,
      (highest - least_v - along_v) * inverse_v);
  const SimdDouble nothing = SimdDouble::of(infinity);
  Ranges result;
  near_from.store(result.near_from);
  near_to.store(result.near_to);
  // Where bounds are not in order, nothing is covered.
  select(lowest + least_u < highest - least_u, covered_from, nothing).store(result.covered_from);
  select(lowest + least_v < highest - least_v, covered_to, SimdDouble::of(-2))
      .store(result.covered_to);
  return result;
}

}  // namespace gcv
