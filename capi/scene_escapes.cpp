// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free positions in a scene: gcv_scene_best, gcv_scene_penetration.
#include "scene_escapes.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

#include "answers.hpp"
#include "contacts.hpp"
#include "error.hpp"
#include "finite_point.hpp"
#include "free_positions.hpp"
#include "gcv/gcv.h"
#include "guard.hpp"
#include "handles.hpp"
#include "options.hpp"
#include "scene_queries.hpp"

namespace {

using gcv::Error;
using gcv::FreePositions;
using gcv::Point;
using gcv::Query;
using gcv::SceneEscapeSearch;
using gcv::Status;
using gcv::Tally;
using gcv::Task;
using gcv::capi::guarded;
using gcv::capi::require;
using gcv::capi::require_finite;
using gcv::capi::require_finite_depth;

Point read_direction(const double direction[2]) {
  const Point result = gcv::finite_point({direction[0], direction[1]}, "direction");
  if (result == Point{0, 0}) {
    throw Error(Status::invalid_argument, "direction is 0 0");
  }
  return result;
}

}  // namespace

gcv_status gcv_scene_best(const gcv_scene* scene, const gcv_polygon* moving,
                          const double direction[2], const gcv_query* query,
                          const gcv_options* options, double out[2], int32_t* found) {
  return guarded([&] {
    require(scene, "scene");
    require(moving, "moving");
    require(direction, "direction");
    require(out, "out");
    require(found, "found");
    const gcv_options known = gcv::capi::read_exact_options(options, "free positions");
    const Query asked = gcv::capi::read_query(query);
    const Point wanted = read_direction(direction);
    if (!asked.admits_container() || !scene->scene.container()) {
      throw Error(Status::invalid_argument,
                  "the scene has no container for this query: nothing bounds the positions");
    }
    Task task(gcv::capi::threads_of(known), known.progress, known.progress_context);
    task.begin(scene->scene.size() + 1);
    const FreePositions positions(scene->scene, asked, *moving->polygon, *moving->reflected(),
                                  gcv::capi::wanted_parts(known).fits);
    Tally tally;
    const std::optional<gcv::UsablePosition> best = positions.furthest(wanted, task, tally);
    if (best) {
      require_finite(best->position, "best", 0);
    }
    task.finish();
    out[0] = best ? best->position.x : 0;
    out[1] = best ? best->position.y : 0;
    *found = best ? 1 : 0;
  });
}

gcv_status gcv_scene_penetration(const gcv_scene* scene, const gcv_polygon* moving,
                                 const double* positions, size_t count, const gcv_query* query,
                                 const gcv_options* options, gcv_escape* out) {
  return guarded([&] {
    require(scene, "scene");
    require(moving, "moving");
    const gcv_options known = gcv::capi::read_exact_options(options, "ways out of overlaps");
    const Query asked = gcv::capi::read_query(query);
    if (count == 0) {
      return;
    }
    require(positions, "positions");
    require(out, "out");
    const gcv::capi::Vectors all(positions, count, "positions", sizeof *out);
    const FreePositions ways(scene->scene, asked, *moving->polygon, *moving->reflected(),
                             gcv::capi::wanted_parts(known).fits);
    const std::size_t block = gcv::capi::long_block(count, known);
    gcv::capi::give_all(count, Task::portion, 1, block, known, out, [&](Tally& tally, Task& task) {
      return [&, search = SceneEscapeSearch(ways, block, tally)](std::size_t k) mutable {
        const auto [id, escape] = search.find(all[k], task);
        const auto& [depth, way, place, contact] = escape;
        require_finite(place.position, "positions", k);
        require_finite(contact, "positions", k);
        if (id != 0) {
          require_finite_depth(depth, "positions", k);
        }
        return gcv_escape{depth,
                          {way.x, way.y},
                          {place.position.x, place.position.y},
                          static_cast<std::int32_t>(place.relation),
                          0,
                          gcv::capi::public_contact(contact, id)};
      };
    });
  });
}
