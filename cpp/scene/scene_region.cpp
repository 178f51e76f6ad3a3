// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_region.hpp"

#include <utility>

#include "joined_solids.hpp"

namespace gcv {

Region free_region(const Scene& scene, const Query& query,
                   const std::shared_ptr<const Polygon>& reflected,
                   const std::optional<Box>& window, const RegionOptions& options, Task& task) {
  JoinedSolids solids = join_solids(scene, query, reflected->boundary(), window);
  Region region = free_region({solids.boundary, "a solid of the scene"}, solids.border_or_null(),
                              {reflected, "moving"}, {0, 0}, options, task);
  region.owners = std::move(solids.owners);
  return region;
}

}  // namespace gcv
