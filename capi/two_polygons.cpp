// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about two polygons: gcv_relation, gcv_distance, gcv_cast, gcv_penetration.
#include <cstddef>
#include <cstdint>
#include <optional>

#include "answers.hpp"
#include "cast.hpp"
#include "contacts.hpp"
#include "distance.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "penetration.hpp"
#include "polygon_pair.hpp"
#include "relation.hpp"
#include "task.hpp"

namespace {

using gcv::PlacedPair;
using gcv::Point;
using gcv::PolygonPair;
using gcv::Tally;
using gcv::Task;
using gcv::capi::give_all;
using gcv::capi::guarded;
using gcv::capi::public_contact;
using gcv::capi::read_options;
using gcv::capi::refuse_tolerance;
using gcv::capi::require;
using gcv::capi::require_finite;
using gcv::capi::require_finite_depth;
using gcv::capi::translations_a_report;
using gcv::capi::Vectors;
using gcv::capi::wanted_parts;

// What all of these functions take.
struct PairQuestion {
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
std::optional<Asked> checked(const PairQuestion& question, const Result* out) {
  require(question.a, "a");
  require(question.b, "b");
  const gcv_options options = read_options(question.options);
  if (question.count == 0) {
    return std::nullopt;
  }
  require(question.translations, "translations");
  require(out, "out");
  const Vectors translations(question.translations, question.count, "translations", sizeof *out);
  return Asked{PolygonPair(*question.a->polygon, *question.b->polygon), translations, options};
}

// Writes answer(placed, k, tally) to `out` for each translation k.
template <class Result, class Answer>
void give_answers(const PairQuestion& question, Result* out, Answer answer) {
  if (const std::optional<Asked> asked = checked(question, out)) {
    give_all(question.count,
             translations_a_report(asked->pair.a.boundary.size(), asked->pair.b.boundary.size()),
             asked->options, out, [&](Tally& tally, Task& /*task*/) {
               return [&](std::size_t k) {
                 return answer(PlacedPair(asked->pair, asked->translations[k]), k, tally);
               };
             });
  }
}

}  // namespace

gcv_status gcv_relation(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                        size_t count, const gcv_options* options, int8_t* out) {
  return guarded([&] {
    give_answers(PairQuestion{a, b, translations, count, options}, out,
                 [](const PlacedPair& placed, std::size_t, Tally& tally) {
                   return static_cast<std::int8_t>(relation(placed, tally));
                 });
  });
}

gcv_status gcv_distance(const gcv_polygon* a, const gcv_polygon* b, const double* translations,
                        size_t count, const gcv_options* options, gcv_separation* out) {
  return guarded([&] {
    give_answers(PairQuestion{a, b, translations, count, options}, out,
                 [](const PlacedPair& placed, std::size_t k, Tally& tally) {
                   const gcv::Separation separation = distance(placed, tally);
                   require_finite(separation.nearest, "translations", k);
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
    const Vectors all_motions(motions, count, "motions", sizeof *out);
    give_answers(PairQuestion{a, b, translations, count, options}, out,
                 [&](const PlacedPair& placed, std::size_t k, Tally& tally) {
                   const auto [hit, time, place, contact] = cast(placed, all_motions[k], tally);
                   require_finite(place.position, "translations", k);
                   require_finite(contact, "translations", k);
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
    const PairQuestion question{a, b, translations, count, options};
    const std::optional<Asked> asked = checked(question, out);
    refuse_tolerance(read_options(options), "ways out of overlaps");
    if (!asked) {
      return;
    }
    Preparation preparation{asked->options, count};
    Task task(1, asked->options.progress == nullptr ? nullptr : report_preparation, &preparation);
    Tally tally_of_all;
    const gcv::WaysOut ways(*a->polygon, *b->reflected(), wanted_parts(asked->options), count, task,
                            tally_of_all);
    give_all(count,
             translations_a_report(asked->pair.a.boundary.size(), asked->pair.b.boundary.size()), 1,
             gcv::capi::long_block(count, asked->options), asked->options, out,
             [&](Tally& tally, Task& progress) {
               return [&, search = gcv::EscapeSearch(ways, tally)](std::size_t k) mutable {
                 const auto [depth, way, place, contact] =
                     search.find(PlacedPair(asked->pair, asked->translations[k]), progress);
                 require_finite(place.position, "translations", k);
                 require_finite(contact, "translations", k);
                 require_finite_depth(depth, "translations", k);
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
