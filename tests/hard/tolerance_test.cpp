// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a tolerance promises, on the catalogue of hard cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "catalogue.hpp"
#include "invariants.hpp"

namespace gcv::hard {
namespace {

using invariants::Point;

class Tolerance : public ::testing::TestWithParam<Family> {};

double size_of(const Polygon& polygon) {
  const auto [x0, x1] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const Point& p, const Point& q) { return p[0] < q[0]; });
  const auto [y0, y1] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const Point& p, const Point& q) { return p[1] < q[1]; });
  return std::max((*x1)[0] / 2 - (*x0)[0] / 2, (*y1)[1] / 2 - (*y0)[1] / 2);
}

// Of parts of their size: nothing but noise, details, large parts, all of them. Of the largest
// polygons, details alone.
std::vector<double> tolerances(const Polygon& polygon) {
  constexpr std::size_t many_vertices = 20000;
  if (polygon.size() > many_vertices) {
    return {1e-3};
  }
  return {1e-12, 1e-3, 0.05, 3};
}

double part_of(double size, double part) {
  return std::min(part * size, std::numeric_limits<double>::max());
}

void expect_kept(const Polygon& polygon, double part, std::size_t pair) {
  const double tolerance = part_of(size_of(polygon), part);
  for (const std::string& sentence :
       invariants::broken_simplification(polygon, tolerance, Tolerance::GetParam().effort)) {
    ADD_FAILURE() << "pair " << pair << ": " << sentence << "\n" << invariants::wkt(polygon);
  }
}

TEST_P(Tolerance, IsKept) {
  const Pairs pairs = GetParam().pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto& [a, b] = pairs[k];
    for (const double part : tolerances(a)) {
      expect_kept(a, part, k);
      if (b != a) {
        expect_kept(b, part, k);
      }
      const double tolerance = part_of(std::max(size_of(a), size_of(b)), part);
      for (const std::string& sentence :
           invariants::broken_sum_within(a, b, tolerance, GetParam().effort)) {
        ADD_FAILURE() << "pair " << k << ", sum: " << sentence;
      }
    }
  }
}

std::string name(const ::testing::TestParamInfo<Family>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(fits, Tolerance, ::testing::ValuesIn(fits()), name);
INSTANTIATE_TEST_SUITE_P(directions, Tolerance, ::testing::ValuesIn(directions()), name);
INSTANTIATE_TEST_SUITE_P(coincidences, Tolerance, ::testing::ValuesIn(coincidences()), name);
INSTANTIATE_TEST_SUITE_P(curves, Tolerance, ::testing::ValuesIn(curves()), name);
INSTANTIATE_TEST_SUITE_P(magnitudes, Tolerance, ::testing::ValuesIn(magnitudes()), name);

}  // namespace
}  // namespace gcv::hard
