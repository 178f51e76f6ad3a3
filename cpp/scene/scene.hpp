// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Polygons at positions, and perhaps a container round them.
//
// The one object of the core that changes. A change that throws leaves it as it was. Everything a
// question needs is made from the members when it is asked, but for a forest over their boxes, best
// positions that are known, and the last solids that were joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "box_forest.hpp"
#include "kept_solids.hpp"
#include "known_bests.hpp"
#include "polygon.hpp"

namespace gcv {

using Id = std::uint64_t;

inline constexpr Id container_id = 1;
inline constexpr std::uint32_t all_layers = UINT32_MAX;

// A number that no other change of any scene has.
std::uint64_t next_stamp();

struct Member {
  Id id;
  std::shared_ptr<const Polygon> polygon;  // nullptr: the member was removed
  Point position;
  std::uint64_t stamp;  // of its last change
  std::uint32_t layers;
};

// A solid of a scene at its position: that of a member, or of the container.
struct Solid {
  Id id;
  const Boundary& boundary;
  Point position;
};

class Scene {
 public:
  Scene();

  // nullptr for none.
  void set_container(const Polygon* container);
  // Returns the first of the ids, which follow one another.
  Id add(std::vector<std::shared_ptr<const Polygon>> polygons, std::span<const Point> positions);
  // The functions that take ids throw Error: invalid_argument for one that is no member's, or is
  // there twice. Polygons and positions may be empty: then they stay.
  void set(std::span<const Id> ids, std::span<const std::shared_ptr<const Polygon>> polygons,
           std::span<const Point> positions);
  void set_layers(std::span<const Id> ids, std::span<const std::uint32_t> layers);
  void remove(std::span<const Id> ids);

  // Members in the order of their ids, and some that were removed.
  [[nodiscard]] const std::vector<Member>& members() const { return members_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Member& member(Id id) const;
  // Of members, in the order of the ids.
  [[nodiscard]] std::vector<Point> positions(std::span<const Id> ids) const;

  // Over the boxes of members, by their indices in members().
  [[nodiscard]] const BoxForest& boxes() const { return boxes_; }
  [[nodiscard]] Solid solid(std::uint32_t slot) const {
    const Member& member = members_[slot];
    return {member.id, member.polygon->boundary(), member.position};
  }
  // The complement of the container.
  [[nodiscard]] std::optional<Solid> container() const;

  // The same for copies of a scene, and for no others.
  [[nodiscard]] std::uint64_t family() const { return family_; }
  [[nodiscard]] std::uint64_t container_stamp() const { return container_stamp_; }

  // Those that no change since then can have made better.
  [[nodiscard]] KnownBests& known_bests() const { return known_bests_; }
  // Those of the scene as it is.
  [[nodiscard]] KeptSolids& kept_solids() const { return kept_solids_; }

  // The bytes that it has taken, without the polygons.
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The index of a member; nothing if there is none with that id.
  [[nodiscard]] std::optional<std::uint32_t> find(Id id) const;
  // The indices of members with the number of each id, in order.
  struct Named {
    std::uint32_t slot;
    std::size_t number;
  };
  [[nodiscard]] std::vector<Named> named(std::span<const Id> ids) const;
  void tidy();
  // After a change that may free positions.
  void forget() {
    known_bests_.clear();
    kept_solids_.clear();
  }

  std::vector<Member> members_;
  std::size_t size_ = 0;  // of those that were not removed
  Id next_id_ = container_id + 1;
  BoxForest boxes_;
  std::shared_ptr<const Boundary> container_;
  std::uint64_t container_stamp_ = 0;
  std::uint64_t family_;
  mutable KnownBests known_bests_;
  mutable KeptSolids kept_solids_;
};

}  // namespace gcv
