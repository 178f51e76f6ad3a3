// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Regions of real polygons. They are not part of the project: where they are missing, every test
// here is skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "data.hpp"
#include "decomposition_reference.hpp"
#include "exact_geometry.hpp"
#include "exact_rings.hpp"
#include "hausdorff.hpp"
#include "locate.hpp"
#include "nesting_data.hpp"
#include "region_reference.hpp"
#include "regions.hpp"

namespace gcv {
namespace {

class RealRegions : public testing::Test {
 protected:
  void SetUp() override {
    const auto directory = test::data_directory();
    if (!directory) {
      GTEST_SKIP() << "no polygon data: set GCV_DATA_DIR";
    }
    directory_ = *directory;
  }

  std::filesystem::path directory_;
};

// ---- Holes

double area_of_holes(const ExactRegion& region) {
  const invariants::Ring vertices = test::exact(region);
  invariants::Rational twice = 0;
  for (const RegionPart& part : region.parts) {
    if (part.kind == PartKind::hole) {
      const auto first = vertices.begin() + static_cast<std::ptrdiff_t>(part.first);
      twice -= invariants::twice_area({first, first + static_cast<std::ptrdiff_t>(part.size)});
    }
  }
  return twice.convert_to<double>() / 2;
}

struct KnownHoles {
  std::size_t count;
  double area;
};

// From the lines "| pair | A | B | holes | area | ..." of the folder's table.
std::map<std::string, KnownHoles> read_known_holes(const std::filesystem::path& file) {
  std::map<std::string, KnownHoles> known;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string name;
    std::string bar;
    int a = 0;
    int b = 0;
    KnownHoles holes{};
    if (words >> bar >> name >> bar >> a >> bar >> b >> bar >> holes.count >> bar >> holes.area) {
      known[name] = holes;
    }
  }
  return known;
}

TEST_F(RealRegions, KeepHolesThatOthersLose) {
  const auto folder = directory_ / "lost_holes";
  const auto known = read_known_holes(folder / "README.md");
  std::size_t found = 0;
  for (const auto& [name, holes] : known) {
    SCOPED_TRACE(name);
    const test::PolygonRings a{test::read_polygon(folder / (name + "_a.wkt"))};
    const test::PolygonRings b{test::read_polygon(folder / (name + "_b.wkt"))};
    const ExactRegion region = test::sum_region(a, b).exact;
    EXPECT_EQ(test::text_of(region), reference::text(reference::sum_region(a, b, {0, 0})));
    EXPECT_EQ(test::ring_texts(region), reference::rings_of_sum(a, b, {0, 0}));
    EXPECT_EQ(test::hole_count(region), holes.count);
    EXPECT_NEAR(area_of_holes(region), holes.area, 1e-6);
    found += holes.count;
  }
  std::printf("%zu pairs, %zu holes\n", known.size(), found);
  EXPECT_EQ(known.size(), 12U);
}

TEST_F(RealRegions, AgreeWithTheReferences) {
  std::size_t compared = 0;
  std::size_t holes = 0;
  for (const test::NamedPair& pair : test::read_pairs(directory_)) {
    if (pair.a.size() * pair.b.size() > 1250) {
      continue;
    }
    SCOPED_TRACE(pair.name);
    const ExactRegion region = test::sum_region({pair.a}, {pair.b}).exact;
    EXPECT_EQ(test::text_of(region),
              reference::text(reference::sum_region({pair.a}, {pair.b}, {0, 0})));
    EXPECT_EQ(test::ring_texts(region), reference::rings_of_sum({pair.a}, {pair.b}, {0, 0}));
    holes += test::hole_count(region);
    ++compared;
  }
  std::printf("%zu real pairs, %zu holes\n", compared, holes);
  EXPECT_GE(compared, 8U);
}

std::size_t vertex_count(const test::PolygonRings& rings) {
  return std::accumulate(
      rings.begin(), rings.end(), std::size_t{0},
      [](std::size_t count, const PointVector& ring) { return count + ring.size(); });
}

// Polygons with holes and a few without: sums, no-fit regions, and inner fits. In one of them a
// hole touches the outer ring four times, so that its inside falls apart.
TEST_F(RealRegions, OfPolygonsWithHolesAgreeWithTheReferences) {
  std::vector<test::PolygonRings> polygons;
  for (int k = 1; k <= 12; ++k) {
    const auto file = directory_ / "cgal" / ("pwh" + std::to_string(k) + ".wkt");
    if (std::filesystem::exists(file)) {
      polygons.push_back(test::read_rings(file));
    }
  }
  for (const char* name : {"hole1", "hole2"}) {
    polygons.push_back(test::read_rings(directory_ / "acd2d" / (std::string(name) + ".wkt")));
  }
  std::size_t compared = 0;
  std::size_t holes = 0;
  std::size_t fits = 0;
  const auto compare = [&](const ExactRegion& region, const std::string& text,
                           const reference::RegionRings& rings) {
    EXPECT_EQ(test::text_of(region), text);
    EXPECT_EQ(test::ring_texts(region), rings);
    ++compared;
    holes += test::hole_count(region);
    fits += region.parts.size() - test::ring_texts(region).size();
  };
  for (const test::PolygonRings& a : polygons) {
    for (const test::PolygonRings& b : polygons) {
      if (vertex_count(a) * vertex_count(b) > 150) {
        continue;
      }
      SCOPED_TRACE(compared);
      for (const test::PolygonRings& moving : {b, test::negated_rings(b)}) {
        compare(test::sum_region(a, moving).exact,
                reference::text(reference::sum_region(a, moving, {0, 0})),
                reference::rings_of_sum(a, moving, {0, 0}));
      }
      compare(test::fit_region(a, b).exact,
              reference::text(reference::inner_fit_region(a, b, {0, 0})),
              reference::rings_of_inner_fit(a, b, {0, 0}));
    }
  }
  std::printf("%zu polygons, %zu regions, %zu holes, %zu fits\n", polygons.size(), compared, holes,
              fits);
  EXPECT_EQ(polygons.size(), 11U);
}

// ---- Jigsaws

// Of small integers: exact.
bool is_on_edge(const Point& x, const Point& p, const Point& q) {
  const double cross = (q.x - p.x) * (x.y - p.y) - (q.y - p.y) * (x.x - p.x);
  return cross == 0 && (x.x - p.x) * (x.x - q.x) + (x.y - p.y) * (x.y - q.y) <= 0;
}

// Has a ring a vertex on the boundary of the other one? Rings whose insides do not overlap and that
// touch have one.
bool touch(const PointVector& a, const PointVector& b) {
  const auto any_vertex_on = [](const PointVector& vertices, const PointVector& ring) {
    return std::any_of(vertices.begin(), vertices.end(), [&](const Point& x) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        if (is_on_edge(x, ring[k], ring[(k + 1) % ring.size()])) {
          return true;
        }
      }
      return false;
    });
  };
  return any_vertex_on(a, b) || any_vertex_on(b, a);
}

int where_is_origin(const Region& region) { return RegionLocator(region.exact).locate({0, 0}); }

TEST_F(RealRegions, OfJigsaws) {
  const std::vector<test::Jigsaw> jigsaws = test::read_jigsaws(directory_);
  std::size_t pieces = 0;
  std::size_t pairs = 0;
  std::size_t touching = 0;
  for (const test::Jigsaw& jigsaw : jigsaws) {
    SCOPED_TRACE(jigsaw.name);
    const PointVector bin{
        {0, 0}, {jigsaw.width, 0}, {jigsaw.width, jigsaw.height}, {0, jigsaw.height}};
    for (const PointVector& a : jigsaw.pieces) {
      ++pieces;
      EXPECT_EQ(where_is_origin(test::fit_region({bin}, {a})), touch(bin, a) ? 0 : 1);
      EXPECT_EQ(test::text_of(test::fit_region({a}, {a}).exact), "point: 0/1 0/1\n");
      for (const PointVector& b : jigsaw.pieces) {
        if (&a != &b) {
          const bool in_touch = touch(a, b);
          EXPECT_EQ(where_is_origin(test::sum_region({a}, test::negated_rings({b}))),
                    in_touch ? 0 : -1);
          ++pairs;
          touching += in_touch ? 1U : 0U;
        }
      }
    }
  }
  std::printf("%zu bins, %zu pieces, %zu ordered pairs, %zu in touch\n", jigsaws.size(), pieces,
              pairs, touching);
  EXPECT_EQ(jigsaws.size(), 90U);
}

// ---- Stored answers

struct Extents {
  Point low;
  double width;
  double height;
};

Extents extents(const PointVector& points) {
  const auto less_x = [](const Point& p, const Point& q) { return p.x < q.x; };
  const auto less_y = [](const Point& p, const Point& q) { return p.y < q.y; };
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), less_x);
  const auto [bottom, top] = std::minmax_element(points.begin(), points.end(), less_y);
  return {{left->x, bottom->y}, right->x - left->x, top->y - bottom->y};
}

// The last decimal place of the coordinates, one of 1, 0.1, 0.01.
double last_place(const PointVector& ring) {
  for (const double units : {1, 10}) {
    if (std::all_of(ring.begin(), ring.end(), [&](const Point& p) {
          return std::abs(p.x * units - std::round(p.x * units)) < 1e-6 &&
                 std::abs(p.y * units - std::round(p.y * units)) < 1e-6;
        })) {
      return 1 / units;
    }
  }
  return 0.01;
}

// Integers are exact. Other coordinates are rounded, and so are the extents they are moved by.
double rounding_of(const PointVector& ring) {
  const double place = last_place(ring);
  return place == 1 ? 1e-9 : place;
}

// Moved to the origin.
bench::WideRing moved(const PointVector& ring) {
  const Point low = extents(ring).low;
  bench::WideRing result;
  for (const Point& p : ring) {
    result.push_back({bench::Wide(p.x) - low.x, bench::Wide(p.y) - low.y});
  }
  return result;
}

PointVector first_ring(const RoundedRegion& region) {
  const auto end = static_cast<std::ptrdiff_t>(region.parts.front().size);
  return {region.vertices.begin(), region.vertices.begin() + end};
}

double distance_from_stored(const Region& region, const test::StoredRing& stored) {
  return bench::hausdorff_distance(moved(first_ring(region.rounded)), moved(stored.ring)).upper;
}

// The boards are rectangles, and so are the inner fits.
TEST_F(RealRegions, AgreeWithStoredInnerFits) {
  std::size_t compared = 0;
  for (const test::NestingInstance& instance : test::read_nesting_instances(directory_)) {
    for (const test::StoredRing& stored : instance.inner_fits) {
      SCOPED_TRACE(instance.name + " " + std::to_string(stored.moving));
      const PointVector& piece = instance.pieces[stored.moving];
      const Region region = test::fit_region({instance.board}, {piece}, piece.front());
      ASSERT_EQ(region.exact.parts.size(), 1U);
      const PointVector ring = first_ring(region.rounded);
      EXPECT_EQ(ring.size(), 4U);
      EXPECT_LE(distance_from_stored(region, stored), rounding_of(stored.ring));
      // Where the first vertex of the piece is, if the piece is in the lower left corner.
      EXPECT_EQ(ring.front().x, piece.front().x - extents(piece).low.x);
      EXPECT_EQ(ring.front().y, piece.front().y - extents(piece).low.y);
      ++compared;
    }
  }
  std::printf("%zu inner fits\n", compared);
  EXPECT_EQ(compared, 97U);
}

bool is_of_other_pieces(const test::NestingInstance& instance, const test::StoredRing& stored) {
  const auto& pieces = instance.pieces;
  return std::any_of(pieces.begin(), pieces.end(), [&](const PointVector& fixed) {
    return std::any_of(pieces.begin(), pieces.end(), [&](const PointVector& moving) {
      const Region region = test::sum_region({fixed}, test::negated_rings({moving}));
      return distance_from_stored(region, stored) <= rounding_of(stored.ring);
    });
  });
}

TEST_F(RealRegions, AgreeWithStoredNoFitPolygons) {
  std::size_t compared = 0;
  std::size_t exact = 0;
  std::size_t of_other_pieces = 0;
  double largest = 0;
  for (const test::NestingInstance& instance : test::read_nesting_instances(directory_)) {
    for (const test::StoredRing& stored : instance.no_fits) {
      SCOPED_TRACE(instance.name + " " + std::to_string(stored.fixed) + " " +
                   std::to_string(stored.moving));
      const PointVector& fixed = instance.pieces[stored.fixed];
      const PointVector& moving = instance.pieces[stored.moving];
      const Region region = test::sum_region({fixed}, test::negated_rings({moving}));
      const double rounding = rounding_of(stored.ring);
      const Extents e = extents(stored.ring);
      if (std::abs(e.width - extents(fixed).width - extents(moving).width) > rounding ||
          std::abs(e.height - extents(fixed).height - extents(moving).height) > rounding) {
        // Stored is the ring of other pieces. These here fit into each other, along a segment.
        ++of_other_pieces;
        EXPECT_TRUE(is_of_other_pieces(instance, stored));
        EXPECT_EQ(region.exact.parts.size(), 2U);
        EXPECT_EQ(region.exact.parts.back().kind, PartKind::segment);
        continue;
      }
      // No stored one has a hole.
      EXPECT_EQ(region.exact.parts.size(), 1U);
      const double distance = distance_from_stored(region, stored);
      EXPECT_LE(distance, rounding);
      exact += distance <= 1e-9 ? 1U : 0U;
      largest = std::max(largest, distance / rounding);
      ++compared;
    }
  }
  std::printf("%zu no-fit polygons, %zu exact, the others within %.2f of the last place\n",
              compared, exact, largest);
  EXPECT_EQ(compared, 1061U);
  EXPECT_EQ(of_other_pieces, 2U);
}

}  // namespace
}  // namespace gcv
