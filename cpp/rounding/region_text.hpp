// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Well-Known Text of a region in doubles. Each number has the shortest form that reads back to it.
// Does not depend on the locale.
#pragma once

#include <string>

#include "region.hpp"

namespace gcv {

// The polygons: "MULTIPOLYGON (((x y, ..., x y), (hole), ...), ...)", closed, or "MULTIPOLYGON
// EMPTY".
std::string format_polygons(const RoundedRegion& region);

// The segments and points: "GEOMETRYCOLLECTION (LINESTRING (x y, x y), ..., POINT (x y), ...)", or
// "GEOMETRYCOLLECTION EMPTY".
std::string format_fits(const RoundedRegion& region);

}  // namespace gcv
