// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about two polygons: gcv_relation, gcv_distance, gcv_cast.
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "cast.hpp"
#include "distance.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "parallel.hpp"
#include "polygon_pair.hpp"
#include "relation.hpp"
#include "task.hpp"

namespace {

using gcv::Error;
using gcv::PlacedPair;
using gcv::Point;
using gcv::PolygonPair;
using gcv::Status;
using gcv::Tally;
using gcv::Task;
using gcv::capi::guarded;
using gcv::capi::read_options;
using gcv::capi::require;
using gcv::capi::threads_of;

// `count` vectors of the caller: x0 y0 x1 y1 ...
class Vectors {
 public:
  // Throws Error: not_finite, with the name and the number of the vector.
  Vectors(const double* xy, std::size_t count, const char* name) : xy_(xy) {
    for (std::size_t k = 0; k < count; ++k) {
      const Point p = (*this)[k];
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        throw Error(Status::not_finite, "%s: number %zu is (%g, %g), not finite", name, k, p.x,
                    p.y);
      }
    }
  }
  // With 0 in place of -0.
  Point operator[](std::size_t k) const { return {xy_[2 * k] + 0.0, xy_[2 * k + 1] + 0.0}; }

 private:
  const double* xy_;
};

// After how many translations progress is reported. Hard questions take a time that grows with the
// number of vertices.
std::uint64_t translations_a_report(const PolygonPair& pair) {
  constexpr std::uint64_t most_vertices = std::uint64_t{1} << 16;  // of all translations
  const std::uint64_t vertices = std::uint64_t{pair.a.boundary.size()} + pair.b.boundary.size();
  return std::clamp<std::uint64_t>(most_vertices / vertices, 1, Task::portion);
}

// Writes answer(k, tally) to out[k] for each k below `count`, once all are known.
template <class Answer, class Result>
void give_all(std::size_t count, std::uint64_t a_report, const gcv_options& options, Result* out,
              Answer answer) {
  constexpr std::uint64_t most = 128;  // at a time
  const auto block = static_cast<std::size_t>(std::min(a_report, most));
  constexpr std::size_t few = 8;  // that need no memory of their own
  Task task(threads_of(options), options.progress, options.progress_context, a_report);
  task.begin(count);
  boost::container::small_vector<Result, few> results(count);
  gcv::for_each_in_parallel((count + block - 1) / block, task.threads(),
                            [&](std::size_t number) {
                              task.advance(0);  // other threads go on after one that was cancelled
                              Tally tally;
                              const std::size_t first = number * block;
                              const std::size_t end = std::min(count, first + block);
                              for (std::size_t k = first; k < end; ++k) {
                                results[k] = answer(k, tally);
                              }
                              task.advance(end - first);
                            },
                            [&] { task.watch(); });
  task.finish();
  std::copy(results.begin(), results.end(), out);
}

// What all of these functions take.
struct Question {
  const gcv_polygon* a;
  const gcv_polygon* b;
  const double* translations;
  std::size_t count;
  const gcv_options* options;
};

// Writes answer(placed, tally) to `out` for each translation. Throws Error, with the number of the
// translation.
template <class Result, class Answer>
void give_answers(const Question& question, Result* out, Answer answer) {
  require(question.a, "a");
  require(question.b, "b");
  const gcv_options options = read_options(question.options);
  if (question.count == 0) {
    return;
  }
  require(question.translations, "translations");
  require(out, "out");
  const Vectors translations(question.translations, question.count, "translations");
  const PolygonPair pair(*question.a->polygon, *question.b->polygon);
  give_all(question.count, translations_a_report(pair), options, out,
           [&](std::size_t k, Tally& tally) {
             return answer(PlacedPair(pair, translations[k]), k, tally);
           });
}

gcv_contact public_contact(const gcv::Contact& contact) {
  const auto& [kind, a, b, gap, normal, on_a, on_b] = contact;
  return {static_cast<std::int32_t>(kind),
          a,
          b,
          0,
          0,
          0,
          gap,
          {normal.x, normal.y},
          {on_a.x, on_a.y},
          {on_b.x, on_b.y}};
}

// Throws Error: range, where a number of the contact is beyond the largest double.
void require_finite(const gcv::Contact& contact, std::size_t translation) {
  for (const double x :
       {contact.gap, contact.on_a.x, contact.on_a.y, contact.on_b.x, contact.on_b.y}) {
    if (!std::isfinite(x)) {
      throw Error(Status::range,
                  "translations: number %zu: a distance or a point is beyond the largest double",
                  translation);
    }
  }
}

// Throws Error: range, where a coordinate of the position is beyond the largest double.
void require_finite(const Point& position, std::size_t translation) {
  if (!std::isfinite(position.x) || !std::isfinite(position.y)) {
    throw Error(Status::range,
                "translations: number %zu: the position is beyond the largest double", translation);
  }
}

}  // namespace

gcv_status gcv_relation(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                        size_t count, const gcv_options* options, int8_t* out) {
  return guarded([&] {
    give_answers(Question{a, b, translations, count, options}, out,
                 [](const PlacedPair& placed, std::size_t, Tally& tally) {
                   return static_cast<std::int8_t>(relation(placed, tally));
                 });
  });
}

gcv_status gcv_distance(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                        size_t count, const gcv_options* options, gcv_separation* out) {
  return guarded([&] {
    give_answers(Question{a, b, translations, count, options}, out,
                 [](const PlacedPair& placed, std::size_t k, Tally& tally) {
                   const gcv::Separation separation = distance(placed, tally);
                   require_finite(separation.nearest, k);
                   return gcv_separation{separation.distance,
                                         static_cast<std::int32_t>(separation.relation), 0,
                                         public_contact(separation.nearest)};
                 });
  });
}

gcv_status gcv_cast(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                    const double* motions, size_t count, const gcv_options* options,
                    gcv_impact* out) {
  return guarded([&] {
    if (count != 0) {
      require(motions, "motions");
    }
    const Vectors all_motions(motions, count, "motions");
    give_answers(Question{a, b, translations, count, options}, out,
                 [&](const PlacedPair& placed, std::size_t k, Tally& tally) {
                   const auto [hit, time, place, contact] = cast(placed, all_motions[k], tally);
                   require_finite(place.position, k);
                   require_finite(contact, k);
                   return gcv_impact{hit ? 1 : 0,
                                     static_cast<std::int32_t>(place.relation),
                                     time,
                                     {place.position.x, place.position.y},
                                     public_contact(contact)};
                 });
  });
}
