// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Certified bounds on the Hausdorff distance between two closed polygonal curves: the
// largest distance of any point of one of them, edges and all, from the other one.
#pragma once

#include <vector>

namespace gcv::bench {

// Binary128: 113 bits, of which differences of coordinates lose few.
using Wide = __float128;

struct WidePoint {
  Wide x;
  Wide y;
};
using WideRing = std::vector<WidePoint>;

struct Bounds {
  double lower;
  double upper;  // at most 1.05 lower + 2^-98 times the largest coordinate
};

// Of rings whose coordinates have been rounded to binary128. Coordinates and squares of
// distances are within the range of doubles.
Bounds hausdorff_distance(const WideRing& p, const WideRing& q);

}  // namespace gcv::bench
