// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Well-Known Text of one polygon. Does not depend on the locale.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "point.hpp"

namespace gcv {

// Reads "POLYGON ((x y, ...), (hole), ...)". Returns the rings as they are in the text, the outer
// ring first. The coordinates are finite. A hole has at least three vertices besides the closing
// one. Throws Error: parse with the byte offset, not_finite, degenerate (POLYGON EMPTY).
std::vector<PointVector> parse_polygon(std::string_view text, const char* name);

// Writes "POLYGON ((x y, ..., x y))", closed. Each number has the shortest form that reads back to
// it.
std::string format_polygon(std::span<const Point> ring);

// Parts of texts, in such numbers. "x y", and "(x y, ..., x y)", closed.
void append_point(std::string& text, const Point& point);
void append_ring(std::string& text, std::span<const Point> ring);

}  // namespace gcv
