// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free positions of a polygon in a scene, found without the free region.
#pragma once

#include <optional>
#include <vector>

#include "exact_region.hpp"
#include "free_place.hpp"
#include "polygon.hpp"
#include "scene_questions.hpp"
#include "task.hpp"
#include "usable_position.hpp"

namespace gcv {

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

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Query& query() const { return query_; }
  [[nodiscard]] const Boundary& moving() const { return moving_; }
  [[nodiscard]] const Boundary& reflected() const { return reflected_; }
  [[nodiscard]] const WantedParts& wanted() const { return wanted_; }
  [[nodiscard]] Relation relation(const Point& position, Tally& tally) const {
    return questions_.relation(position, tally);
  }

  // A position in doubles for a place.
  [[nodiscard]] UsablePosition usable(const ExactPoint& place, Tally& tally) const;
  // The furthest position in a direction, of several the lexicographically smallest; nothing if
  // there is none. Where that was asked before, and members were added since, begins where that
  // ended. Throws Error: invalid_argument without a container; cancelled, internal.
  [[nodiscard]] std::optional<UsablePosition> furthest(const Point& direction, Task& task,
                                                       Tally& tally) const;

 private:
  // The furthest position among solids, which are operand A. None before `first` is free, if that
  // is given. Keeps what it finds for the next question.
  [[nodiscard]] std::optional<UsablePosition> furthest_among(const Operands& operands,
                                                             const Point& direction,
                                                             const std::optional<ExactPoint>& first,
                                                             Task& task, Tally& tally) const;
  // The same among the solids that are not too far behind the first.
  [[nodiscard]] std::optional<UsablePosition> furthest_from(const ExactPoint& first,
                                                            const Point& direction, Task& task,
                                                            Tally& tally) const;
  [[nodiscard]] KnownBests::Question question(const Point& direction) const {
    return {moving_, direction, query_.layers, wanted_.fits};
  }
  // The same of a furthest place, or the nearest free position found on one of the ways: those off
  // the place, or the one back.
  [[nodiscard]] UsablePosition usable_along(const ExactPoint& place, const std::vector<Point>& ways,
                                            const Point& back, Tally& tally) const;
  // The nearest free position on one of the ways.
  [[nodiscard]] std::optional<UsablePosition> free_along(const Point& position,
                                                         const std::vector<Point>& ways,
                                                         Tally& tally) const;

  const Scene& scene_;
  const Query& query_;
  const Boundary& moving_;
  const Boundary& reflected_;
  const WantedParts wanted_;
  const SceneQuestions questions_;
};

}  // namespace gcv
