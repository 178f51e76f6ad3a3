// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free positions of a polygon in a scene, found without the free region.
#pragma once

#include <optional>
#include <vector>

#include "penetration.hpp"
#include "polygon.hpp"
#include "scene_questions.hpp"
#include "task.hpp"

namespace gcv {

// A way out of all overlaps, and the solid that the polygon touches there: 0 if it overlapped none.
struct SceneEscape {
  Id id;
  Escape escape;  // the depth is infinite where nothing is free
};

class FreePositions {
 public:
  // All must live longer. `reflected` is the reflection of the polygon. Without fits, those places
  // alone count that have free ones around.
  FreePositions(const Scene& scene, const Query& query, const Polygon& moving,
                const Polygon& reflected, bool with_fits)
      : scene_(scene),
        query_(query),
        moving_(moving.boundary()),
        reflected_(reflected.boundary()),
        wanted_{true, with_fits},
        questions_(scene, query, moving_) {}

  // The shortest way out, of several the lexicographically smallest. Throws Error: cancelled,
  // internal.
  [[nodiscard]] SceneEscape escape(const Point& position, Task& task, Tally& tally) const;

  // The furthest position in a direction, of several the lexicographically smallest; nothing if
  // there is none. Throws Error: invalid_argument without a container; cancelled, internal.
  [[nodiscard]] std::optional<UsablePosition> furthest(const Point& direction, Task& task,
                                                       Tally& tally) const;

 private:
  [[nodiscard]] UsablePosition usable(const ExactPoint& place, Tally& tally) const;
  // The same, or the nearest free position found on one of the ways.
  [[nodiscard]] UsablePosition usable_along(const ExactPoint& place, const std::vector<Point>& ways,
                                            Tally& tally) const;

  const Scene& scene_;
  const Query& query_;
  const Boundary& moving_;
  const Boundary& reflected_;
  const WantedParts wanted_;
  const SceneQuestions questions_;
};

}  // namespace gcv
