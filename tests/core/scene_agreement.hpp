// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The C functions for scenes against the reference: the answers of all members together, each by
// the definitions. Each check gives a sentence for every difference.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "contact_agreement.hpp"

namespace gcv::test {

// The least and the largest coordinates.
struct ExactBox {
  reference::Exact low;
  reference::Exact high;
};

// A polygon where it is, or a container. One without a box is everywhere.
struct PlacedSolid {
  std::uint64_t id;
  std::uint32_t layers;
  reference::Solid solid;
  std::optional<ExactBox> box;
};

PlacedSolid placed_member(std::uint64_t id, std::uint32_t layers, const reference::Solid& polygon,
                          const Point& position);
PlacedSolid placed_container(const reference::Solid& polygon);

// A scene for both sides.
struct CheckedScene {
  const gcv_scene* handle;
  std::vector<PlacedSolid> solids;  // by id
};

// A polygon that a scene is asked about, for both sides.
struct MovingPolygon {
  const gcv_polygon* handle;
  reference::Solid solid;
};

struct SceneCounts {
  ContactCounts contacts;
  std::size_t infinite = 0;  // distances
  std::size_t ties = 0;      // several at the same distance or time
  std::size_t pairs = 0;     // in lists
};

// Distances, relations, hits of one polygon.
Messages check_scene_relations(const CheckedScene& scene, const MovingPolygon& moving,
                               const Points& positions, const gcv_query* query,
                               SceneCounts& counts);
Messages check_scene_distances(const CheckedScene& scene, const MovingPolygon& moving,
                               const Points& positions, const gcv_query* query,
                               SceneCounts& counts);
Messages check_scene_casts(const CheckedScene& scene, const MovingPolygon& moving,
                           const Points& positions, const Points& motions, const gcv_query* query,
                           SceneCounts& counts);
Messages check_scene_near(const CheckedScene& scene, const MovingPolygon& moving,
                          const Point& position, double distance, const gcv_query* query,
                          SceneCounts& counts);
// Lists of the scene alone.
Messages check_scene_pairs(const CheckedScene& scene, double distance, const gcv_query* query,
                           SceneCounts& counts);
Messages check_scene_contacts(const CheckedScene& scene, double distance, double slope,
                              const gcv_query* query, SceneCounts& counts);

// ---- What the checks consist of

using PlacedSolids = std::vector<const PlacedSolid*>;

// Those that the query is about, by id.
PlacedSolids asked_solids(const CheckedScene& scene, const gcv_query* query);

PlacedSolid moved_there(const MovingPolygon& moving, const reference::Exact& t);

// The square of the distance of the boxes: 0 where one is everywhere.
reference::Rational squared_box_gap(const PlacedSolid& a, const PlacedSolid& b);

// How the second one lies to the first, and to all of them.
int relation_of(const PlacedSolid& a, const PlacedSolid& b);
int relation_to_all(const PlacedSolids& solids, const PlacedSolid& b);

}  // namespace gcv::test
