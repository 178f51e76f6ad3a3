// SPDX-License-Identifier: LGPL-3.0-or-later
#include <geos_c.h>

#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "whole.hpp"

namespace gcv::bench {

namespace {

struct Destroy {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy(geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

std::array<char, 200> last_error;

void keep_error(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(last_error.data(), last_error.size(), format, arguments);
  va_end(arguments);
}

GEOSGeometry* checked(GEOSGeometry* geometry) {
  if (geometry == nullptr) {
    throw std::runtime_error(last_error.data());
  }
  return geometry;
}

GEOSGeometry* to_polygon(const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* const sequence = GEOSCoordSeq_create(size + 1, 2);
  for (unsigned k = 0; k <= size; ++k) {
    const Point& p = ring[k % size];
    GEOSCoordSeq_setXY(sequence, k, p.x, p.y);
  }
  return checked(GEOSGeom_createPolygon(checked(GEOSGeom_createLinearRing(sequence)), nullptr, 0));
}

Point sum(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }

Ring translated(Ring ring, const Point& by) {
  for (Point& p : ring) {
    p = sum(p, by);
  }
  return ring;
}

// Is there no parallelogram, but for roundings?
bool are_parallel(const Point& p0, const Point& p1, const Point& q0, const Point& q1) {
  return (p1.x - p0.x) * (q1.y - q0.y) == (p1.y - p0.y) * (q1.x - q0.x);
}

Geometry parts_of(const Ring& a, const Ring& b) {
  std::vector<GEOSGeometry*> parts{to_polygon(translated(a, b[0])),
                                   to_polygon(translated(b, a[0]))};
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point& p0 = a[i];
    const Point& p1 = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point& q0 = b[j];
      const Point& q1 = b[(j + 1) % b.size()];
      if (!are_parallel(p0, p1, q0, q1)) {
        parts.push_back(to_polygon({sum(p0, q0), sum(p1, q0), sum(p1, q1), sum(p0, q1)}));
      }
    }
  }
  return Geometry(checked(GEOSGeom_createCollection(GEOS_MULTIPOLYGON, parts.data(),
                                                    static_cast<unsigned>(parts.size()))));
}

Ring to_ring(const GEOSGeometry* line) {
  const GEOSCoordSequence* const sequence = GEOSGeom_getCoordSeq(line);
  unsigned size = 0;
  GEOSCoordSeq_getSize(sequence, &size);
  Ring ring;
  for (unsigned k = 0; k + 1 < size; ++k) {
    Point p{};
    GEOSCoordSeq_getXY(sequence, k, &p.x, &p.y);
    ring.push_back(p);
  }
  return ring;
}

}  // namespace

WholeInDoubles geos_whole(const Ring& a, const Ring& b) {
  initGEOS(keep_error, keep_error);
  const Geometry parts = parts_of(a, b);
  const Geometry united(checked(GEOSUnaryUnion(parts.get())));
  WholeInDoubles whole;
  for (int k = 0; k < GEOSGetNumGeometries(united.get()); ++k) {
    const GEOSGeometry* const polygon = GEOSGetGeometryN(united.get(), k);
    if (GEOSGeomTypeId(polygon) != GEOS_POLYGON) {
      continue;
    }
    whole.outer.push_back(to_ring(GEOSGetExteriorRing(polygon)));
    for (int hole = 0; hole < GEOSGetNumInteriorRings(polygon); ++hole) {
      whole.holes.push_back(to_ring(GEOSGetInteriorRingN(polygon, hole)));
    }
  }
  return whole;
}

}  // namespace gcv::bench
