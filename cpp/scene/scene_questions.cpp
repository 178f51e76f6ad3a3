// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_questions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gap.hpp"
#include "placed_box.hpp"
#include "swept_box.hpp"

namespace gcv {

namespace {

// A solid and the polygon that moves, each at its position.
struct PlacedSolid {
  PlacedSolid(const Solid& solid, const Boundary& moving, const Point& position)
      : pair(solid.boundary, moving), placed(pair, solid.position, position) {}
  PlacedSolid(const PlacedSolid&) = delete;
  PlacedSolid& operator=(const PlacedSolid&) = delete;

  const PolygonPair pair;
  const PlacedPair placed;
};

// What is so far away along x and along y is at least that far away, but for roundings below 2u.
double distance_below(double x, double y) {
  const double square = x * x + y * y;
  const bool is_in_range = square > 0x1p-900 && square < 0x1p900;
  return is_in_range ? std::sqrt(square) : std::max(x, y);
}

// Finds the nearest solid.
class NearestSolid {
 public:
  NearestSolid(const Scene& scene, const Query& query, const Boundary& moving,
               const Point& position, Tally& tally)
      : scene_(scene),
        query_(query),
        moving_(moving),
        position_(position),
        tally_(tally),
        box_(moved_outwards(moving.bounds, position)) {}

  // The nearest child first.
  template <class Visit>
  bool any_child(const ChainTree::Block& block, Visit visit) {
    const SimdDouble none = SimdDouble::of(0);
    const SimdDouble x = larger(
        none, larger(SimdDouble::load(block.x0) + -box_.x1, box_.x0 - SimdDouble::load(block.x1)));
    const SimdDouble y = larger(
        none, larger(SimdDouble::load(block.y0) + -box_.y1, box_.y0 - SimdDouble::load(block.y1)));
    double by_x[ChainTree::width];
    double distances[ChainTree::width];
    x.store(by_x);
    y.store(distances);
    for (std::uint32_t lane = 0; lane < ChainTree::width; ++lane) {
      distances[lane] = distance_below(by_x[lane], distances[lane]);
    }
    return any_in_order(children_of(block), distances, limit_, visit);
  }
  bool meet(BoxForest::Slot slot) {
    if (query_.admits(scene_.members()[slot])) {
      consider(scene_.solid(slot));
    }
    return false;
  }

  void consider(const Solid& solid) {
    const PlacedSolid at(solid, moving_, position_);
    const auto [relation, nearest] = is_apart()
                                         ? nearest_of_pair(at.placed, limit_, tally_)
                                         : NearestOfPair{gcv::relation(at.placed, tally_), {}};
    if (relation != Relation::apart) {
      id_ = is_apart() ? solid.id : std::min(id_, solid.id);
      relation_ = std::min(relation_, relation);
      limit_ = 0;
      return;
    }
    if (!nearest) {
      return;
    }
    const Gap& gap = nearest->gap;
    const int order = best_ ? compare_gaps(gap, best_->nearest.gap, tally_) : -1;
    if (order < 0 || (order == 0 && solid.id < id_)) {
      best_.emplace(Best{solid, *nearest});
      id_ = solid.id;
      // The roundings of this and of the distances of boxes are below 4u.
      limit_ = (1 + 0x1p-50) * nearest_gap(gap, tally_) + std::numeric_limits<double>::min();
    }
  }

  [[nodiscard]] SceneSeparation found() const {
    if (!is_apart()) {
      return {id_, {relation_, 0, {}}};
    }
    if (!best_) {
      return {0, {Relation::apart, infinity, {}}};
    }
    const PlacedSolid at(best_->solid, moving_, position_);
    const auto& [name, gap] = best_->nearest;
    const Contact nearest = contact_across(at.placed, name, gap, tally_);
    return {id_, {Relation::apart, nearest.gap, nearest}};
  }

 private:
  struct Best {
    Solid solid;
    NearestFeatures nearest;
  };

  [[nodiscard]] bool is_apart() const { return relation_ == Relation::apart; }

  const Scene& scene_;
  const Query& query_;
  const Boundary& moving_;
  const Point& position_;
  Tally& tally_;
  const Box box_;
  double limit_ = infinity;  // solids further than this do not matter
  Relation relation_ = Relation::apart;
  Id id_ = 0;
  std::optional<Best> best_;
};

// Finds the solid that a motion hits first. With an overlap at the start: one with a smaller id
// that is hit there, too.
class FirstHit {
 public:
  FirstHit(const Scene& scene, const Query& query, const Boundary& moving, const Point& position,
           const Point& motion, Id overlap, Tally& tally)
      : scene_(scene),
        query_(query),
        moving_(moving),
        position_(position),
        overlap_(overlap),
        tally_(tally),
        // Roundings are far below the slack.
        swept_{moved_outwards(moving.bounds, position), motion,
               0x1p-48 * (std::abs(motion.x) + std::abs(motion.y)) +
                   std::numeric_limits<double>::min()},
        limit_(overlap == 0 ? 1 : 0) {}

  template <class Visit>
  bool any_child(const ChainTree::Block& block, Visit visit) {
    return swept_.any_child(block, limit_, visit);
  }
  bool meet(BoxForest::Slot slot) {
    if (query_.admits(scene_.members()[slot])) {
      consider(scene_.solid(slot));
    }
    return false;
  }

  void consider(const Solid& solid) {
    if (overlap_ != 0 && solid.id >= overlap_) {
      return;
    }
    const PlacedSolid at(solid, moving_, position_);
    const std::optional<Entry> entry = first_entry(at.placed, swept_.motion, tally_);
    if (!entry || (overlap_ != 0 && !is_at_start(*entry, tally_))) {
      return;
    }
    const int order = best_ ? compare_times(*entry, best_->entry, tally_) : -1;
    if (order < 0 || (order == 0 && solid.id < best_->solid.id)) {
      best_.emplace(Best{solid, *entry});
      limit_ = std::min(limit_, entry->time.hi);
    }
  }

  struct Best {
    Solid solid;
    Entry entry;
  };
  [[nodiscard]] const std::optional<Best>& best() const { return best_; }

 private:
  const Scene& scene_;
  const Query& query_;
  const Boundary& moving_;
  const Point& position_;
  const Id overlap_;  // the smallest id of an overlap at the start, or 0
  Tally& tally_;
  const SweptBox swept_;
  double limit_;  // times after this do not matter
  std::optional<Best> best_;
};

}  // namespace

template <class Visit>
void SceneQuestions::visit_near(const Point& position, Visit visit) const {
  const Box box = moved_outwards(moving_.bounds, position);
  const bool has_ended = any_near(scene_, query_, box,
                                  [&](BoxForest::Slot slot) { return visit(scene_.solid(slot)); });
  if (const std::optional<Solid> wall = container(); wall && !has_ended) {
    visit(*wall);
  }
}

template <class RelationTo>
Relation SceneQuestions::closest(const Point& position, RelationTo relation_to) const {
  Relation result = Relation::apart;
  visit_near(position, [&](const Solid& solid) {
    result = std::min(result, relation_to(solid));
    return result == Relation::overlapping;
  });
  return result;
}

Relation SceneQuestions::relation(const Point& position, Tally& tally) const {
  return closest(position, [&](const Solid& solid) {
    return gcv::relation(PlacedSolid(solid, moving_, position).placed, tally);
  });
}

Relation SceneQuestions::relation(const Point& position, Tally& tally,
                                  std::optional<NearbyRelations>& overlapped) const {
  return closest(position, [&](const Solid& solid) {
    NearbyRelations relations(PolygonPair(solid.boundary, moving_), solid.position, {}, tally);
    const Relation there = relations.at(position);
    if (there == Relation::overlapping) {
      overlapped.emplace(relations);
    }
    return there;
  });
}

Relation NearbySceneRelations::at(const Point& position) {
  return overlapped_ && overlapped_->at(position) == Relation::overlapping
             ? Relation::overlapping
             : questions_.relation(position, tally_, overlapped_);
}

SceneSeparation SceneQuestions::distance(const Point& position, Tally& tally) const {
  NearestSolid search(scene_, query_, moving_, position, tally);
  scene_.boxes().search(search);
  if (const std::optional<Solid> wall = container()) {
    search.consider(*wall);
  }
  return search.found();
}

Id SceneQuestions::first_overlap(const Point& position, Tally& tally) const {
  Id first = 0;
  visit_near(position, [&](const Solid& solid) {
    if ((first == 0 || solid.id < first) &&
        gcv::relation(PlacedSolid(solid, moving_, position).placed, tally) ==
            Relation::overlapping) {
      first = solid.id;
    }
    return false;
  });
  return first;
}

SceneImpact SceneQuestions::cast(const Point& position, const Point& motion, Tally& tally) const {
  const auto usable = [&](const ExactPoint& exact, const Point& shift) {
    return usable_position(exact, shift, tally, NearbySceneRelations(*this, tally));
  };
  const Id overlap = first_overlap(position, tally);
  FirstHit search(scene_, query_, moving_, position, motion, overlap, tally);
  if (!(motion == Point{0, 0})) {
    scene_.boxes().search(search);
    if (const std::optional<Solid> wall = container()) {
      search.consider(*wall);
    }
  }
  if (search.best()) {
    const auto& [solid, entry] = *search.best();
    const PlacedSolid at(solid, moving_, position);
    return {solid.id,
            {true, time_of(entry, tally), usable(entry.place(), solid.position),
             contact_on_entry(at.placed, entry.name, motion, tally)}};
  }
  if (overlap != 0) {
    return {overlap, {true, 0, usable(ExactPoint::of_sum({position, {0, 0}}), {0, 0}), {}}};
  }
  return {0, {false, 1, usable(ExactPoint::of_sum({position, motion}), {0, 0}), {}}};
}

}  // namespace gcv
