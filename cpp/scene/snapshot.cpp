// SPDX-License-Identifier: LGPL-3.0-or-later
#include "snapshot.hpp"

#include <algorithm>

namespace gcv {

Snapshot::Snapshot(const Scene& scene, const Query& asked)
    : family(scene.family()), query(asked), container_stamp(scene.container_stamp()) {
  members.reserve(scene.size());
  for (const Member& member : scene.members()) {
    if (query.admits(member)) {
      members.push_back({member.id, member.stamp});
    }
  }
}

Unchanged::Unchanged(const Scene& scene, const Query& query, const Snapshot& before)
    : slots_(scene.members().size(), false),
      container_(scene.container_stamp() == before.container_stamp) {
  auto old = before.members.begin();
  for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) {
    const Member& member = scene.members()[slot];
    while (old != before.members.end() && old->id < member.id) {
      ++old;
    }
    if (old != before.members.end() && old->id == member.id && old->stamp == member.stamp &&
        query.admits(member)) {
      slots_[slot] = true;
      ids_.push_back(member.id);
    }
  }
}

bool Unchanged::has(Id id) const {
  return id == container_id ? container_ : std::binary_search(ids_.begin(), ids_.end(), id);
}

}  // namespace gcv
