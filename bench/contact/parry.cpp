// SPDX-License-Identifier: LGPL-3.0-or-later
#include "parry.hpp"

#include <memory>
#include <stdexcept>

#include "asker.hpp"

namespace gcv::bench {

namespace {

constexpr double most_vertex_pairs = 1e8;  // its triangulation takes quadratic time

struct DestroyShape {
  void operator()(parry_shape* shape) const { parry_shape_destroy(shape); }
};

struct Shapes {
  std::unique_ptr<parry_shape, DestroyShape> a;
  std::unique_ptr<parry_shape, DestroyShape> b;
  Placements placements;
};

std::unique_ptr<parry_shape, DestroyShape> to_shape(const Ring& ring) {
  parry_shape* const shape = parry_shape_create(&ring.data()->x, ring.size());
  if (shape == nullptr) {
    throw std::runtime_error("parry makes no shape");
  }
  return std::unique_ptr<parry_shape, DestroyShape>(shape);
}

template <class Put>
Asker asker(const char* name, Question question, Tells tells, Put put) {
  return {.name = name,
          .question = question,
          .prepare =
              [put](const Scene& s, const Placements& p) {
                const std::shared_ptr<Shapes> shapes(new Shapes{to_shape(s.a), to_shape(s.b), p});
                return [shapes, put](std::size_t first, std::size_t count, double* out) {
                  put(*shapes, first, count, out);
                };
              },
          .tells = tells,
          .most_vertex_pairs = most_vertex_pairs};
}

}  // namespace

std::vector<Asker> parry_askers() {
  return {asker("parry, intersection_test", Question::relation, Tells::apart_or_not,
                [](const Shapes& s, std::size_t first, std::size_t count, double* out) {
                  parry_relation(s.a.get(), s.b.get(), &s.placements.translations[first].x, count,
                                 out + first);
                }),
          asker("parry, distance", Question::distance, Tells::all_three,
                [](const Shapes& s, std::size_t first, std::size_t count, double* out) {
                  parry_distance(s.a.get(), s.b.get(), &s.placements.translations[first].x, count,
                                 out + first);
                }),
          asker("parry, cast_shapes", Question::cast, Tells::all_three,
                [](const Shapes& s, std::size_t first, std::size_t count, double* out) {
                  parry_cast(s.a.get(), s.b.get(), &s.placements.translations[first].x,
                             &s.placements.motions[first].x, count, out + first);
                })};
}

}  // namespace gcv::bench
