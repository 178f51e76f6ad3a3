// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> two polygons with holes, on a small grid full of ties -> the region of their sum, or the
// inner fit of one in the other. The exact parts must be those of the definition, as text.
#include <array>
#include <string>
#include <vector>

#include "../reference/region_reference.hpp"
#include "fuzz.hpp"
#include "grid_polygons.hpp"

namespace {

using gcv::Point;
using gcv::PointVector;
using gcv::fuzz::check;
using gcv::fuzz::Input;
using gcv::fuzz::succeeds;
using gcv::reference::Rings;
using Handle = gcv::fuzz::Polygon;
using Region = std::unique_ptr<gcv_region, gcv::fuzz::Destroy>;

Rings read_polygon(Input& input) {
  Rings rings;
  for (const gcv::fuzz::Ring& ring : gcv::fuzz::read_grid_polygon(input)) {
    PointVector& points = rings.emplace_back();
    for (const auto& [x, y] : ring) {
      points.push_back({x, y});
    }
  }
  return rings;
}

// -------------------------------------------------------------------------- oracle --

std::string text(const Rings& rings) {
  std::string result;
  for (const PointVector& ring : rings) {
    result += "\n  ring";
    for (const Point& p : ring) {
      for (const double x : {p.x, p.y}) {
        result += ' ';
        result += std::to_string(static_cast<int>(x));
      }
    }
  }
  return result;
}

// NULL where it is refused.
Handle make(const Rings& rings) {
  std::vector<double> xy;
  std::vector<std::size_t> sizes;
  for (const PointVector& ring : rings) {
    sizes.push_back(ring.size());
    for (const Point& p : ring) {
      xy.insert(xy.end(), {p.x, p.y});
    }
  }
  gcv_polygon* polygon = nullptr;
  succeeds("gcv_polygon_create_rings",
           gcv_polygon_create_rings(xy.data(), sizes.data(), sizes.size(), 0, &polygon),
           {GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE});
  return Handle(polygon);
}

// The exact parts, as the reference has them.
std::string text(const gcv_region* region) {
  constexpr const char* names[] = {"outer", "hole", "segment", "point"};
  std::size_t count = 0;
  succeeds("gcv_region_exact_parts", gcv_region_exact_parts(region, nullptr, 0, &count));
  std::vector<gcv_region_part> parts(count + 1);
  succeeds("gcv_region_exact_parts", gcv_region_exact_parts(region, parts.data(), count, &count));
  parts.pop_back();
  std::string result;
  std::size_t vertex = 0;
  for (const gcv_region_part& part : parts) {
    result += names[part.kind - 1];
    if (part.kind <= GCV_PART_HOLE) {
      result += ' ';
      result += std::to_string(part.polygon);
    }
    for (std::uint64_t k = 0; k < part.vertex_count; ++k, ++vertex) {
      std::size_t length = 0;
      const char* const name = "gcv_region_exact_vertex";
      succeeds(name, gcv_region_exact_vertex(region, vertex, nullptr, 0, &length));
      std::string point(length, ' ');
      succeeds(name, gcv_region_exact_vertex(region, vertex, point.data(), length, &length));
      point.pop_back();
      result += k == 0 ? ": " : ", ";
      result += point;
    }
    result += "\n";
  }
  return result;
}

void check_case(const Rings& a, const Rings& b, bool is_fit, const Point& reference) {
  const Handle handle_a = make(a);
  const Handle handle_b = make(b);
  if (!handle_a || !handle_b) {
    return;
  }
  Rings reflected = b;
  for (PointVector& ring : reflected) {
    for (Point& p : ring) {
      p = {0 - p.x, 0 - p.y};
    }
  }
  const std::string expected =
      gcv::reference::text(is_fit ? gcv::reference::inner_fit_region(a, b, reference)
                                  : gcv::reference::sum_region(a, reflected, reference));
  const std::string where = "\na:" + text(a) + "\nb:" + text(b) + "\nexpected:\n" + expected;
  const std::array<double, 2> point{reference.x, reference.y};
  const auto function = is_fit ? gcv_inner_fit_region : gcv_no_fit_region;
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    gcv_options options = GCV_OPTIONS_INIT;
    options.rounding = rounding;
    gcv_region* region = nullptr;
    const gcv_status status =
        function(handle_a.get(), handle_b.get(), point.data(), &options, &region);
    const Region owner(region);
    check(status == GCV_OK, std::string("no region: ") + gcv_status_name(status) + where);
    const std::string found = text(region);
    check(found == expected,
          (is_fit ? "inner fit:\n" : "no-fit region:\n") + found + "is not right" + where);
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const auto what = input.take<std::uint8_t>();
  const Rings a = read_polygon(input);
  const Rings b = read_polygon(input);
  const Point reference{static_cast<double>(what / 4 % 4), (what & 16U) == 0 ? 0.0 : 0.1};
  check_case(a, b, (what & 1U) != 0, reference);
  return 0;
}
