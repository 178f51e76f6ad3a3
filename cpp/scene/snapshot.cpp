// SPDX-License-Identifier: LGPL-3.0-or-later
#include "snapshot.hpp"

#include <algorithm>
#include <utility>

namespace gcv {

Snapshot::Snapshot(const Scene& scene, Query asked)
    : family(scene.family()), query(std::move(asked)), container_stamp(scene.container_stamp()) {
  members.reserve(scene.size());
  for (const Member& member : scene.members()) {
    if (query.admits(member)) {
      members.push_back({member.id, member.stamp});
    }
  }
}

Unchanged::Unchanged(const Scene& scene, const Query& query, const Snapshot& before)
    : before_(&before),
      slots_(scene.members().size(), false),
      of_before_(before.members.size(), false),
      container_(scene.container_stamp() == before.container_stamp) {
  std::size_t old = 0;
  for (std::uint32_t slot = 0; slot < slots_.size(); ++slot) {
    const Member& member = scene.members()[slot];
    while (old < before.members.size() && before.members[old].id < member.id) {
      ++old;
    }
    if (old < before.members.size() && before.members[old].id == member.id &&
        before.members[old].stamp == member.stamp && query.admits(member)) {
      slots_[slot] = true;
      of_before_[old] = true;
    }
  }
}

std::size_t Unchanged::index_up_to(Id last, Id id) const {
  const std::vector<Snapshot::Stamped>& members = before_->members;
  const auto end = members.begin() +
                   static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(last, members.size() - 1));
  return static_cast<std::size_t>(
      std::lower_bound(members.begin(), end, id,
                       [](const Snapshot::Stamped& member, Id i) { return member.id < i; }) -
      members.begin());
}

}  // namespace gcv
