// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Questions about a polygon and a scene: gcv_scene_relation, gcv_scene_distance, gcv_scene_cast.
#include "scene_questions.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "answers.hpp"
#include "contacts.hpp"
#include "error.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "scene_queries.hpp"

namespace gcv::capi {

Query read_query(const gcv_query* query) {
  Query result;
  if (query == nullptr) {
    return result;
  }
  const std::uint32_t size = query->struct_size;
  if (size < sizeof(gcv_query)) {
    throw Error(Status::invalid_argument,
                "query: struct_size is %u, not at least %zu; initialise it with GCV_QUERY_INIT",
                size, sizeof(gcv_query));
  }
  const auto* const bytes = reinterpret_cast<const unsigned char*>(query);
  if (std::any_of(bytes + sizeof(gcv_query), bytes + size,
                  [](unsigned char byte) { return byte != 0; })) {
    throw Error(Status::invalid_argument,
                "query: a byte beyond %zu of %u is set, for what this version does not know",
                sizeof(gcv_query), size);
  }
  if (query->ignore == nullptr && query->ignore_count != 0) {
    throw Error(Status::null_argument, "query: ignore is NULL, but ignore_count is %zu",
                query->ignore_count);
  }
  result.layers = query->layers;
  require_count(query->ignore_count, sizeof *query->ignore, "query: ignore");
  result.ignored.assign(query->ignore, query->ignore + query->ignore_count);
  std::sort(result.ignored.begin(), result.ignored.end());
  result.ignored.erase(std::unique(result.ignored.begin(), result.ignored.end()),
                       result.ignored.end());
  return result;
}

}  // namespace gcv::capi

namespace {

using gcv::Point;
using gcv::Query;
using gcv::SceneQuestions;
using gcv::Tally;
using gcv::Task;
using gcv::capi::give_all;
using gcv::capi::guarded;
using gcv::capi::public_contact;
using gcv::capi::read_exact_options;
using gcv::capi::read_query;
using gcv::capi::require;
using gcv::capi::require_count;
using gcv::capi::require_finite;
using gcv::capi::translations_a_report;
using gcv::capi::Vectors;

// What all of these functions take.
struct Question {
  const gcv_scene* scene;
  const gcv_polygon* moving;
  const double* positions;
  std::size_t count;
  const gcv_query* query;
  const gcv_options* options;
};

// Writes answer(questions, position, k, tally) to `out` for each position k.
template <class Result, class Answer>
void give_answers(const Question& question, Result* out, Answer answer) {
  require(question.scene, "scene");
  require(question.moving, "moving");
  const gcv_options options = read_exact_options(question.options, "scenes");
  const Query query = read_query(question.query);
  if (question.count == 0) {
    return;
  }
  require(question.positions, "positions");
  require(out, "out");
  const Vectors positions(question.positions, question.count, "positions", sizeof *out);
  const gcv::Boundary& moving = question.moving->polygon->boundary();
  const SceneQuestions questions(question.scene->scene, query, moving);
  give_all(question.count, translations_a_report(moving.size(), moving.size()), options, out,
           [&](Tally& tally, Task& /*task*/) {
             return [&](std::size_t k) { return answer(questions, positions[k], k, tally); };
           });
}

}  // namespace

gcv_status gcv_scene_relation(const gcv_scene* scene, const gcv_polygon* moving,
                              const double* positions, size_t count, const gcv_query* query,
                              const gcv_options* options, int8_t* out) {
  return guarded([&] {
    give_answers(
        Question{scene, moving, positions, count, query, options}, out,
        [](const SceneQuestions& questions, const Point& position, std::size_t, Tally& tally) {
          return static_cast<std::int8_t>(questions.relation(position, tally));
        });
  });
}

gcv_status gcv_scene_distance(const gcv_scene* scene, const gcv_polygon* moving,
                              const double* positions, size_t count, const gcv_query* query,
                              const gcv_options* options, gcv_separation* out) {
  return guarded([&] {
    give_answers(
        Question{scene, moving, positions, count, query, options}, out,
        [](const SceneQuestions& questions, const Point& position, std::size_t k, Tally& tally) {
          const auto [id, separation] = questions.distance(position, tally);
          require_finite(separation.nearest, "positions", k);
          return gcv_separation{separation.distance, static_cast<std::int32_t>(separation.relation),
                                0, public_contact(separation.nearest, id)};
        });
  });
}

gcv_status gcv_scene_cast(const gcv_scene* scene, const gcv_polygon* moving,
                          const double* positions, const double* motions, size_t count,
                          const gcv_query* query, const gcv_options* options, gcv_impact* out) {
  return guarded([&] {
    if (count != 0) {
      require(motions, "motions");
    }
    const Vectors all_motions(motions, count, "motions", sizeof *out);
    give_answers(
        Question{scene, moving, positions, count, query, options}, out,
        [&](const SceneQuestions& questions, const Point& position, std::size_t k, Tally& tally) {
          const auto [id, impact] = questions.cast(position, all_motions[k], tally);
          const auto& [hit, time, place, contact] = impact;
          require_finite(place.position, "positions", k);
          require_finite(contact, "positions", k);
          return gcv_impact{hit ? 1 : 0,
                            static_cast<std::int32_t>(place.relation),
                            time,
                            {place.position.x, place.position.y},
                            public_contact(contact, id)};
        });
  });
}
