// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a polygon is free in a scene.
#pragma once

#include <memory>
#include <optional>

#include "box.hpp"
#include "minkowski_region.hpp"
#include "query.hpp"
#include "scene.hpp"

namespace gcv {

// All positions of the polygon that `reflected` reflects where it lies in the container and
// overlaps no member, with a window those in that. Throws Error: as join_solids(); range,
// cancelled, internal.
Region free_region(const Scene& scene, const Query& query,
                   const std::shared_ptr<const Polygon>& reflected,
                   const std::optional<Box>& window, const RegionOptions& options, Task& task);

}  // namespace gcv
