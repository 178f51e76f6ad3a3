// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cases of tests/peers by the references: what is right where the answers of others are not.
// README.md there describes the format.
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "data.hpp"
#include "decomposition_reference.hpp"
#include "region_reference.hpp"
#include "regions.hpp"
#include "wkt.hpp"

namespace gcv {
namespace {

// Of Well-Known Text, or of a file of the polygon data.
test::PolygonRings rings_of(const std::string& text) {
  return text.ends_with(".wkt") ? test::read_rings(*test::data_directory() / text)
                                : parse_polygon(text, "polygon");
}

void compare(const std::string& operation, const test::PolygonRings& a, const test::PolygonRings& b,
             const Point& reference) {
  if (operation == "inner_fit") {
    const ExactRegion region = test::fit_region(a, b, reference).exact;
    EXPECT_EQ(test::text_of(region), reference::text(reference::inner_fit_region(a, b, reference)));
    EXPECT_EQ(test::ring_texts(region), reference::rings_of_inner_fit(a, b, reference));
    return;
  }
  const test::PolygonRings added = operation == "no_fit" ? test::negated_rings(b) : b;
  const ExactRegion region = test::sum_region(a, added, reference).exact;
  EXPECT_EQ(test::text_of(region), reference::text(reference::sum_region(a, added, reference)));
  EXPECT_EQ(test::ring_texts(region), reference::rings_of_sum(a, added, reference));
}

std::size_t compare_all(const std::string& suite) {
  std::ifstream file(std::filesystem::path(GCV_PEERS) / (suite + ".txt"));
  test::PolygonRings a;
  test::PolygonRings b;
  std::size_t compared = 0;
  std::string name;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "case") {
      name = line;
    } else if (word == "a" || word == "b") {
      (word == "a" ? a : b) = rings_of(line.substr(2));
    } else if (word == "sum" || word == "no_fit" || word == "inner_fit") {
      SCOPED_TRACE(name);
      Point reference{0, 0};
      words >> reference.x >> reference.y;
      compare(word, a, b, reference);
      ++compared;
    }
  }
  return compared;
}

TEST(Peers, Libnfporb) { EXPECT_EQ(compare_all("libnfporb"), 42U); }

TEST(Peers, Sfcgal) { EXPECT_EQ(compare_all("sfcgal"), 7U); }

TEST(Peers, Cgal) {
  if (!test::data_directory()) {
    GTEST_SKIP() << "no polygon data: set GCV_DATA_DIR";
  }
  EXPECT_EQ(compare_all("cgal"), 21U);
}

}  // namespace
}  // namespace gcv
