// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A contact: a feature of A and one of B that touch, or would if B were moved.
#pragma once

#include <cstdint>
#include <tuple>

#include "gap.hpp"
#include "polygon_pair.hpp"

namespace gcv {

// The values are those of gcv.h.
enum class ContactKind : std::int32_t {
  none = 0,
  edge_vertex = 1,  // an edge of A and a vertex of B
  vertex_edge = 2,
  vertex_vertex = 3,
};

// The vertices or edges of a contact: i of A, j of B.
struct ContactName {
  ContactKind kind;
  Index i;
  Index j;

  friend bool operator==(const ContactName&, const ContactName&) = default;
};

// A contact as the caller gets it.
struct Contact {
  ContactKind kind = ContactKind::none;
  Index a = 0;  // the caller's numbers
  Index b = 0;
  double gap = 0;  // the distance of the features, correctly rounded
  Point normal{0, 0};
  Point on_a{0, 0};
  Point on_b{0, 0};
};

// The caller's numbers of the features, after the kind: contacts are in this order.
std::tuple<ContactKind, Index, Index> order_of(const PlacedPair& placed, const ContactName& name);

// The feature of a contact that is an edge, and the other one, a vertex.
struct EdgeAndVertex {
  SumEdge edge;
  SumPoint vertex;

  [[nodiscard]] SumPoint end() const { return {edge.to, edge.origin.b}; }
};
// Not for two vertices.
EdgeAndVertex edge_and_vertex(const PlacedPair& placed, const ContactName& name);

// The point of a closed edge that is nearest to a point: one of its ends, or the foot of the
// perpendicular between them. Exact.
enum class Nearest { start, inside, end };
Nearest nearest_on(const EdgeAndVertex& pair, Tally& tally);
// The contact of the vertex and that point.
ContactName features(const PlacedPair& placed, const ContactName& name, Nearest nearest);

// The distance between the vertex and that point of the edge.
Gap gap_between(const EdgeAndVertex& pair, Nearest nearest);
// The same for any contact.
Gap gap_of(const PlacedPair& placed, const ContactName& name, Tally& tally);

// The outward normal of an edge: a unit vector to its right, each coordinate within an ulp.
Point outward_normal(const SumEdge& edge, Tally& tally);
// The normal of the edge of a contact, from A to B. Not for two vertices.
Point normal_of(const PlacedPair& placed, const ContactName& name, Tally& tally);

// The contact with its points and its normal. The gap must be its own.
Contact contact_of(const PlacedPair& placed, const ContactName& name, const Gap& gap, Tally& tally);
// The same, where the gap is not zero.
Contact contact_across(const PlacedPair& placed, const ContactName& name, const Gap& gap,
                       Tally& tally);

}  // namespace gcv
