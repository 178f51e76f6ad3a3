// SPDX-License-Identifier: LGPL-3.0-or-later
#include <geos_c.h>

#include <memory>
#include <stdexcept>

#include "asker.hpp"

namespace gcv::bench {

namespace {

GEOSContextHandle_t context() {
  static const GEOSContextHandle_t handle = GEOS_init_r();
  return handle;
}

struct DestroyGeometry {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context(), geometry); }
  void operator()(const GEOSPreparedGeometry* prepared) const {
    GEOSPreparedGeom_destroy_r(context(), prepared);
  }
};
using Geometry = std::unique_ptr<GEOSGeometry, DestroyGeometry>;
using PreparedGeometry = std::unique_ptr<const GEOSPreparedGeometry, DestroyGeometry>;

template <class Pointer>
Pointer made(Pointer pointer) {
  if (pointer == nullptr) {
    throw std::runtime_error("GEOS makes no geometry");
  }
  return pointer;
}

Geometry to_polygon(const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* const sequence = made(GEOSCoordSeq_create_r(context(), size + 1, 2));
  for (unsigned k = 0; k <= size; ++k) {
    const Point& p = ring[k % size];
    GEOSCoordSeq_setXY_r(context(), sequence, k, p.x, p.y);
  }
  GEOSGeometry* const line = made(GEOSGeom_createLinearRing_r(context(), sequence));
  return Geometry(made(GEOSGeom_createPolygon_r(context(), line, nullptr, 0)));
}

bool is_true(char answer) {
  constexpr char exception = 2;
  if (answer == exception) {
    throw std::runtime_error("GEOS gives no answer");
  }
  return answer == 1;
}

void require(int done) {
  if (done == 0) {
    throw std::runtime_error("GEOS gives no distance");
  }
}

struct Geometries {
  Scene scene;
  Placements placements;
  Geometry a;
  PreparedGeometry prepared;
  std::vector<Geometry> b;
};

// answer(geometries, k) is the answer to question k.
template <class Answer>
Asker asker(const char* name, Question question, Tells tells, Answer answer) {
  return {.name = name,
          .question = question,
          .prepare =
              [answer](const Scene& s, const Placements& p) {
                const auto all = std::make_shared<Geometries>();
                all->scene = s;
                all->placements = p;
                all->a = to_polygon(s.a);
                all->prepared.reset(made(GEOSPrepare_r(context(), all->a.get())));
                all->b = moved_and_made(s, p, to_polygon);
                return [all, answer](std::size_t first, std::size_t count, double* out) {
                  for (std::size_t k = first; k < first + count; ++k) {
                    out[k] = answer(*all, k);
                  }
                };
              },
          .tells = tells,
          .is_given_rounded = true};
}

double apart_or_not(const Geometries& all, std::size_t k) {
  return is_true(GEOSPreparedIntersects_r(context(), all.prepared.get(), all.b[k].get())) ? 0 : 1;
}

double relation(const Geometries& all, std::size_t k) {
  if (apart_or_not(all, k) == 1) {
    return 1;
  }
  return is_true(GEOSPreparedTouches_r(context(), all.prepared.get(), all.b[k].get())) ? 0 : -1;
}

double prepared_distance(const Geometries& all, std::size_t k) {
  double distance = 0;
  require(GEOSPreparedDistance_r(context(), all.prepared.get(), all.b[k].get(), &distance));
  return distance;
}

double indexed_distance(const Geometries& all, std::size_t k) {
  double distance = 0;
  require(GEOSDistanceIndexed_r(context(), all.a.get(), all.b[k].get(), &distance));
  return distance;
}

// Both polygons made from doubles for each question, and B moved.
double apart_or_not_anew(const Geometries& all, std::size_t k) {
  const Geometry a = to_polygon(all.scene.a);
  const Geometry b = to_polygon(rounded_at(all.scene.b, all.placements.translations[k]));
  return is_true(GEOSIntersects_r(context(), a.get(), b.get())) ? 0 : 1;
}

double indexed_distance_anew(const Geometries& all, std::size_t k) {
  const Geometry a = to_polygon(all.scene.a);
  const Geometry b = to_polygon(rounded_at(all.scene.b, all.placements.translations[k]));
  double distance = 0;
  require(GEOSDistanceIndexed_r(context(), a.get(), b.get(), &distance));
  return distance;
}

}  // namespace

std::vector<Asker> geos_askers() {
  return {asker("GEOS prepared, intersects and touches", Question::relation, Tells::all_three,
                relation),
          asker("GEOS prepared, intersects alone", Question::relation, Tells::apart_or_not,
                apart_or_not),
          asker("GEOS intersects, polygons made anew", Question::relation, Tells::apart_or_not,
                apart_or_not_anew),
          asker("GEOS prepared distance", Question::distance, Tells::all_three, prepared_distance),
          asker("GEOS indexed distance", Question::distance, Tells::all_three, indexed_distance),
          asker("GEOS indexed distance, polygons made anew", Question::distance, Tells::all_three,
                indexed_distance_anew)};
}

}  // namespace gcv::bench
