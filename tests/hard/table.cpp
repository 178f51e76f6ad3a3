// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The catalogue as a table in Markdown: for each family the number of pairs, how many of
// the results are not simple when each coordinate is just rounded, how many were repaired,
// and the largest error bounds in units in the last place of the largest coordinate.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catalogue.hpp"
#include "gcv/gcv.h"

namespace gcv::hard {
namespace {

double in_ulps(double error, const Polygon& ring) {
  double largest = 0;
  for (const auto& [x, y] : ring) {
    largest = std::max({largest, std::abs(x), std::abs(y)});
  }
  return error / (largest - std::nextafter(largest, 0.0));
}

double outward_bound(const Pair& pair) {
  gcv_polygon* a = nullptr;
  gcv_polygon* b = nullptr;
  gcv_outer_face* face = nullptr;
  gcv_options options = GCV_OPTIONS_INIT;
  options.rounding = GCV_ROUND_OUTWARD;
  double bound = HUGE_VAL;
  if (gcv_polygon_create(pair.a.front().data(), pair.a.size(), 0, &a) == GCV_OK &&
      gcv_polygon_create(pair.b.front().data(), pair.b.size(), 0, &b) == GCV_OK &&
      gcv_minkowski_sum(a, b, &options, &face) == GCV_OK &&
      gcv_outer_face_error_bound(face, &bound) != GCV_OK) {
    bound = HUGE_VAL;
  }
  gcv_outer_face_destroy(face);
  gcv_polygon_destroy(b);
  gcv_polygon_destroy(a);
  return bound;
}

void print_row(const Family& family) {
  const Pairs pairs = family.pairs();
  int naive_failures = 0;
  int out_of_range = 0;
  double nearest = 0;
  double outward = 0;
  for (const Pair& pair : pairs) {
    const invariants::Rounded sum = invariants::rounded_sum(pair.a, pair.b);
    if (sum.returned.empty()) {
      ++out_of_range;
      continue;
    }
    naive_failures += invariants::is_simple(sum.naive) ? 0 : 1;
    nearest = std::max(nearest, in_ulps(sum.error_bound, sum.returned));
    outward = std::max(outward, in_ulps(outward_bound(pair), sum.returned));
  }
  std::printf("| %s | %zu | %d | %d | %.2g | %.2g |\n", family.name, pairs.size(), naive_failures,
              out_of_range, nearest, outward);
}

}  // namespace
}  // namespace gcv::hard

int main() {
  std::puts(
      "| family | pairs | not simple if just rounded | out of range | nearest, ulps | outward, "
      "ulps |");
  std::puts("| --- | --- | --- | --- | --- | --- |");
  for (const auto theme : {gcv::hard::fits, gcv::hard::directions, gcv::hard::coincidences,
                           gcv::hard::curves, gcv::hard::magnitudes}) {
    for (const gcv::hard::Family& family : theme()) {
      gcv::hard::print_row(family);
    }
  }
  return 0;
}
