// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a returned ring is worth, held against the exact ring.
#pragma once

#include <memory>

#include "hausdorff.hpp"
#include "systems/system.hpp"

namespace gcv::bench {

struct Verdict {
  Bounds error;  // the Hausdorff distance from the exact ring, in input units
  bool is_simple = false;
  bool is_counter_clockwise = false;
  // No pocket and no spur is lost: the error is at most ten times the resolution, and the
  // exact ring of a system that tells has as many corners.
  bool is_complete = false;
  bool contains_exact = false;  // the region, if simple

  [[nodiscard]] bool is_right() const { return is_simple && is_counter_clockwise && is_complete; }
};

class Judge {
 public:
  // Of the sum of a and b; the exact ring is libgcv's, in fractions.
  Judge(const Ring& a, const Ring& b);
  ~Judge();
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  [[nodiscard]] std::size_t exact_vertices() const;

  // The resolution, in input units; where the unit in the last place of the largest
  // coordinate is more, that is taken. `corners`: how many the exact ring has by the system's
  // own account, or 0.
  [[nodiscard]] Verdict judge(const Ring& ring, double resolution, std::size_t corners) const;

 private:
  struct Exact;
  std::unique_ptr<Exact> exact_;
};

// The largest distance between two vertices.
double diameter(const Ring& ring);

}  // namespace gcv::bench
