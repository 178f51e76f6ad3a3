// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Bytes -> two polygons of few vertices -> sum, no-fit polygon and entrance block, with both
// roundings, and within a tolerance. What is valid must be accepted, and the invariants of sums
// and of simplified polygons must hold.
#include <cmath>
#include <limits>
#include <vector>

#include "../support/invariants.hpp"
#include "fuzz.hpp"
#include "placement.hpp"

namespace {

using gcv::fuzz::add_ulps;
using gcv::fuzz::check;
using gcv::fuzz::Input;
using gcv::fuzz::Placement;
using gcv::fuzz::succeeds;
using gcv::invariants::is_simple;
using gcv::invariants::Point;
using gcv::invariants::wkt;
using Handle = gcv::fuzz::Polygon;
using Ring = gcv::invariants::Polygon;

// ------------------------------------------------------------------------- decoding --

constexpr std::size_t most_vertices = 8;

struct GridPoint {
  int x;
  int y;
};

int cross(const GridPoint& p, const GridPoint& q) { return p.x * q.y - p.y * q.x; }

std::vector<GridPoint> grid_points(Input& input) {
  std::vector<GridPoint> points(3 + input.below(most_vertices - 2));
  for (GridPoint& p : points) {
    p.x = input.take<std::int8_t>();
    p.y = input.take<std::int8_t>();
  }
  return points;
}

// The points by their angles round the origin, one for each angle, and with the origin where
// the ring would not go round it: a ring without crossings.
std::vector<GridPoint> star(std::vector<GridPoint> points) {
  const auto is_upper = [](const GridPoint& p) { return p.y > 0 || (p.y == 0 && p.x > 0); };
  const auto before = [&](const GridPoint& p, const GridPoint& q) {
    return is_upper(p) != is_upper(q) ? is_upper(p) : cross(p, q) > 0;
  };
  std::erase_if(points, [](const GridPoint& p) { return p.x == 0 && p.y == 0; });
  std::sort(points.begin(), points.end(), before);
  const auto same_angle = [&](const GridPoint& p, const GridPoint& q) { return !before(p, q); };
  points.erase(std::unique(points.begin(), points.end(), same_angle), points.end());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (cross(points[k], points[(k + 1) % points.size()]) <= 0) {
      points.insert(points.begin() + static_cast<std::ptrdiff_t>(k) + 1, {0, 0});
      break;
    }
  }
  return points;
}

// Columns of all heights on bases of all depths.
std::vector<GridPoint> comb(Input& input) {
  std::vector<GridPoint> top;
  std::vector<GridPoint> bottom;
  int x = 0;
  for (std::size_t columns = 1 + input.below(most_vertices / 2); columns > 0; --columns) {
    const int right = x + 1 + static_cast<int>(input.below(4));
    const int height = static_cast<int>(input.below(16));
    const int depth = -1 - static_cast<int>(input.below(16));
    top.insert(top.end(), {{x, height}, {right, height}});
    bottom.insert(bottom.end(), {{x, depth}, {right, depth}});
    x = right;
  }
  bottom.insert(bottom.end(), top.rbegin(), top.rend());
  return bottom;
}

// The first byte says how the polygon is made. `placement` is that of the polygon before,
// and can be used again.
Ring read_ring(Input& input, Placement& placement) {
  enum { raw, integers, star_shaped, columns };
  const auto how = input.take<std::uint8_t>();
  const int shape = how & 3;
  if (shape == raw) {
    Ring ring(input.below(most_vertices + 1));
    for (Point& p : ring) {
      p = input.take<Point>();
    }
    return ring;
  }
  if ((how & 4) == 0) {
    placement = Placement::read(input, how & 8, how & 16, how & 32);
  }
  const std::vector<GridPoint> points = shape == integers      ? grid_points(input)
                                        : shape == star_shaped ? star(grid_points(input))
                                                               : comb(input);
  Ring ring;
  for (const GridPoint& p : points) {
    ring.push_back(placement(p.x, p.y));
    if ((how & 64) != 0) {
      add_ulps(input, ring.back()[0]);
      add_ulps(input, ring.back()[1]);
    }
  }
  return ring;
}

// --------------------------------------------------------------------------- oracles --

bool is_finite(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(),
                     [](const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); });
}

void check_ring(bool holds, const char* sentence, const Ring& ring) {
  if (!holds) {
    gcv::fuzz::fail(std::string(sentence) + ": " + (ring.empty() ? "" : wkt(ring)));
  }
}

// NULL where it is refused, and rightly.
Handle make(const Ring& ring) {
  const double nothing = 0;
  gcv_polygon* polygon = nullptr;
  const gcv_status status =
      gcv_polygon_create(ring.empty() ? &nothing : ring.front().data(), ring.size(), 0, &polygon);
  const bool made = succeeds("gcv_polygon_create", status,
                             {GCV_ERR_NOT_FINITE, GCV_ERR_DEGENERATE, GCV_ERR_NOT_SIMPLE});
  check_ring((status == GCV_ERR_NOT_FINITE) != is_finite(ring), "finite or not", ring);
  check_ring(made || !is_finite(ring) || !is_simple(ring), "a simple ring is refused", ring);
  return Handle(polygon);
}

void check_corners(const gcv_polygon* polygon) {
  Ring ring(2 * most_vertices);
  std::size_t count = 0;
  succeeds("gcv_polygon_vertices",
           gcv_polygon_vertices(polygon, ring.front().data(), ring.size(), &count));
  ring.resize(count);
  check_ring(is_simple(ring), "a ring is accepted that is not simple", ring);
}

double largest_coordinate(const Ring& ring) {
  double largest = 0;
  for (const Point& p : ring) {
    largest = std::max({largest, std::abs(p[0]), std::abs(p[1])});
  }
  return largest;
}

// Can the sum be beyond all doubles, or so small beside its place in the plane that it has
// no area in doubles?
bool may_be_out_of_range(const Ring& a, const Ring& b) {
  using Limits = std::numeric_limits<double>;
  for (const std::size_t axis : {0U, 1U}) {
    const auto less = [&](const Point& p, const Point& q) { return p[axis] < q[axis]; };
    const auto [a_low, a_high] = std::minmax_element(a.begin(), a.end(), less);
    const auto [b_low, b_high] = std::minmax_element(b.begin(), b.end(), less);
    const double low = (*a_low)[axis] / 4 + (*b_low)[axis] / 4;
    const double high = (*a_high)[axis] / 4 + (*b_high)[axis] / 4;
    const double size = std::max(std::abs(low), std::abs(high));
    if (size > Limits::max() / 8 ||
        high - low < 8 * std::max(Limits::denorm_min(), size * Limits::epsilon())) {
      return true;
    }
  }
  return false;
}

// All of an outer face as text.
std::string description(const gcv_outer_face* face) {
  double bound = 0;
  std::size_t count = 0;
  std::size_t length = 0;
  succeeds("gcv_outer_face_error_bound", gcv_outer_face_error_bound(face, &bound));
  succeeds("gcv_outer_face_exact_vertex_count", gcv_outer_face_exact_vertex_count(face, &count));
  succeeds("gcv_outer_face_wkt", gcv_outer_face_wkt(face, nullptr, 0, &length));
  std::string text(length, ' ');
  succeeds("gcv_outer_face_wkt", gcv_outer_face_wkt(face, text.data(), length, &length));
  text.append(reinterpret_cast<const char*>(&bound), sizeof bound);
  for (std::size_t k = 0; k < count; ++k) {
    const char* const name = "gcv_outer_face_exact_vertex";
    succeeds(name, gcv_outer_face_exact_vertex(face, k, nullptr, 0, &length));
    std::string vertex(length, ' ');
    succeeds(name, gcv_outer_face_exact_vertex(face, k, vertex.data(), length, &length));
    text += vertex;
  }
  return text;
}

Ring reflected(Ring ring) {
  for (Point& p : ring) {
    p = {-p[0], -p[1]};
  }
  return ring;
}

// Calls call(&out), which may give one of the other statuses: the outer face as text, or the
// name of the status.
template <class Call>
std::string outcome(const char* name, std::initializer_list<gcv_status> others, Call call) {
  gcv_outer_face* out = nullptr;
  const gcv_status status = call(&out);
  const gcv::fuzz::OuterFace face(out);
  return succeeds(name, status, others) ? description(out) : gcv_status_name(status);
}

void check_pair(const Ring& a, const Ring& b, const Point& reference, int exponent) {
  const Handle handle_a = make(a);
  const Handle handle_b = make(b);
  if (!handle_a || !handle_b) {
    return;
  }
  check_corners(handle_a.get());
  check_corners(handle_b.get());
  const Handle minus_a = make(reflected(a));
  const Handle minus_b = make(reflected(b));
  const Point origin{};
  const std::string where = "\n  a: " + wkt(a) + "\n  b: " + wkt(b);
  for (const std::int32_t rounding : {GCV_ROUND_NEAREST, GCV_ROUND_OUTWARD}) {
    gcv_options options = GCV_OPTIONS_INIT;
    options.rounding = rounding;
    const auto sum = [&](const Handle& p, const Handle& q) {
      return outcome("gcv_minkowski_sum", {GCV_ERR_RANGE}, [&](gcv_outer_face** out) {
        return gcv_minkowski_sum(p.get(), q.get(), &options, out);
      });
    };
    const auto no_fit = [&](const Point& point, gcv_status other) {
      return outcome("gcv_no_fit_polygon", {GCV_ERR_RANGE, other}, [&](gcv_outer_face** out) {
        return gcv_no_fit_polygon(handle_a.get(), handle_b.get(), point.data(), &options, out);
      });
    };
    const auto entrance = [&](const Point& point, gcv_status other) {
      return outcome("gcv_entrance_block", {GCV_ERR_RANGE, other}, [&](gcv_outer_face** out) {
        return gcv_entrance_block(handle_a.get(), handle_b.get(), point.data(), &options, out);
      });
    };
    check(no_fit(origin, GCV_OK) == sum(handle_a, minus_b), "no-fit polygon is not a - b" + where);
    check(entrance(origin, GCV_OK) == sum(minus_a, handle_b),
          "entrance block is not b - a" + where);
    const gcv_status other = is_finite({reference}) ? GCV_OK : GCV_ERR_NOT_FINITE;
    no_fit(reference, other);
    entrance(reference, other);
  }
  gcv::invariants::Effort effort;
  effort.work = 1000;
  effort.may_be_out_of_range = may_be_out_of_range(a, b);
  const auto expect_none = [&](const std::vector<std::string>& sentences) {
    for (const std::string& sentence : sentences) {
      gcv::fuzz::fail(sentence + where);
    }
  };
  expect_none(gcv::invariants::broken_invariants(a, b, effort));
  const double tolerance = std::ldexp(largest_coordinate(a), exponent);
  expect_none(gcv::invariants::broken_simplification(a, tolerance, effort));
  if (!effort.may_be_out_of_range) {
    expect_none(gcv::invariants::broken_sum_within(a, b, tolerance, effort));
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  Placement placement;
  const Ring a = read_ring(input, placement);
  const Ring b = read_ring(input, placement);
  const auto reference = input.take<Point>();
  check_pair(a, b, reference, -static_cast<int>(input.below(64)));
  return 0;
}
