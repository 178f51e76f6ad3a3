// SPDX-License-Identifier: LGPL-3.0-or-later
//
// When a box that moves meets others.
#pragma once

#include <cmath>
#include <cstdint>

#include "pair_descent.hpp"
#include "point.hpp"

namespace gcv {

struct SweptBox {
  Box box;       // at the start
  Point motion;  // until time 1
  double slack;  // how far coordinates may be off

  // Calls visit(lane) for the children of a node whose boxes it may meet, the first one first, as
  // long as that is not after `limit`, which may fall on the way. Ends when a visit returns true.
  template <class Visit>
  [[nodiscard]] bool any_child(const ChainTree::Block& block, const double& limit,
                               Visit visit) const {
    SimdDouble first_x;
    SimdDouble last_x;
    SimdDouble first_y;
    SimdDouble last_y;
    times(block.x0, block.x1, box.x0, box.x1, motion.x, first_x, last_x);
    times(block.y0, block.y1, box.y0, box.y1, motion.y, first_y, last_y);
    const SimdDouble first = larger(first_x, first_y);
    const SimdDouble last = smaller(last_x, last_y);
    const SimdDouble reach = (1 + 0x1p-48) * last + 0x1p-48;
    const unsigned missed = ((first > reach) | (last < -0x1p-48)).bits();
    double times_met[ChainTree::width];
    first.store(times_met);
    return any_in_order(children_of(block) & ~missed, times_met, limit, visit);
  }

 private:
  // When it meets each of four boxes along one axis: from `first` to `last`.
  void times(const double* low, const double* high, double box_low, double box_high, double speed,
             SimdDouble& first, SimdDouble& last) const {
    // So that the inverse of a subnormal speed is finite. A distance that overflows then is out of
    // reach.
    const double unit = std::abs(speed) < 0x1p-900 ? 0x1p120 : 1;
    const double inverse = 1 / (unit * speed);
    const SimdDouble to_low = (SimdDouble::load(low) + -box_high) + -slack;
    const SimdDouble to_high = (SimdDouble::load(high) + -box_low) + slack;
    const SimdDouble p = inverse * (unit * to_low);
    const SimdDouble q = inverse * (unit * to_high);
    first = inverse > 0 ? p : q;
    last = inverse > 0 ? q : p;
  }
};

}  // namespace gcv
