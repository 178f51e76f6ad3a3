// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How one polygon at a position lies to all solids of a scene.
#pragma once

#include "cast.hpp"
#include "distance.hpp"
#include "query.hpp"
#include "relation.hpp"

namespace gcv {

// The separation from the nearest solid; of several, the one with the smallest id.
struct SceneSeparation {
  Id id;  // 0 if there is none: then the distance is infinite
  Separation separation;
};

// The impact on the first solid that is hit; of several, the one with the smallest id.
struct SceneImpact {
  Id id;  // 0 without a hit
  Impact impact;
};

class SceneQuestions {
 public:
  // All must live longer.
  SceneQuestions(const Scene& scene, const Query& query, const Boundary& moving)
      : scene_(scene), query_(query), moving_(moving) {}

  [[nodiscard]] Relation relation(const Point& position, Tally& tally) const;
  [[nodiscard]] SceneSeparation distance(const Point& position, Tally& tally) const;
  [[nodiscard]] SceneImpact cast(const Point& position, const Point& motion, Tally& tally) const;

  // Puts the relations to a solid there that it overlaps, if there is one.
  Relation relation(const Point& position, Tally& tally,
                    std::optional<NearbyRelations>& overlapped) const;

 private:
  // The container, if the query admits it.
  [[nodiscard]] std::optional<Solid> container() const {
    return query_.admits_container() ? scene_.container() : std::nullopt;
  }
  // Calls visit(solid) for those whose boxes meet that of the polygon, and for the container, until
  // a visit returns true.
  template <class Visit>
  void visit_near(const Point& position, Visit visit) const;
  // The closest of all relation_to(solid), as far as an overlap.
  template <class RelationTo>
  [[nodiscard]] Relation closest(const Point& position, RelationTo relation_to) const;
  // The smallest id of those that it overlaps, or 0.
  [[nodiscard]] Id first_overlap(const Point& position, Tally& tally) const;

  const Scene& scene_;
  const Query& query_;
  const Boundary& moving_;
};

// The relation at one position after another: a solid that was overlapped is asked first.
class NearbySceneRelations {
 public:
  NearbySceneRelations(const SceneQuestions& questions, Tally& tally)
      : questions_(questions), tally_(tally) {}

  Relation at(const Point& position);
  // As that of NearbyRelations.
  [[nodiscard]] bool overlaps_around(const Point& position, double moved_by) const {
    return overlapped_ && overlapped_->overlaps_around(position, moved_by);
  }

 private:
  const SceneQuestions& questions_;
  Tally& tally_;
  std::optional<NearbyRelations> overlapped_;
};

}  // namespace gcv
