// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "simd.hpp"

namespace gcv {

// Of four half-planes, the points x with e x (x - p) > least. A convex polygon has several blocks.
struct HalfPlanes {
  double px[SimdDouble::width];
  double py[SimdDouble::width];
  double ex[SimdDouble::width];
  double ey[SimdDouble::width];
  double least[SimdDouble::width];
};

}  // namespace gcv
