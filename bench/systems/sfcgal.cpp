// SPDX-License-Identifier: LGPL-3.0-or-later
#include "sfcgal.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>

#include "system.hpp"

namespace gcv::bench {

namespace {

std::array<char, 200> last_error;

int keep_error(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(last_error.data(), last_error.size(), format, arguments);
  va_end(arguments);
  return 0;
}

SfcgalGeometry checked(sfcgal_geometry_t* geometry) {
  if (geometry == nullptr) {
    throw std::runtime_error(last_error.data());
  }
  return {geometry, sfcgal_geometry_delete};
}

SfcgalGeometry to_sfcgal(const Ring& ring) {
  sfcgal_geometry_t* const line = sfcgal_linestring_create();
  for (std::size_t k = 0; k <= ring.size(); ++k) {
    const Point& p = ring[k % ring.size()];
    sfcgal_linestring_add_point(line, sfcgal_point_create_from_xy(p.x, p.y));
  }
  return checked(sfcgal_polygon_create_from_exterior_ring(line));
}

}  // namespace

PointVector sfcgal_ring(const sfcgal_geometry_t* line) {
  Ring ring;
  for (std::size_t k = 0; k + 1 < sfcgal_linestring_num_points(line); ++k) {
    const sfcgal_geometry_t* const p = sfcgal_linestring_point_n(line, k);
    ring.push_back({sfcgal_point_x(p), sfcgal_point_y(p)});
  }
  return ring;
}

SfcgalGeometry sfcgal_sum(const PointVector& a, const PointVector& b) {
  sfcgal_init();
  sfcgal_set_error_handlers(keep_error, keep_error);
  const SfcgalGeometry p = to_sfcgal(a);
  const SfcgalGeometry q = to_sfcgal(b);
  return checked(sfcgal_geometry_minkowski_sum(p.get(), q.get()));
}

// A sum of polygons is a multipolygon of one polygon.
Job sfcgal(const Ring& a, const Ring& b) {
  return {[&a, &b] {
    const SfcgalGeometry sum = sfcgal_sum(a, b);
    if (sfcgal_geometry_collection_num_geometries(sum.get()) != 1) {
      throw std::runtime_error("not one polygon");
    }
    return sfcgal_ring(
        sfcgal_polygon_exterior_ring(sfcgal_geometry_collection_geometry_n(sum.get(), 0)));
  }};
}

}  // namespace gcv::bench
