// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Well-Known Text of one polygon, without locale.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "point.hpp"

namespace gcv {

// The outer ring of "POLYGON ((x y, ...), (hole), ...)". Holes are checked to be rings
// of at least three vertices with finite coordinates, and left out.
// Throws Error: parse with the byte offset, not_finite, degenerate (POLYGON EMPTY).
PointVector parse_polygon(std::string_view text, const char* name);

// "POLYGON ((x y, ..., x y))", closed, with the fewest digits that read back the same.
std::string format_polygon(std::span<const Point> ring);

}  // namespace gcv
