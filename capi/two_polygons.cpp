// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about two polygons: gcv_relation, gcv_distance, gcv_cast, gcv_penetration.
#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cast.hpp"
#include "contacts.hpp"
#include "distance.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "parallel.hpp"
#include "penetration.hpp"
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
using gcv::capi::is_out_of_range;
using gcv::capi::public_contact;
using gcv::capi::read_options;
using gcv::capi::refuse_tolerance;
using gcv::capi::require;
using gcv::capi::threads_of;
using gcv::capi::Vectors;
using gcv::capi::wanted_parts;

// After how many translations progress is reported. Hard questions take a time that grows with the
// number of vertices.
std::uint64_t translations_a_report(const PolygonPair& pair) {
  constexpr std::uint64_t most_vertices = std::uint64_t{1} << 16;  // of all translations
  const std::uint64_t vertices = std::uint64_t{pair.a.boundary.size()} + pair.b.boundary.size();
  return std::clamp<std::uint64_t>(most_vertices / vertices, 1, Task::portion);
}

// Writes to out[k], for each k below `count`, once all are known, what answer(k, tally, task)
// gives. begin(tally) makes the answer for some of them, which it serves one after the other.
template <class Begin, class Result>
void give_all(std::size_t count, std::uint64_t a_report, const gcv_options& options, Result* out,
              Begin begin) {
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
                              auto answer = begin(tally, task);
                              const std::size_t first = number * block;
                              const std::size_t end = std::min(count, first + block);
                              for (std::size_t k = first; k < end; ++k) {
                                results[k] = answer(k);
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

// Progress before the first translation: none of them is done.
struct Preparation {
  const gcv_options& options;
  std::size_t count;
};
std::int32_t report_preparation(void* context, std::uint64_t /*done*/, std::uint64_t /*all*/) {
  const auto& [options, count] = *static_cast<const Preparation*>(context);
  return options.progress(options.progress_context, 0, count);
}

// What is asked, checked.
struct Asked {
  PolygonPair pair;
  Vectors translations;
  gcv_options options;
};
// Nothing if there are no translations. Throws Error, with the number of the translation.
template <class Result>
std::optional<Asked> checked(const Question& question, const Result* out) {
  require(question.a, "a");
  require(question.b, "b");
  const gcv_options options = read_options(question.options);
  if (question.count == 0) {
    return std::nullopt;
  }
  require(question.translations, "translations");
  require(out, "out");
  const Vectors translations(question.translations, question.count, "translations");
  return Asked{PolygonPair(*question.a->polygon, *question.b->polygon), translations, options};
}

// Writes answer(placed, k, tally) to `out` for each translation k.
template <class Result, class Answer>
void give_answers(const Question& question, Result* out, Answer answer) {
  if (const std::optional<Asked> asked = checked(question, out)) {
    give_all(question.count, translations_a_report(asked->pair), asked->options, out,
             [&](Tally& tally, Task& /*task*/) {
               return [&](std::size_t k) {
                 return answer(PlacedPair(asked->pair, asked->translations[k]), k, tally);
               };
             });
  }
}

// Throws Error: range, where a number of the contact is beyond the largest double.
void require_finite(const gcv::Contact& contact, std::size_t translation) {
  if (is_out_of_range(contact)) {
    throw Error(Status::range,
                "translations: number %zu: a distance or a point is beyond the largest double",
                translation);
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

gcv_status gcv_penetration(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                           size_t count, const gcv_options* options, gcv_escape* out) {
  return guarded([&] {
    const Question question{a, b, translations, count, options};
    const std::optional<Asked> asked = checked(question, out);
    refuse_tolerance(read_options(options), "ways out of overlaps");
    if (!asked) {
      return;
    }
    Preparation preparation{asked->options, count};
    Task task(1, asked->options.progress == nullptr ? nullptr : report_preparation, &preparation);
    Tally tally_of_all;
    const gcv::WaysOut ways(*a->polygon, *b->reflected(), wanted_parts(asked->options), task,
                            tally_of_all);
    give_all(count, translations_a_report(asked->pair), asked->options, out,
             [&](Tally& tally, Task& progress) {
               return [&, search = gcv::EscapeSearch(ways, tally)](std::size_t k) mutable {
                 const auto [depth, way, place, contact] =
                     search.find(PlacedPair(asked->pair, asked->translations[k]), progress);
                 require_finite(place.position, k);
                 require_finite(contact, k);
                 require_finite({depth, 0}, k);
                 return gcv_escape{depth,
                                   {way.x, way.y},
                                   {place.position.x, place.position.y},
                                   static_cast<std::int32_t>(place.relation),
                                   0,
                                   public_contact(contact)};
               };
             });
  });
}
