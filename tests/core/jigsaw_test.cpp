// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Jigsaws: pieces that tile a container exactly, those of others and our own. Whatever is taken out
// goes back, and a single piece has no other place.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "data.hpp"
#include "exact_vertices.hpp"
#include "handles.hpp"
#include "jigsaw_maker.hpp"
#include "nesting_data.hpp"

namespace gcv::test {
namespace {

using invariants::Exact;
using invariants::PolygonHandle;
using invariants::Rational;
using invariants::require;
using Id = std::uint64_t;
using Position = invariants::Point;
using RegionHandle = std::unique_ptr<gcv_region, invariants::Destroy>;

// ---- Free regions

struct Part {
  std::int32_t kind;
  invariants::Ring vertices;
};

std::vector<Part> parts_of(const gcv_region* region) {
  const auto sizes = invariants::elements(gcv_region_exact_parts, region);
  std::size_t count = 0;
  for (const gcv_region_part& part : sizes) {
    count += part.vertex_count;
  }
  const invariants::Ring vertices = invariants::exact_points(
      count, [&](auto... arguments) { return gcv_region_exact_vertex(region, arguments...); });
  std::vector<Part> parts;
  auto next = vertices.begin();
  for (const gcv_region_part& part : sizes) {
    const auto end = next + static_cast<std::ptrdiff_t>(part.vertex_count);
    parts.push_back({part.kind, {next, end}});
    next = end;
  }
  return parts;
}

bool is_on(const Part& part, const Exact& place) {
  for (std::size_t k = 0; k < part.vertices.size(); ++k) {
    if (invariants::on_segment(part.vertices[k], invariants::next(part.vertices, k), place)) {
      return true;
    }
  }
  return false;
}

// The first part that the place is on: rings come before segments, and these before points.
const Part* part_at(const std::vector<Part>& parts, const Exact& place) {
  const auto found =
      std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return is_on(p, place); });
  return found == parts.end() ? nullptr : &*found;
}

// The furthest position in a direction; of several the lexicographically smallest.
Exact furthest(const std::vector<Part>& parts, const Exact& direction) {
  const Exact* best = nullptr;
  for (const Part& part : parts) {
    for (const Exact& p : part.vertices) {
      const int more = best == nullptr ? 1 : invariants::sign(dot(p - *best, direction));
      if (more > 0 || (more == 0 && p < *best)) {
        best = &p;
      }
    }
  }
  return *best;
}

// ---- Puzzles

struct Puzzle {
  PolygonHandle container;
  std::vector<PolygonHandle> pieces;
  std::vector<Position> places;
};

// Of places of pieces.
struct Counts {
  std::size_t inside = 0;
  std::size_t ring = 0;
  std::size_t segment = 0;
  std::size_t point = 0;
  std::size_t best = 0;  // furthest in a direction

  [[nodiscard]] std::size_t all() const { return inside + ring + segment + point; }
  void print(const char* what) const {
    std::printf("%s: %zu places, %zu inside, %zu on rings, %zu on segments, %zu points, %zu best\n",
                what, all(), inside, ring, segment, point, best);
  }
};

class Solver {
 public:
  explicit Solver(const Puzzle& puzzle) : puzzle_(puzzle), ids_(puzzle.pieces.size()) {
    gcv_scene* out = nullptr;
    require(gcv_scene_create(&out), "a scene");
    scene_.reset(out);
    require(gcv_scene_set_container(out, puzzle.container.get()), "a container");
    std::vector<const gcv_polygon*> polygons;
    for (const PolygonHandle& piece : puzzle.pieces) {
      polygons.push_back(piece.get());
    }
    require(gcv_scene_add(out, polygons.data(), puzzle.places.front().data(), polygons.size(),
                          ids_.data()),
            "pieces");
  }

  // No piece overlaps another one or leaves the container. Each touches another one.
  void expect_no_overlap() {
    gcv_pair_list* out = nullptr;
    require(gcv_scene_pairs(scene_.get(), nullptr, 0, nullptr, nullptr, &out), "pairs");
    const invariants::PairListHandle list(out);
    for (const gcv_pair& pair : invariants::elements(gcv_pair_list_pairs, list.get())) {
      EXPECT_NE(pair.relation, GCV_OVERLAPPING) << pair.a << " and " << pair.b;
      if (pair.relation == GCV_TOUCHING && pair.a > 1) {
        neighbours_[pair.a].push_back(pair.b);
        neighbours_[pair.b].push_back(pair.a);
      }
    }
    EXPECT_TRUE(ids_.size() == 1 || neighbours_.size() == ids_.size());
  }

  // One after another alone: each has no other place, and finds it from nearby.
  void take_out_each(Counts& counts) {
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      SCOPED_TRACE("piece " + std::to_string(k));
      const std::vector<Id> ignored{ids_[k]};
      EXPECT_EQ(take_out(k, ignored, counts), 1U);
      expect_back_from({0.25, -0.5}, k, ignored);
    }
  }

  // Each with some of those that it touches: it has room then.
  void take_out_neighbours(std::size_t most, Counts& counts) {
    for (std::size_t k = 0; k < ids_.size(); ++k) {
      SCOPED_TRACE("piece " + std::to_string(k) + " and neighbours");
      std::vector<Id> ignored = neighbours_[ids_[k]];
      ignored.resize(std::min(most, ignored.size()));
      ignored.push_back(ids_[k]);
      take_out(k, ignored, counts);
    }
  }

 private:
  // Checks that piece k is free at its own place. Returns how many vertices its free region has.
  std::size_t take_out(std::size_t k, const std::vector<Id>& ignored, Counts& counts) {
    const gcv_polygon* const piece = puzzle_.pieces[k].get();
    const Position& at = puzzle_.places[k];
    const Exact place = invariants::exact(at);
    const gcv_query query{sizeof(gcv_query), UINT32_MAX, ignored.data(), ignored.size()};

    std::int8_t relation = 0;
    require(gcv_scene_relation(scene_.get(), piece, at.data(), 1, &query, nullptr, &relation),
            "a relation");
    EXPECT_NE(relation, GCV_OVERLAPPING);
    if (ignored.size() == 1) {
      EXPECT_EQ(relation, GCV_TOUCHING);
    }

    gcv_region* out = nullptr;
    require(gcv_scene_free_region(scene_.get(), piece, nullptr, &query, nullptr, &out), "a region");
    const RegionHandle region(out);
    std::int8_t where = 0;
    require(gcv_region_locate(out, at.data(), 1, &where), "a location");
    EXPECT_EQ(where, relation == GCV_TOUCHING ? GCV_BOUNDARY : GCV_INSIDE);
    const std::vector<Part> parts = parts_of(out);
    const Part* const part = part_at(parts, place);
    EXPECT_EQ(part != nullptr, where == GCV_BOUNDARY);
    if (part == nullptr) {
      ++counts.inside;
    } else {
      ++(part->kind == GCV_PART_POINT     ? counts.point
         : part->kind == GCV_PART_SEGMENT ? counts.segment
                                          : counts.ring);
    }
    if (parts.empty()) {
      return 0;  // told above
    }
    for (const Position& direction : {Position{-1, 0}, Position{0, -1}, Position{3, 2}}) {
      expect_best(direction, k, query, parts, counts);
    }
    return parts.size() == 1 ? parts.front().vertices.size() : parts.size();
  }

  void expect_best(const Position& direction, std::size_t k, const gcv_query& query,
                   const std::vector<Part>& parts, Counts& counts) {
    const gcv_polygon* const piece = puzzle_.pieces[k].get();
    const Exact place = invariants::exact(puzzle_.places[k]);
    const Exact along = invariants::exact(direction);
    const Exact furthest_one = furthest(parts, along);
    Position best{};
    std::int32_t found = 0;
    require(
        gcv_scene_best(scene_.get(), piece, direction.data(), &query, nullptr, best.data(), &found),
        "the best position");
    ASSERT_EQ(found, 1);
    EXPECT_GE(dot(furthest_one - place, along), 0);
    if (furthest_one == place) {
      ++counts.best;
    }
    const Position rounded{invariants::nearest(furthest_one.x),
                           invariants::nearest(furthest_one.y)};
    if (invariants::exact(rounded) == furthest_one) {
      EXPECT_EQ(best, rounded) << "along " << direction[0] << ' ' << direction[1];
      return;
    }
    // 2^12 units in the last place of what is less than 2^10.
    EXPECT_NEAR(best[0], rounded[0], 0x1p-30);
    EXPECT_NEAR(best[1], rounded[1], 0x1p-30);
  }

  // From its place moved a little the shortest way leads back to it.
  void expect_back_from(const Position& by, std::size_t k, const std::vector<Id>& ignored) {
    const Position& at = puzzle_.places[k];
    const Position from{at[0] + by[0], at[1] + by[1]};
    const gcv_query query{sizeof(gcv_query), UINT32_MAX, ignored.data(), ignored.size()};
    gcv_escape escape{};
    require(gcv_scene_penetration(scene_.get(), puzzle_.pieces[k].get(), from.data(), 1, &query,
                                  nullptr, &escape),
            "a way out");
    EXPECT_EQ(escape.relation, GCV_TOUCHING);
    EXPECT_EQ((Position{escape.position[0], escape.position[1]}), at);
    EXPECT_EQ((Position{escape.translation[0], escape.translation[1]}), (Position{-by[0], -by[1]}));
    EXPECT_EQ(escape.depth, std::sqrt(by[0] * by[0] + by[1] * by[1]));
  }

  const Puzzle& puzzle_;
  invariants::SceneHandle scene_;
  std::vector<Id> ids_;
  std::map<Id, std::vector<Id>> neighbours_;  // without the container
};

// ---- Those of others

// Pieces are moved to the origin, and their places are where they were: integers.
Puzzle made(const Jigsaw& jigsaw) {
  const double w = jigsaw.width;
  const double h = jigsaw.height;
  Puzzle puzzle{invariants::make({{0, 0}, {w, 0}, {w, h}, {0, h}}), {}, {}};
  for (const PointVector& piece : jigsaw.pieces) {
    const gcv::Point place = piece.front();
    invariants::Polygon vertices;
    for (const gcv::Point& p : piece) {
      vertices.push_back({p.x - place.x, p.y - place.y});
    }
    puzzle.pieces.push_back(invariants::make(vertices));
    puzzle.places.push_back({place.x, place.y});
  }
  return puzzle;
}

TEST(Jigsaws, OfOthers) {
  const auto directory = data_directory();
  if (!directory) {
    GTEST_SKIP() << "no polygon data: set GCV_DATA_DIR";
  }
  const std::vector<Jigsaw> jigsaws = read_jigsaws(*directory);
  Counts alone;
  Counts with_neighbours;
  for (const Jigsaw& jigsaw : jigsaws) {
    SCOPED_TRACE(jigsaw.name);
    const Puzzle puzzle = made(jigsaw);
    Solver solver(puzzle);
    solver.expect_no_overlap();
    solver.take_out_each(alone);
    for (const std::size_t neighbours : {1U, 3U}) {
      solver.take_out_neighbours(neighbours, with_neighbours);
    }
  }
  std::printf("%zu bins\n", jigsaws.size());
  alone.print("alone");
  with_neighbours.print("with neighbours");
  EXPECT_EQ(jigsaws.size(), 90U);
  EXPECT_GE(alone.all(), 1000U);
  EXPECT_EQ(alone.point, alone.all());
  EXPECT_EQ(alone.best, 3 * alone.all());
  EXPECT_GT(std::min({with_neighbours.ring, with_neighbours.segment, with_neighbours.point}), 0U);
}

// ---- Our own

TEST(Jigsaws, OfOurOwn) {
  constexpr double side = 20;
  std::mt19937_64 random(1);
  Puzzle puzzle{invariants::make({{0, 0}, {side, 0}, {side, side}, {0, side}}), {}, {}};
  for (const invariants::Polygon& piece : jigsaw_of(random, 20, 200)) {
    puzzle.pieces.push_back(invariants::make(piece));
    puzzle.places.push_back({0, 0});
  }
  EXPECT_EQ(puzzle.pieces.size(), 200U);
  Solver solver(puzzle);
  solver.expect_no_overlap();
  Counts alone;
  Counts with_neighbours;
  solver.take_out_each(alone);
  solver.take_out_neighbours(1, with_neighbours);
  alone.print("alone");
  with_neighbours.print("with neighbours");
  EXPECT_EQ(alone.point, alone.all());
  EXPECT_EQ(alone.best, 3 * alone.all());
}

}  // namespace
}  // namespace gcv::test
