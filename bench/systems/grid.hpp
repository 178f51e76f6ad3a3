// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The integer grid that polygons are rounded to for systems that compute on integers: the
// same for both polygons.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include "system.hpp"

namespace gcv::bench {

template <class Integer>
class IntegerGrid {
 public:
  explicit IntegerGrid(double cells_per_unit, Integer most = std::numeric_limits<Integer>::max())
      : cells_per_unit_(cells_per_unit), most_(static_cast<double>(most / 2)) {}

  // Throws where sums could be beyond the largest integer.
  [[nodiscard]] Integer to_grid(double x) const {
    const double cell = std::round(x * cells_per_unit_);
    if (std::abs(cell) > most_) {
      throw std::range_error("refused: beyond the integers");
    }
    return static_cast<Integer>(cell);
  }
  [[nodiscard]] double from_grid(Integer cell) const {
    return static_cast<double>(cell) / cells_per_unit_;
  }

 private:
  double cells_per_unit_;
  double most_;
};

}  // namespace gcv::bench
