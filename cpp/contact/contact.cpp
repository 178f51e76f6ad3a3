// SPDX-License-Identifier: LGPL-3.0-or-later
#include "contact.hpp"

#include <cassert>

#include "predicates.hpp"

namespace gcv {

std::tuple<ContactKind, Index, Index> order_of(const PlacedPair& placed, const ContactName& name) {
  const Boundary::Corner& a = placed.a.boundary.corners[name.i];
  const Boundary::Corner& b = placed.b.boundary.corners[name.j];
  return {name.kind, name.kind == ContactKind::edge_vertex ? a.edge_number : a.vertex_number,
          name.kind == ContactKind::vertex_edge ? b.edge_number : b.vertex_number};
}

EdgeAndVertex edge_and_vertex(const PlacedPair& placed, const ContactName& name) {
  assert(name.kind != ContactKind::vertex_vertex);
  return name.kind == ContactKind::edge_vertex
             ? EdgeAndVertex{placed.a.edge(name.i), placed.b.vertex(name.j)}
             : EdgeAndVertex{placed.b.edge(name.j), placed.a.vertex(name.i)};
}

Nearest nearest_on(const EdgeAndVertex& pair, Tally& tally) {
  const SumEdge across = perpendicular(pair.edge, pair.vertex);
  if (side(across, pair.edge.origin, tally) <= 0) {
    return Nearest::start;
  }
  return side(across, pair.end(), tally) >= 0 ? Nearest::end : Nearest::inside;
}

ContactName features(const PlacedPair& placed, const ContactName& name, Nearest nearest) {
  const bool is_end = nearest == Nearest::end;
  if (nearest == Nearest::inside) {
    return name;
  }
  if (name.kind == ContactKind::edge_vertex) {
    return {ContactKind::vertex_vertex, is_end ? placed.a.next(name.i) : name.i, name.j};
  }
  return {ContactKind::vertex_vertex, name.i, is_end ? placed.b.next(name.j) : name.j};
}

Gap gap_between(const EdgeAndVertex& pair, Nearest nearest) {
  SumEdge edge = pair.edge;
  if (nearest == Nearest::end) {
    edge.origin = pair.end();
  }
  return {edge, pair.vertex, nearest == Nearest::inside};
}

Gap gap_of(const PlacedPair& placed, const ContactName& name, Tally& tally) {
  if (name.kind == ContactKind::vertex_vertex) {
    return {placed.a.edge(name.i), placed.b.vertex(name.j), false};
  }
  const EdgeAndVertex pair = edge_and_vertex(placed, name);
  return gap_between(pair, nearest_on(pair, tally));
}

Point outward_normal(const SumEdge& edge, Tally& tally) {
  const auto turned_right = [](const Point& p) { return Point{p.y, -p.x}; };
  return nearest_unit_vector({turned_right(edge.from), {0, 0}}, {turned_right(edge.to), {0, 0}},
                             tally);
}

Point normal_of(const PlacedPair& placed, const ContactName& name, Tally& tally) {
  const Point normal = outward_normal(edge_and_vertex(placed, name).edge, tally);
  return name.kind == ContactKind::edge_vertex ? normal : Point{0.0 - normal.x, 0.0 - normal.y};
}

Contact contact_of(const PlacedPair& placed, const ContactName& name, const Gap& gap,
                   Tally& tally) {
  if (!is_zero(gap, tally)) {
    return contact_across(placed, name, gap, tally);
  }
  Contact contact;
  std::tie(contact.kind, contact.a, contact.b) = order_of(placed, name);
  contact.on_a = nearest_point(gap.point, tally);
  contact.on_b = contact.on_a;
  if (name.kind != ContactKind::vertex_vertex) {
    contact.normal = normal_of(placed, name, tally);
  }
  return contact;
}

Contact contact_across(const PlacedPair& placed, const ContactName& name, const Gap& gap,
                       Tally& tally) {
  Contact contact;
  std::tie(contact.kind, contact.a, contact.b) = order_of(placed, name);
  contact.gap = nearest_gap(gap, tally);
  if (name.kind == ContactKind::vertex_vertex) {
    const SumPoint p = placed.a.vertex(name.i);
    const SumPoint q = placed.b.vertex(name.j);
    contact.normal = nearest_unit_vector(p, q, tally);
    contact.on_a = nearest_point(p, tally);
    contact.on_b = nearest_point(q, tally);
    return contact;
  }
  contact.normal = normal_of(placed, name, tally);
  const bool is_edge_of_a = name.kind == ContactKind::edge_vertex;
  (is_edge_of_a ? contact.on_a : contact.on_b) =
      gap.is_to_line ? nearest_crossing(gap.edge, perpendicular(gap.edge, gap.point), tally)
                     : nearest_point(gap.edge.origin, tally);
  (is_edge_of_a ? contact.on_b : contact.on_a) = nearest_point(gap.point, tally);
  return contact;
}

}  // namespace gcv
