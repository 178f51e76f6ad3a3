// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points, rings and polygons in integers.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace worlds {

using Int = std::int64_t;
__extension__ using Wide = __int128;

struct Point {
  Int x;
  Int y;
  auto operator<=>(const Point&) const = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator-(Point a) { return {-a.x, -a.y}; }
inline Point operator*(Int s, Point a) { return {s * a.x, s * a.y}; }
inline Int cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline Int dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }

// The shortest vector of integers in a direction.
Point primitive(Point direction);

// A ring, not closed. Of a polygon, the first ring is the outer one and the others are holes.
using Ring = std::vector<Point>;
using Polygon = std::vector<Ring>;

struct Edge {
  Point from;
  Point to;
};

std::vector<Edge> edges(const Polygon& polygon);

// The lower left and the upper right corner of the box of points.
std::pair<Point, Point> bounds(const std::vector<Point>& points);

// Twice the area; positive where the ring is counter-clockwise.
Wide twice_area(const Ring& ring);

// Is a point, which lies on no edge, inside by the even-odd rule?
bool is_inside(const Polygon& polygon, Point p);

// Does a ring neither touch nor cross itself, and has it a corner at each vertex?
bool is_simple(const Ring& ring);

// Do the rings lie as a polygon allows? Each of them is simple.
bool is_valid(const Polygon& polygon);

// A convex polygon, counter-clockwise; or two points, a segment.
using Convex = std::vector<Point>;

// Do the interiors of two convex polygons meet, or that of one and a segment?
bool meet(const Convex& a, const Convex& b);

// Triangles that make up a polygon, without overlaps; or rectangles, where all edges are upright or
// level.
std::vector<Convex> inner_pieces(const Polygon& polygon);

// Convex polygons that make up all that is outside of a polygon but in its box.
std::vector<Convex> outer_pieces(const Polygon& polygon);

// Four boxes round the box of a polygon, as wide as what is looked at.
std::vector<Convex> surroundings(const Polygon& polygon);

Polygon reflected(const Polygon& polygon);
Polygon moved(const Polygon& polygon, Point by);

// As Well-Known Text.
std::string text(const Polygon& polygon);

}  // namespace worlds
