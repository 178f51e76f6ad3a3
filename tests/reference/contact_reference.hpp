// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Two polygons by their definitions, in fractions: relation, distance, contacts. Every pair of
// edges and vertices is looked at. Nothing is known of supersets or trees.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid.hpp"

namespace gcv::reference {

// As gcv.h has them.
constexpr int apart = 1;
constexpr int touching = 0;
constexpr int overlapping = -1;
constexpr int edge_vertex = 1;
constexpr int vertex_edge = 2;
constexpr int vertex_vertex = 3;

// Of several, the smallest counts.
struct Feature {
  int kind;
  std::uint32_t a;
  std::uint32_t b;

  friend auto operator<=>(const Feature&, const Feature&) = default;
};

// A pair of features, b moved. The normal has any length, or is 0 where two vertices coincide.
struct Contact {
  Feature feature;
  Rational squared_gap;
  bool is_deep;  // the gap counts as negative
  Exact normal;
  Exact on_a;
  Exact on_b;
};

// The gap is the distance of the vertex from the closed edge. It is deep where the vertex is
// strictly on the solid side of the edge's line.
Contact contact_of(const Edge& a, const Corner& b);
Contact contact_of(const Corner& a, const Edge& b);
Contact contact_of(const Corner& a, const Corner& b);

// Do the interiors of a and b meet? Decided in two ways that share nothing but the location of
// points. Throws std::logic_error where they differ.
bool overlap(const Solid& a, const Solid& b);

int relation(const Solid& a, const Solid& b);

struct Separation {
  int relation;
  Rational squared_distance;
  std::optional<Contact> nearest;  // none where they touch or overlap
};

Separation separation(const Solid& a, const Solid& b);

// The contacts that Definition 1 admits for touching, or would after a turn by an angle whose
// tangent is at most `slope`, with |gap| <= distance. By |gap|, then by feature.
std::vector<Contact> contacts(const Solid& a, const Solid& b, const Rational& distance,
                              const Rational& slope);

}  // namespace gcv::reference
