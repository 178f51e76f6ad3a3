// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What holds of the sum of any two polygons, checked in fractions, through the C interface
// alone. For tests and for fuzzers.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace gcv::invariants {

using Point = std::array<double, 2>;
using Polygon = std::vector<Point>;  // as passed to gcv_polygon_create

struct Effort {
  // The edges that each check may look at, about: small inputs are checked completely,
  // large ones by samples.
  std::size_t work = 20000;
  // Check GCV_ROUND_OUTWARD too.
  bool outward = true;
  // Is GCV_ERR_RANGE an answer?
  bool may_be_out_of_range = false;
};

// A sentence for each invariant that does not hold for a + b: none, if all is well.
std::vector<std::string> broken_invariants(const Polygon& a, const Polygon& b,
                                           const Effort& effort = {});

// The same for the region of a + b, with its holes and exact fits; and for the inner fit of one
// polygon in another.
std::vector<std::string> broken_region_invariants(const Polygon& a, const Polygon& b,
                                                  const Effort& effort = {});
std::vector<std::string> broken_fit_invariants(const Polygon& container, const Polygon& moving,
                                               const Effort& effort = {});

// A sentence for each promise that the polygons simplified by the tolerance, in both
// roundings, do not keep; and the same for the sum a + b with that tolerance.
std::vector<std::string> broken_simplification(const Polygon& polygon, double tolerance,
                                               const Effort& effort = {});
std::vector<std::string> broken_sum_within(const Polygon& a, const Polygon& b, double tolerance,
                                           const Effort& effort = {});

// Is the ring simple in these doubles? No vertex may be repeated; those on a straight line
// may.
bool is_simple(const Polygon& ring);

// What comes of a + b where each exact coordinate is rounded to the nearest double and
// nothing more is done; and what the library makes of it.
struct Rounded {
  Polygon naive;
  Polygon returned;
  double error_bound = 0;
};
Rounded rounded_sum(const Polygon& a, const Polygon& b);

// Well-Known Text with 17 digits.
std::string wkt(const Polygon& ring);

}  // namespace gcv::invariants
