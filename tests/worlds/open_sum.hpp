// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The open sum of two sets that are made up of convex pieces: int A + int B is the union of the
// interiors of the sums of a piece of A and a piece of B. For x lies in it just when the interiors
// of A and x - B meet; they are open, and the interiors of the pieces leave out nothing that is.
#pragma once

#include <vector>

#include "fractions.hpp"
#include "plane.hpp"

namespace worlds {

// Places are integers, in parts of a unit: a multiple of all determinants of two primitive
// directions with coordinates up to 4, and twice that, so that means of two crossings are places.
inline constexpr Int kUnit = Int{2} * 26'771'144'400;
inline constexpr int kLongest = 4;

// The line of an edge: its left side is where `cross(direction, p - from)` is positive.
struct Line {
  Point from;
  Point direction;
  [[nodiscard]] Int side(Point p) const { return cross(direction, p - from); }
};

// An edge of a piece, from the lexicographically smaller end on.
struct Segment {
  Point from;
  Point direction;
  Int length;
  auto operator<=>(const Segment&) const = default;
};

class OpenSum {
 public:
  // Adds the sums of all pieces.
  void add(const std::vector<Convex>& a, const std::vector<Convex>& b);

  // Adds what another sum holds.
  void add(const OpenSum& other);

  [[nodiscard]] bool holds(Point place) const;

  // Is a place in the closed sum?
  [[nodiscard]] bool reaches(Point place) const;

  // How the inner points of an edge lie, and what is directly on its left and on its right: in the
  // open sum or free. No other edge passes through `middle`.
  struct Sides {
    bool left;
    bool on;
    bool right;
  };
  [[nodiscard]] Sides sides(Point middle, Point direction) const;

  // The edges of all pieces, each once, in units.
  [[nodiscard]] std::vector<Segment> segments() const;

  // The square of the distance of a place from the closed sum; places are halves of units here.
  [[nodiscard]] Fraction squared_distance(Point halves) const;

 private:
  std::vector<Convex> pieces_;
  std::vector<std::vector<Line>> lines_;
};

}  // namespace worlds
