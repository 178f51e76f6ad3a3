// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Free regions, best positions and ways out of scenes against one another and the relation. Each
// check gives a sentence for every difference.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "scene_agreement.hpp"

namespace gcv::test {

using RegionHandle = std::unique_ptr<gcv_region, invariants::Destroy>;
using Window = std::optional<std::array<double, 4>>;

// One exact ring, segment or point.
struct ExactPart {
  std::int32_t kind;
  invariants::Ring points;
};
using ExactParts = std::vector<ExactPart>;

ExactParts exact_parts(const gcv_region* region);

struct FreeCounts {
  ContactCounts contacts;
  std::size_t polygons = 0;
  std::size_t holes = 0;
  std::size_t segments = 0;
  std::size_t points = 0;
  std::size_t inside = 0;  // places
  std::size_t boundary = 0;
  std::size_t outside = 0;
  std::size_t on_border = 0;  // of a window
  std::size_t fits_in_window = 0;
  std::size_t ties = 0;  // several positions that are as good
  std::size_t none = 0;  // nothing is free
};

// A scene, and what is asked about it.
struct FreeQuestion {
  const CheckedScene& scene;
  const MovingPolygon& moving;
  const gcv_query* query;

  [[nodiscard]] RegionHandle region(const Window& window) const;
};

// In the interior of the region the polygon is apart from all, on its boundary it touches, outside
// of it it overlaps; but for the border of the window.
Messages check_places(const FreeQuestion& question, const gcv_region* region, const Window& window,
                      const Points& places, FreeCounts& counts);

// The fits in a window are those of the whole region, as far as they lie in it.
Messages check_fits(const ExactParts& whole, const gcv_region* region, const Window& window,
                    FreeCounts& counts);

// By all vertices of the whole region.
Messages check_best(const FreeQuestion& question, const ExactParts& whole, const Points& directions,
                    FreeCounts& counts);

// By all edges of the whole region.
Messages check_ways_out(const FreeQuestion& question, const ExactParts& whole,
                        const Points& positions, FreeCounts& counts);

}  // namespace gcv::test
