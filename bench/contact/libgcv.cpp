// SPDX-License-Identifier: LGPL-3.0-or-later
#include <gcv/gcv.h>

#include <cstdint>
#include <memory>

#include "asker.hpp"
#include "handle.hpp"

namespace gcv::bench {

namespace {

struct Prepared {
  Owned<gcv_polygon> a;
  Owned<gcv_polygon> b;
  Placements placements;
};

// put(prepared, first, count, out) is one call for many translations.
template <class Put>
Asker many_at_once(Question question, Put put) {
  return {.name = "libgcv", .question = question, .prepare = [put](const Scene& s, const auto& p) {
            const std::shared_ptr<Prepared> prepared(
                new Prepared{make_polygon(s.a), make_polygon(s.b), p});
            return [prepared, put](std::size_t first, std::size_t count, double* out) {
              put(*prepared, first, count, out);
            };
          }};
}

template <class Put>
Asker one_at_a_time(Question question, Put put) {
  return {.name = "libgcv, one at a time",
          .question = question,
          .prepare = [put](const Scene& s, const auto& p) {
            const std::shared_ptr<Prepared> prepared(
                new Prepared{make_polygon(s.a), make_polygon(s.b), p});
            return [prepared, put](std::size_t first, std::size_t count, double* out) {
              for (std::size_t k = first; k < first + count; ++k) {
                put(*prepared, k, 1, out);
              }
            };
          }};
}

// Both polygons made from doubles and ended for each question.
template <class Put>
Asker made_anew(Question question, Put put) {
  return {.name = "libgcv, polygons made anew",
          .question = question,
          .prepare = [put](const Scene& s, const auto& p) {
            const std::shared_ptr<Prepared> prepared(new Prepared{nullptr, nullptr, p});
            return [s, prepared, put](std::size_t first, std::size_t count, double* out) {
              for (std::size_t k = first; k < first + count; ++k) {
                prepared->a = make_polygon(s.a);
                prepared->b = make_polygon(s.b);
                put(*prepared, k, 1, out);
              }
            };
          }};
}

void put_relation(const Prepared& p, std::size_t first, std::size_t count, double* out) {
  thread_local std::vector<std::int8_t> found;
  found.resize(count);
  check(gcv_relation(p.a.get(), p.b.get(), &p.placements.translations[first].x, count, nullptr,
                     found.data()));
  for (std::size_t k = 0; k < count; ++k) {
    out[first + k] = found[k];
  }
}

void put_distance(const Prepared& p, std::size_t first, std::size_t count, double* out) {
  thread_local std::vector<gcv_separation> found;
  found.resize(count);
  check(gcv_distance(p.a.get(), p.b.get(), &p.placements.translations[first].x, count, nullptr,
                     found.data()));
  for (std::size_t k = 0; k < count; ++k) {
    out[first + k] = found[k].distance;
  }
}

void put_cast(const Prepared& p, std::size_t first, std::size_t count, double* out) {
  thread_local std::vector<gcv_impact> found;
  found.resize(count);
  check(gcv_cast(p.a.get(), p.b.get(), &p.placements.translations[first].x,
                 &p.placements.motions[first].x, count, nullptr, found.data()));
  for (std::size_t k = 0; k < count; ++k) {
    out[first + k] = found[k].time;
  }
}

template <class Put>
void add(std::vector<Asker>& askers, Question question, Put put) {
  askers.push_back(many_at_once(question, put));
  askers.push_back(one_at_a_time(question, put));
  askers.push_back(made_anew(question, put));
}

}  // namespace

std::vector<Asker> libgcv_askers() {
  std::vector<Asker> askers;
  add(askers, Question::relation, put_relation);
  add(askers, Question::distance, put_distance);
  add(askers, Question::cast, put_cast);
  return askers;
}

}  // namespace gcv::bench
