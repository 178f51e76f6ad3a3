// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What must hold of free regions, best positions and ways out in scenes, by the relation alone.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "question_pair.hpp"

namespace gcv::fuzz {

using RegionHandle = std::unique_ptr<gcv_region, invariants::Destroy>;

// What is asked where a polygon is free.
struct FreeQuestions {
  const gcv_scene* scene;
  const gcv_polygon* moving;
  const gcv_query* query;
  bool is_bounded;  // by a container
  std::string where;

  [[nodiscard]] std::int8_t relation(const Point& position) const {
    std::int8_t result = 77;
    succeeds("gcv_scene_relation",
             gcv_scene_relation(scene, moving, position.data(), 1, query, nullptr, &result));
    return result;
  }

  // The region in a window, or all of it. Nothing where it is out of range.
  [[nodiscard]] RegionHandle region(const double* window) const {
    gcv_region* out = nullptr;
    succeeds("gcv_scene_free_region",
             gcv_scene_free_region(scene, moving, window, query, nullptr, &out), {GCV_ERR_RANGE});
    return RegionHandle(out);
  }

  // In the interior of the region the polygon is apart from all, on its boundary it touches,
  // outside of it it overlaps; but for the border of the window, and what lies outside of that.
  void check_place(const gcv_region* region, const double* window, const Point& place) const {
    const std::array<double, 4> everywhere{-HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL};
    const double* const w = window == nullptr ? everywhere.data() : window;
    const bool is_in = place[0] > w[0] && place[0] < w[2] && place[1] > w[1] && place[1] < w[3];
    const bool is_out = place[0] < w[0] || place[0] > w[2] || place[1] < w[1] || place[1] > w[3];
    std::int8_t located = 77;
    succeeds("gcv_region_locate", gcv_region_locate(region, place.data(), 1, &located));
    const std::int8_t there = relation(place);
    const bool holds = there == GCV_OVERLAPPING || is_out ? located == GCV_OUTSIDE
                       : !is_in                           ? located != GCV_INSIDE
                       : there == GCV_TOUCHING            ? located == GCV_BOUNDARY
                                                          : located == GCV_INSIDE;
    check(holds, "located " + std::to_string(located) + ", relation " + std::to_string(there) +
                     " at " + text_of(place) + where);
  }

  void check_region(const double* window, const std::vector<Point>& places) const {
    const RegionHandle found = region(window);
    if (found == nullptr) {
      return;
    }
    for (const Point& place : places) {
      check_place(found.get(), window, place);
    }
    for (const Point& vertex : vertices(found.get())) {
      check_place(found.get(), window, vertex);
    }
  }

  // A best position is free, or its place has no free double near; there is one where something is
  // free.
  void check_best(const Point& direction) const {
    Point position{77, 77};
    std::int32_t is_found = 77;
    const gcv_status status =
        gcv_scene_best(scene, moving, direction.data(), query, nullptr, position.data(), &is_found);
    if (!is_bounded || direction == Point{0, 0}) {
      check(status == GCV_ERR_INVALID_ARGUMENT, "a best position that is not bounded" + where);
      return;
    }
    if (!succeeds("gcv_scene_best", status, {GCV_ERR_RANGE})) {
      return;
    }
    const RegionHandle whole = region(nullptr);
    if (whole == nullptr) {
      return;
    }
    std::size_t parts = 0;
    succeeds("gcv_region_exact_parts", gcv_region_exact_parts(whole.get(), nullptr, 0, &parts),
             {GCV_ERR_BUFFER_TOO_SMALL});
    check((is_found == 1) == (parts > 0), "found where nothing is free, or the reverse" + where);
    check(is_found == 1 || position == Point{0, 0}, "a position of nothing" + where);
    for (const Point& vertex : vertices(whole.get())) {
      const long double further = dot(vertex, direction) - dot(position, direction);
      check(further <= length(direction) * slack(whole.get(), {position, vertex}),
            text_of(vertex) + " is further than " + text_of(position) + where);
    }
  }

  void check_way_out(const Point& position) const {
    gcv_escape escape{};
    const gcv_status status =
        gcv_scene_penetration(scene, moving, position.data(), 1, query, nullptr, &escape);
    if (!succeeds("gcv_scene_penetration", status, {GCV_ERR_RANGE})) {
      return;
    }
    const Point there{escape.position[0], escape.position[1]};
    check(escape.relation == relation(there), "another relation at the way out" + where);
    const bool overlaps = relation(position) == GCV_OVERLAPPING;
    check(overlaps || (escape.depth == 0 && there == position), "out of nothing" + where);
    check(
        !overlaps || escape.depth > 0 || (escape.translation[0] == 0 && escape.translation[1] == 0),
        "an overlap without a depth" + where);
    const RegionHandle whole = is_bounded ? region(nullptr) : nullptr;
    if (whole == nullptr) {
      return;
    }
    for (const Point& vertex : vertices(whole.get())) {
      const long double nearest = length({vertex[0] - position[0], vertex[1] - position[1]});
      check(escape.depth <= nearest + slack(whole.get(), {position, vertex}),
            text_of(vertex) + " is nearer than the way out" + where);
    }
  }

 private:
  static long double dot(const Point& a, const Point& b) {
    return static_cast<long double>(a[0]) * b[0] + static_cast<long double>(a[1]) * b[1];
  }

  static long double length(const Point& a) { return std::sqrt(dot(a, a)); }

  // What rounding moves the vertices of a region by, and what rounding of depths and this test's
  // own arithmetic do.
  static long double slack(const gcv_region* region, const std::array<Point, 2>& points) {
    double bound = 0;
    succeeds("gcv_region_error_bound", gcv_region_error_bound(region, &bound));
    long double size = 0;
    for (const Point& point : points) {
      size = std::max(size, length(point));
    }
    return bound + 0x1p-30L * size + 0x1p-1074L;
  }

  static std::vector<Point> vertices(const gcv_region* region) {
    std::size_t count = 0;
    succeeds("gcv_region_vertices", gcv_region_vertices(region, nullptr, 0, &count),
             {GCV_ERR_BUFFER_TOO_SMALL});
    std::vector<Point> result(count);
    if (count > 0) {
      succeeds("gcv_region_vertices",
               gcv_region_vertices(region, result.front().data(), count, &count));
    }
    return result;
  }
};

}  // namespace gcv::fuzz
