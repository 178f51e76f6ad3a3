// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The parts of a region by its definition: an arrangement of the edges of all pieces of an open
// sum, with each edge and vertex classed by the open sum itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "open_sum.hpp"

namespace worlds {

// What a region shows: the open sum, or what it leaves free.
enum class Shown { sum, free };

// In canonical order; places.
struct Parts {
  struct Face {
    Ring outer;
    std::vector<Ring> holes;
  };
  std::vector<Face> faces;
  std::vector<Edge> segments;
  std::vector<Point> points;
};

// Of what is free, an unbounded face is left out.
Parts parts(const OpenSum& sum, Shown shown);

// One line for each part, with the exact vertices.
std::string text(const Parts& parts);

// The outer ring of the first polygon alone.
std::string outer_face_text(const Parts& parts);

// A way from a place to another one: (x / denominator, y / denominator).
struct Way {
  Int x;
  Int y;
  Int denominator;
  [[nodiscard]] Fraction square() const;
};

// The shortest way from a place to a part, of several the lexicographically smallest. The place is
// in halves of units.
std::optional<Way> shortest_way(const Parts& parts, Point halves);

}  // namespace worlds
