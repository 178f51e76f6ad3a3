// SPDX-License-Identifier: LGPL-3.0-or-later
#include "overlaps.hpp"

#include <cstdint>

#include "generators.hpp"

namespace gcv::bench {

PointVector overlaps(const gcv_polygon* a, const gcv_polygon* b, std::size_t count) {
  double of_a[4];
  double of_b[4];
  check(gcv_polygon_bounds(a, of_a));
  check(gcv_polygon_bounds(b, of_b));
  test::Random random(5);
  const auto between = [&](double low, double high) {
    return low + (high - low) * test::uniform(random, 0, 1 << 20) / (1 << 20);
  };
  PointVector places;
  while (places.size() < count) {
    const double x = between(of_a[0] - of_b[2], of_a[2] - of_b[0]);
    const Point p{x, between(of_a[1] - of_b[3], of_a[3] - of_b[1])};
    std::int8_t relation = 0;
    check(gcv_relation(a, b, &p.x, 1, nullptr, &relation));
    if (relation == GCV_OVERLAPPING) {
      places.push_back(p);
    }
  }
  return places;
}

}  // namespace gcv::bench
