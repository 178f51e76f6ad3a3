// SPDX-License-Identifier: LGPL-3.0-or-later
#include "polygon.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <utility>

#include "area.hpp"
#include "curve_order.hpp"
#include "error.hpp"
#include "ring_nesting.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// Of messages about one ring of several.
class RingName {
 public:
  RingName(const char* polygon, std::size_t ring) {
    static_cast<void>(std::snprintf(text_, sizeof text_, "%.200s: ring %zu", polygon, ring));
  }
  [[nodiscard]] const char* text() const { return text_; }

 private:
  char text_[256];
};

PointVector mapped_vertices(const Boundary& ring, const AffineMap& map, const char* name) {
  PointVector vertices(ring.vertices.size());
  for (Index i = 0; i < ring.size(); ++i) {
    const Point image = mapped(map, ring.vertices[i]);
    if (!std::isfinite(image.x) || !std::isfinite(image.y)) {
      throw Error(Status::range, "%s: the %s coordinate of vertex %u is beyond the largest double",
                  name, std::isfinite(image.x) ? "y" : "x", ring.corners[i].vertex_number);
    }
    vertices[i] = image;
  }
  return vertices;
}

Boundary::Kind kind_of_ring(std::size_t k) {
  return k == 0 ? Boundary::Kind::outer : Boundary::Kind::hole;
}

// make(k, name) makes ring k, to be called by that name in messages.
template <class Make>
Polygon polygon_of(std::size_t ring_count, const char* name, Make make) {
  if (ring_count == 1) {
    return Polygon(make(0, name));
  }
  Polygon polygon(make(0, RingName(name, 0).text()));
  polygon.holes.reserve(ring_count - 1);
  Pace pace;
  for (std::size_t k = 1; k < ring_count; ++k) {
    polygon.holes.push_back(make(k, RingName(name, k).text()));
    pace.step(32 * std::uint64_t{polygon.holes.back().size()});
  }
  check_nesting(rings_of(polygon), name);
  return polygon;
}

// Those near each other in a row, whatever the caller's order: for the trees over their edges.
Boundary joined_in_order(const Boundary& outer, const std::vector<Boundary>& holes) {
  std::vector<const Boundary*> all;
  all.reserve(holes.size());
  for (const std::uint32_t k :
       order_for_tree(static_cast<std::uint32_t>(holes.size()),
                      [&](std::uint32_t hole) { return holes[hole].bounds; })) {
    all.push_back(&holes[k]);
  }
  return joined(outer, all);
}

}  // namespace

Polygon Polygon::reflected(std::shared_ptr<const Polygon> polygon) {
  const auto ring = [&polygon](std::size_t k) {
    return Boundary::reflected({polygon, &polygon->ring(k)});
  };
  Polygon result(ring(0));
  result.holes.reserve(polygon->holes.size());
  for (std::size_t k = 1; k < polygon->ring_count(); ++k) {
    result.holes.push_back(ring(k));
  }
  result.mirror_ = std::move(polygon);
  return result;
}

Boundary Polygon::all_rings() const {
  return mirror_ == nullptr ? joined_in_order(outer, holes)
                            : Boundary::reflected({mirror_, &mirror_->boundary()});
}

std::vector<const Boundary*> rings_of(const Polygon& polygon) {
  std::vector<const Boundary*> rings;
  rings.reserve(polygon.ring_count());
  for (std::size_t k = 0; k < polygon.ring_count(); ++k) {
    rings.push_back(&polygon.ring(k));
  }
  return rings;
}

Polygon make_polygon(std::vector<PointVector> boundaries, const char* name) {
  std::size_t first_number = 0;
  return polygon_of(boundaries.size(), name, [&](std::size_t k, const char* ring_name) {
    const CallersNumbers numbers{first_number, {}};
    first_number += boundaries[k].size();
    return make_ring(std::move(boundaries[k]), ring_name, kind_of_ring(k), numbers);
  });
}

Polygon mapped(const Polygon& polygon, const AffineMap& map, const char* name) {
  return polygon_of(polygon.ring_count(), name, [&](std::size_t k, const char* ring_name) {
    const Boundary& ring = polygon.ring(k);
    return make_ring(mapped_vertices(ring, map, ring_name), ring_name, kind_of_ring(k),
                     {0, ring.corners});
  });
}

double area_of(const Polygon& polygon) {
  return area_of(polygon.ring_count(), [&polygon](std::size_t k) {
    return std::span<const Point>(polygon.ring(k).vertices);
  });
}

}  // namespace gcv
