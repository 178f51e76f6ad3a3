// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The rings of a region on their way to doubles, and how they become valid: simple, turned as they
// are to, not crossing each other, holes in their polygons.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "region.hpp"
#include "tally.hpp"

namespace gcv {

struct RoundingRing {
  const RegionPart* part;
  bool is_fixed = false;  // it stays as it is
  bool is_dropped = false;
  // Its vertices, where these are no longer the places of the exact ones.
  std::optional<PointVector> replaced = {};
};

struct RegionRings {
  const ExactRegion& region;
  std::vector<RoundingRing> rings = {};
  PointVector nearest = {};  // of all vertices of the region
  PointVector places = {};
  double error_bound = 0;  // of the nearest doubles, and of an outer face
  double furthest = 0;     // that a vertex was moved
  double displaced = 0;    // that a ring was, by snap rounding
  double lost = 0;         // with what was dropped
  std::uint64_t repaired = 0;
  std::uint64_t dropped = 0;

  [[nodiscard]] std::span<const Point> places_of(const RegionPart& part) const {
    return std::span<const Point>(places).subspan(part.first, part.size);
  }
};

// Moves vertices by a few units in the last place, and drops what stays in the way. See
// region_rounding.hpp.
void make_valid(RegionRings& rings, Tally& tally);

}  // namespace gcv
