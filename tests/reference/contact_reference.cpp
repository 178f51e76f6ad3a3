// SPDX-License-Identifier: LGPL-3.0-or-later
#include "contact_reference.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <tuple>

namespace gcv::reference {

namespace {

using invariants::cross;
using invariants::dot;
using invariants::orientation;
using invariants::segments_meet;

Exact negated(const Exact& p) { return {-p.x, -p.y}; }

bool boxes_meet(const Edge& e, const Edge& f) {
  const auto meet = [](const Rational& a, const Rational& b, const Rational& c, const Rational& d) {
    return std::min(a, b) <= std::max(c, d) && std::min(c, d) <= std::max(a, b);
  };
  return meet(e.from.x, e.to.x, f.from.x, f.to.x) && meet(e.from.y, e.to.y, f.from.y, f.to.y);
}

// Adds the places that cut e where f meets it: a crossing, or the ends of what they have in common.
void cut(const Edge& e, const Edge& f, std::vector<Exact>& places) {
  if (!boxes_meet(e, f) || !segments_meet(e.from, e.to, f.from, f.to)) {
    return;
  }
  const Exact along = e.to - e.from;
  const Rational denominator = cross(along, f.to - f.from);
  if (denominator != 0) {
    places.push_back(e.from + (cross(f.from - e.from, f.to - f.from) / denominator) * along);
    return;
  }
  for (const Exact& end : {f.from, f.to}) {
    if (is_inside_edge(e, end)) {
      places.push_back(end);
    }
  }
}

// Is some point of the boundary of b strictly inside a? The boundary of a cuts each edge of b into
// pieces; each piece is inside, outside or on the boundary of a as a whole.
bool boundary_enters(const Solid& b, const Solid& a) {
  for (const Edge& e : b.edges) {
    std::vector<Exact> places{e.from, e.to};
    for (const Edge& f : a.edges) {
      cut(e, f, places);
    }
    std::sort(places.begin(), places.end());
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      if (!(places[k] == places[k + 1]) &&
          location(a, Rational(1, 2) * (places[k] + places[k + 1])) > 0) {
        return true;
      }
    }
  }
  return false;
}

// If the interiors meet and no boundary of b enters a, then a whole component of the interior of a
// lies in b.
bool overlap_by(const Solid& a, const Solid& b) {
  return boundary_enters(b, a) || std::any_of(a.inner_points.begin(), a.inner_points.end(),
                                              [&](const Exact& x) { return location(b, x) > 0; });
}

// Would the corner touch the edge from its right side after a turn by at most `slope`? Without a
// turn: it is convex, and no edge of it leads to the left.
bool admits(const Edge& edge, const Corner& corner, const Rational& slope) {
  if (!corner.is_convex()) {
    return false;
  }
  const Exact along = edge.to - edge.from;
  const Exact forwards = corner.after - corner.place;
  const Exact backwards = corner.before - corner.place;
  if (cross(along, forwards) <= 0 && cross(along, backwards) <= 0) {
    return true;
  }
  // Turned as little as possible, one edge of the corner comes to lie on the line: the one that
  // starts at the corner runs against the edge then, the one that ends there along it.
  const auto is_near = [&](const Exact& p, const Exact& q) {
    return dot(p, q) > 0 && abs(cross(p, q)) <= slope * dot(p, q);
  };
  return is_near(forwards, negated(along)) || is_near(backwards, along);
}

}  // namespace

Contact contact_of(const Edge& a, const Corner& b) {
  const Exact along = a.to - a.from;
  const Rational t = dot(b.place - a.from, along) / dot(along, along);
  const Exact foot = a.from + std::clamp<Rational>(t, 0, 1) * along;
  const Exact rest = b.place - foot;
  return {{edge_vertex, a.number, b.number},
          dot(rest, rest),
          orientation(a.from, a.to, b.place) > 0,
          {along.y, -along.x},
          foot,
          b.place};
}

Contact contact_of(const Corner& a, const Edge& b) {
  Contact contact = contact_of(b, a);
  contact.feature = {vertex_edge, a.number, b.number};
  contact.normal = negated(contact.normal);
  std::swap(contact.on_a, contact.on_b);
  return contact;
}

Contact contact_of(const Corner& a, const Corner& b) {
  const Exact way = b.place - a.place;
  return {{vertex_vertex, a.number, b.number}, dot(way, way), false, way, a.place, b.place};
}

bool overlap(const Solid& a, const Solid& b) {
  const bool one_way = overlap_by(a, b);
  if (one_way != overlap_by(b, a)) {
    throw std::logic_error("the references for overlaps differ");
  }
  return one_way;
}

int relation(const Solid& a, const Solid& b) {
  if (overlap(a, b)) {
    return overlapping;
  }
  for (const Edge& e : a.edges) {
    for (const Edge& f : b.edges) {
      if (boxes_meet(e, f) && segments_meet(e.from, e.to, f.from, f.to)) {
        return touching;
      }
    }
  }
  return apart;
}

Separation separation(const Solid& a, const Solid& b) {
  Separation result{relation(a, b), 0, {}};
  if (result.relation != apart) {
    return result;
  }
  const auto take = [&](const Contact& c) {
    if (!result.nearest || std::tie(c.squared_gap, c.feature) <
                               std::tie(result.nearest->squared_gap, result.nearest->feature)) {
      result.nearest = c;
    }
  };
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    for (std::size_t j = 0; j < b.corners.size(); ++j) {
      const Contact on_edge_of_a = contact_of(a.edges[i], b.corners[j]);
      if (is_inside_edge(a.edges[i], on_edge_of_a.on_a)) {
        take(on_edge_of_a);
      }
      const Contact on_edge_of_b = contact_of(a.corners[i], b.edges[j]);
      if (is_inside_edge(b.edges[j], on_edge_of_b.on_b)) {
        take(on_edge_of_b);
      }
      take(contact_of(a.corners[i], b.corners[j]));
    }
  }
  result.squared_distance = result.nearest->squared_gap;
  return result;
}

std::vector<Contact> contacts(const Solid& a, const Solid& b, const Rational& distance,
                              const Rational& slope) {
  std::vector<Contact> result;
  const auto take = [&](const Contact& c) {
    if (c.squared_gap <= distance * distance) {
      result.push_back(c);
    }
  };
  const auto edge_behind = [](const Corner& c) { return Edge{c.place, c.after, c.number}; };
  const auto edge_before = [](const Corner& c) { return Edge{c.before, c.place, c.number}; };
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    for (std::size_t j = 0; j < b.corners.size(); ++j) {
      const Corner& p = a.corners[i];
      const Corner& q = b.corners[j];
      if (admits(a.edges[i], q, slope)) {
        take(contact_of(a.edges[i], q));
      }
      if (admits(b.edges[j], p, slope)) {
        take(contact_of(p, b.edges[j]));
      }
      if (p.is_convex() && q.is_convex() &&
          (admits(edge_behind(p), q, slope) || admits(edge_before(p), q, slope) ||
           admits(edge_behind(q), p, slope) || admits(edge_before(q), p, slope))) {
        take(contact_of(p, q));
      }
    }
  }
  std::sort(result.begin(), result.end(), [](const Contact& c, const Contact& d) {
    return std::tie(c.squared_gap, c.feature) < std::tie(d.squared_gap, d.feature);
  });
  return result;
}

}  // namespace gcv::reference
