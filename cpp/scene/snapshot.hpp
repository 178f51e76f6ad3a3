// SPDX-License-Identifier: LGPL-3.0-or-later
//
// When the solids of a scene changed last, for lists that are asked for again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "query.hpp"
#include "scene.hpp"

namespace gcv {

struct Snapshot {
  struct Stamped {
    Id id;
    std::uint64_t stamp;
  };

  Snapshot() = default;  // of no scene
  Snapshot(const Scene& scene, Query asked);

  std::uint64_t family = 0;
  Query query;
  std::uint64_t container_stamp = 0;
  std::vector<Stamped> members;  // those that the query admits, by ids
};

// Which solids are the same as in a snapshot. Both must have the same query.
class Unchanged {
 public:
  // Nothing is.
  explicit Unchanged(const Scene& scene) : slots_(scene.members().size(), false) {}
  // The snapshot must live longer.
  Unchanged(const Scene& scene, const Query& query, const Snapshot& before);

  [[nodiscard]] bool has_slot(std::uint32_t slot) const { return slots_[slot]; }
  [[nodiscard]] bool has_container() const { return container_; }
  // Of a solid of the snapshot.
  [[nodiscard]] bool has(Id id) const {
    return id == container_id ? container_ : before_ != nullptr && of_before_[index_of(id)];
  }

 private:
  // Of a member of the snapshot. Ids grow by at least 1. So the index of one is at most its
  // distance to the first id, and if that holds for the last one, it is this distance for all.
  [[nodiscard]] std::size_t index_of(Id id) const {
    const std::vector<Snapshot::Stamped>& members = before_->members;
    const Id distance = id - members.front().id;
    return members.back().id - members.front().id < members.size()
               ? static_cast<std::size_t>(distance)
               : index_up_to(distance, id);
  }
  [[nodiscard]] std::size_t index_up_to(Id last, Id id) const;

  const Snapshot* before_ = nullptr;
  std::vector<bool> slots_;
  std::vector<bool> of_before_;  // members of the snapshot
  bool container_ = false;
};

}  // namespace gcv
