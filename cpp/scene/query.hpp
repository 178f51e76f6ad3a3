// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which solids of a scene a question is about, and those of them that are near.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "pair_descent.hpp"
#include "scene.hpp"

namespace gcv {

struct Query {
  std::uint32_t layers = all_layers;
  std::vector<Id> ignored;  // in order, each once

  [[nodiscard]] bool ignores(Id id) const {
    return std::binary_search(ignored.begin(), ignored.end(), id);
  }
  [[nodiscard]] bool admits(const Member& member) const {
    return (member.layers & layers) != 0 && member.polygon != nullptr && !ignores(member.id);
  }
  [[nodiscard]] bool admits_container() const { return layers != 0 && !ignores(container_id); }

  friend bool operator==(const Query&, const Query&) = default;
};

// Where boxes of members meet a box.
template <class Visit>
class NearBoxes {
 public:
  NearBoxes(const Box& box, Visit& visit) : box_(box), visit_(visit) {}

  template <class Descend>
  bool any_child(const ChainTree::Block& block, Descend descend) {
    return any_lane(block.overlapping(box_) & children_of(block), descend);
  }
  bool meet(BoxForest::Slot slot) { return visit_(slot); }

 private:
  const Box box_;
  Visit& visit_;
};

// Calls visit(slot) for the members that a query admits whose boxes meet a box, until a visit
// returns true. Did one?
template <class Visit>
bool any_near(const Scene& scene, const Query& query, const Box& box, Visit visit) {
  const auto visit_admitted = [&](BoxForest::Slot slot) {
    return query.admits(scene.members()[slot]) && visit(slot);
  };
  NearBoxes search(box, visit_admitted);
  return scene.boxes().search(search);
}

}  // namespace gcv
