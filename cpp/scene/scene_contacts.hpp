// SPDX-License-Identifier: LGPL-3.0-or-later
//
// All contacts between the solids of a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "contact.hpp"
#include "query.hpp"
#include "snapshot.hpp"
#include "task.hpp"

namespace gcv {

struct SceneContact {
  Id a;
  Id b;  // a < b
  Contact contact;
};

inline constexpr std::uint64_t no_previous = UINT64_MAX;

struct SceneContactList {
  Snapshot snapshot;
  double distance;
  double slope;
  // By the sizes of their gaps, then by ids, then in the order of contacts.
  std::vector<SceneContact> contacts;
  std::vector<std::uint64_t> previous;  // the index of each in the list before, or no_previous
};

// As near_contacts() has them, for all pairs. What has not changed since a previous list of the
// same distance, slope and query, which may be nullptr, is taken from there. Throws Error:
// cancelled.
SceneContactList scene_contacts(const Scene& scene, const Query& query, double distance,
                                double slope, const SceneContactList* previous, Task& task);

}  // namespace gcv
