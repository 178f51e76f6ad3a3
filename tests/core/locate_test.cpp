// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Places of points in random regions, against a loop over all parts in fractions.
#include "locate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "exact_rings.hpp"
#include "region_families.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

using invariants::Exact;

struct Part {
  bool is_outer;
  bool is_ring;
  invariants::Ring points;
};

std::vector<Part> parts_of(const ExactRegion& region) {
  const invariants::Ring points = test::exact(region);
  std::vector<Part> parts;
  for (const RegionPart& part : region.parts) {
    const auto first = points.begin() + static_cast<std::ptrdiff_t>(part.first);
    parts.push_back({part.kind == PartKind::outer,
                     part.is_ring(),
                     {first, first + static_cast<std::ptrdiff_t>(part.size)}});
  }
  return parts;
}

int slowly_located(const std::vector<Part>& parts, const Exact& x) {
  int crossings = 0;
  for (const Part& part : parts) {
    const invariants::Ring& p = part.points;
    if (!part.is_ring) {
      if (p.size() == 1 ? p[0] == x : invariants::on_segment(p[0], p[1], x)) {
        return 0;
      }
      continue;
    }
    const int where = invariants::location(p, x);
    if (where == 0) {
      return 0;
    }
    crossings += where > 0 ? 1 : 0;
  }
  return crossings % 2 == 0 ? -1 : 1;
}

TEST(Locate, IsWhatALoopOverAllPartsFinds) {
  std::array<std::size_t, 3> counts{};
  std::size_t on_fits = 0;
  for (const test::RegionFamily& family : test::region_families()) {
    test::Random random(341);
    for (int k = 0; k < 25; ++k) {
      SCOPED_TRACE(std::string(family.name) + " " + std::to_string(k));
      const test::RegionCase c = family.next_case(random);
      const Region region =
          c.inner_fit ? test::fit_region(c.a, c.b, c.shift) : test::sum_region(c.a, c.b, c.shift);
      const std::vector<Part> parts = parts_of(region.exact);
      const RegionLocator locator(region.exact);
      std::vector<Point> points{{0, 0}, {1e300, -1e300}};
      const auto add = [&](const Exact& p) {
        const auto [x, y] = invariants::nearest(p);
        points.insert(points.end(), {{x, y}, {x, std::nextafter(y, 1e300)}, {x - 1, y}});
      };
      for (const Part& part : parts) {
        for (std::size_t i = 0; i < part.points.size(); ++i) {
          const Exact& p = part.points[i];
          const Exact& q = invariants::next(part.points, i);
          add(p);
          add(invariants::Rational(1, 2) * (p + q));
          if (!part.is_ring && invariants::exact(invariants::nearest(p)) == p) {
            const auto [x, y] = invariants::nearest(p);
            ASSERT_EQ(locator.locate({x, y}), 0);
            ++on_fits;
          }
        }
      }
      for (int n = 0; n < 20; ++n) {
        const double x = test::uniform(random, -80, 240) / 8.0;
        points.push_back({x, test::uniform(random, -80, 240) / 8.0});
      }
      for (const Point& p : points) {
        const int expected = slowly_located(parts, test::exact(p));
        ASSERT_EQ(locator.locate(p), expected) << p.x << " " << p.y;
        ++counts[static_cast<std::size_t>(expected + 1)];
      }
    }
  }
  for (const std::size_t count : counts) {
    EXPECT_GT(count, 1000U);
  }
  EXPECT_GT(on_fits, 100U);
}

}  // namespace
}  // namespace gcv
