// SPDX-License-Identifier: LGPL-3.0-or-later
//
// gcv_polygon_*: polygons made, read and simplified.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "affine.hpp"
#include "disc.hpp"
#include "error.hpp"
#include "fill.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "polygon.hpp"
#include "simplification.hpp"
#include "wkt.hpp"

using gcv::Error;
using gcv::make_polygon;
using gcv::Point;
using gcv::PointVector;
using gcv::Status;
using gcv::capi::CallersFloatingPoint;
using gcv::capi::fill_points;
using gcv::capi::give_finite;
using gcv::capi::guarded;
using gcv::capi::new_polygon;
using gcv::capi::require;
using gcv::capi::require_count;

namespace {

// Reads boundaries one after the other from the caller's vertices.
class VertexReader {
 public:
  VertexReader(const double* xy, std::size_t stride)
      : next_(reinterpret_cast<const char*>(xy)), step_(stride == 0 ? sizeof(Point) : stride) {
    if (step_ < sizeof(Point)) {
      throw Error(Status::invalid_argument, "stride_bytes is %zu, neither 0 nor at least %zu",
                  stride, sizeof(Point));
    }
  }

  // The next so many vertices. `name`: what counts them.
  PointVector read(std::size_t count, const char* name) {
    PointVector points = peek(count, name);
    skip(count);
    return points;
  }
  // The same, which stay to be read.
  [[nodiscard]] PointVector peek(std::size_t count, const char* name) const {
    if (count > gcv::vertex_limit) {
      throw Error(Status::invalid_argument, "%s is %zu, at most %zu is possible", name, count,
                  gcv::vertex_limit);
    }
    if (!fits_memory(count)) {
      throw Error(Status::invalid_argument,
                  "%s is %zu: with stride_bytes %zu, that is more than memory can hold", name,
                  count, step_);
    }
    PointVector points(count);
    const char* next = next_;
    for (Point& point : points) {
      std::memcpy(&point, next, sizeof point);
      next += step_;
    }
    return points;
  }
  void skip(std::size_t count) { next_ += count * step_; }

  // Can there be so many vertices at all?
  [[nodiscard]] bool fits_memory(std::size_t count) const {
    return count <= std::size_t{PTRDIFF_MAX} / step_;
  }

 private:
  const char* next_;
  std::size_t step_;
};

std::vector<PointVector> read_rings(const double* xy, std::size_t stride, const size_t* sizes,
                                    std::size_t count) {
  require_count(count, sizeof *sizes, "ring_sizes");
  VertexReader reader(xy, stride);
  std::size_t vertices = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (sizes[k] > gcv::vertex_limit - vertices) {
      throw Error(Status::invalid_argument,
                  "ring_sizes: with ring %zu, there are more than %zu vertices", k,
                  gcv::vertex_limit);
    }
    vertices += sizes[k];
  }
  if (!reader.fits_memory(vertices)) {
    throw Error(Status::invalid_argument,
                "ring_sizes: with stride_bytes %zu, %zu vertices are more than memory can hold",
                stride, vertices);
  }
  std::vector<PointVector> rings;
  rings.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    rings.push_back(reader.read(sizes[k], "ring_sizes"));
  }
  return rings;
}

// Polygons behind more vertices than memory can hold are nowhere.
void check_sizes(const VertexReader& reader, const size_t* sizes, std::size_t count) {
  require_count(count, sizeof *sizes, "sizes");
  std::size_t vertices = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!reader.fits_memory(sizes[k]) || !reader.fits_memory(vertices += sizes[k])) {
      throw Error(Status::invalid_argument,
                  "sizes: with polygon %zu, there are more vertices than memory can hold", k);
    }
  }
}

// A polygon of many, or why there is none.
struct Made {
  std::unique_ptr<gcv_polygon> polygon;
  Status status = Status::ok;
};

// What is said of a polygon that has a number for its name.
const char* without_name(const char* message) {
  constexpr std::string_view name = "polygon: ";
  return std::string_view(message).starts_with(name) ? message + name.size() : message;
}

}  // namespace

gcv_polygon* gcv::capi::new_polygon(Polygon&& polygon) {
  return new gcv_polygon(std::make_shared<const gcv::Polygon>(std::move(polygon)));
}

gcv_polygon* gcv::capi::new_polygon(std::shared_ptr<const Polygon> polygon) {
  return new gcv_polygon(std::move(polygon));
}

gcv_status gcv_polygon_create(const double* xy, size_t vertex_count, size_t stride_bytes,
                              gcv_polygon** out) {
  return guarded([&] {
    require(xy, "xy");
    require(out, "out");
    *out = new_polygon(std::make_shared<const gcv::Polygon>(
        VertexReader(xy, stride_bytes).read(vertex_count, "vertex_count"), "polygon"));
  });
}

gcv_status gcv_polygon_create_rings(const double* xy, const size_t* ring_sizes, size_t ring_count,
                                    size_t stride_bytes, gcv_polygon** out) {
  return guarded([&] {
    require(xy, "xy");
    require(ring_sizes, "ring_sizes");
    require(out, "out");
    if (ring_count == 0) {
      throw Error(Status::degenerate, "polygon: ring_count is 0, an outer ring is needed");
    }
    *out =
        new_polygon(make_polygon(read_rings(xy, stride_bytes, ring_sizes, ring_count), "polygon"));
  });
}

gcv_status gcv_polygon_create_many(const double* xy, const size_t* sizes, size_t count,
                                   size_t stride_bytes, gcv_polygon** out, gcv_status* statuses) {
  return guarded([&] {
    if (count == 0) {
      return;
    }
    require(xy, "xy");
    require(sizes, "sizes");
    require(out, "out");
    require(statuses, "statuses");
    VertexReader reader(xy, stride_bytes);
    check_sizes(reader, sizes, count);
    std::vector<Made> made(count);
    std::optional<Error> first_failure;
    for (std::size_t k = 0; k < count; ++k) {
      try {
        made[k].polygon.reset(new_polygon(
            std::make_shared<const gcv::Polygon>(reader.peek(sizes[k], "size"), "polygon")));
      } catch (...) {
        const Error error = gcv::current_error();
        made[k].status = error.status();
        if (!first_failure) {
          first_failure.emplace(error.status(), "polygon %zu: %s", k, without_name(error.what()));
        }
      }
      reader.skip(sizes[k]);
    }
    if (first_failure) {
      static_cast<void>(gcv::capi::record(*first_failure));
    }
    for (std::size_t k = 0; k < count; ++k) {
      out[k] = made[k].polygon.release();
      statuses[k] = static_cast<gcv_status>(made[k].status);
    }
  });
}

gcv_status gcv_polygon_create_wkt(const char* text, size_t length, gcv_polygon** out) {
  return guarded([&] {
    require(text, "text");
    require(out, "out");
    require_count(length, 1, "length");
    *out = new_polygon(
        make_polygon(gcv::parse_polygon(std::string_view(text, length), "polygon"), "polygon"));
  });
}

gcv_status gcv_polygon_create_disc(const double centre[2], double radius, double tolerance,
                                   int32_t rounding, gcv_polygon** out) {
  return guarded([&] {
    require(centre, "centre");
    require(out, "out");
    *out = new_polygon(gcv::make_disc({centre[0], centre[1]}, radius, tolerance,
                                      gcv::capi::read_rounding(rounding, "")));
  });
}

gcv_status gcv_polygon_affine(const gcv_polygon* polygon, const double m[6], gcv_polygon** out) {
  return guarded([&] {
    require(polygon, "polygon");
    require(m, "m");
    require(out, "out");
    for (std::size_t k = 0; k < 6; ++k) {
      if (!std::isfinite(m[k])) {
        throw Error(Status::not_finite, "m[%zu] is %g, not a finite number", k, m[k]);
      }
    }
    const gcv::AffineMap map{m[0], m[1], m[2], m[3], m[4], m[5]};
    *out = new_polygon(mapped(*polygon->polygon, map, "the mapped polygon"));
  });
}

void gcv_polygon_destroy(gcv_polygon* polygon) { delete polygon; }

gcv_status gcv_polygon_vertex_count(const gcv_polygon* polygon, size_t* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(polygon, "polygon");
    require(out, "out");
    *out = polygon->polygon->outer.vertices.size();
  });
}

gcv_status gcv_polygon_vertices(const gcv_polygon* polygon, double* xy, size_t capacity,
                                size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(polygon, "polygon");
    fill_points(polygon->polygon->outer.vertices, xy, capacity, required);
  });
}

gcv_status gcv_polygon_ring_count(const gcv_polygon* polygon, size_t* out) {
  return guarded<CallersFloatingPoint>([&] {
    require(polygon, "polygon");
    require(out, "out");
    *out = polygon->polygon->ring_count();
  });
}

gcv_status gcv_polygon_ring(const gcv_polygon* polygon, size_t ring, double* xy, size_t capacity,
                            size_t* required) {
  return guarded<CallersFloatingPoint>([&] {
    require(polygon, "polygon");
    if (ring >= polygon->polygon->ring_count()) {
      throw Error(Status::invalid_argument, "ring is %zu, the polygon has %zu rings", ring,
                  polygon->polygon->ring_count());
    }
    fill_points(polygon->polygon->ring(ring).vertices, xy, capacity, required);
  });
}

gcv_status gcv_polygon_area(const gcv_polygon* polygon, double* out) {
  return guarded([&] {
    require(polygon, "polygon");
    require(out, "out");
    give_finite(gcv::area_of(*polygon->polygon), "the area of the polygon", out);
  });
}

gcv_status gcv_polygon_bounds(const gcv_polygon* polygon, double out[4]) {
  return guarded<CallersFloatingPoint>([&] {
    require(polygon, "polygon");
    require(out, "out");
    const gcv::Box& box = polygon->polygon->outer.bounds;
    out[0] = box.x0;
    out[1] = box.y0;
    out[2] = box.x1;
    out[3] = box.y1;
  });
}

gcv_status gcv_polygon_simplified(const gcv_polygon* polygon, double tolerance, int32_t rounding,
                                  gcv_polygon** out, double* error_bound) {
  return guarded([&] {
    require(polygon, "polygon");
    require(out, "out");
    require(error_bound, "error_bound");
    gcv::capi::check_tolerance(tolerance, "");
    gcv::SimplifiedPolygon near =
        gcv::simplify(polygon->polygon, tolerance, gcv::capi::read_rounding(rounding, ""),
                      polygon->polygon->outer.size() - 1);
    *out = new gcv_polygon(std::move(near.polygon));
    *error_bound = near.error_bound;
  });
}
