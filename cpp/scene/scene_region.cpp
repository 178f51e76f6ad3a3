// SPDX-License-Identifier: LGPL-3.0-or-later
#include "scene_region.hpp"

#include <memory>

#include "joined_solids.hpp"

namespace gcv {

Region free_region(const Scene& scene, const Query& query,
                   const std::shared_ptr<const Polygon>& reflected,
                   const std::optional<Box>& window, const RegionOptions& options, Task& task) {
  const std::shared_ptr<const JoinedSolids> solids =
      window ? std::make_shared<const JoinedSolids>(
                   join_solids(scene, query, reflected->boundary(), window))
             : join_all_solids(scene, query, reflected->boundary());
  Region region = free_region({solids->boundary, "a solid of the scene"}, solids->border_or_null(),
                              {reflected, "moving"}, {0, 0}, options, task);
  region.owners = solids->owners;
  return region;
}

}  // namespace gcv
