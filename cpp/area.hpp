// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <span>

#include "point.hpp"

namespace gcv {

// The area inside a counter-clockwise ring, correctly rounded to nearest; infinite where
// it is beyond the largest double.
double ring_area(std::span<const Point> ring);

}  // namespace gcv
