// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solid_sectors.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace gcv::reference {

namespace {

using invariants::cross;
using invariants::dot;
using invariants::on_segment;

Exact negated(const Exact& p) { return {-p.x, -p.y}; }

// By the angle in [0, 2 pi).
bool comes_before(const Exact& p, const Exact& q) {
  const auto is_up = [](const Exact& d) { return d.y > 0 || (d.y == 0 && d.x > 0); };
  return is_up(p) != is_up(q) ? is_up(p) : cross(p, q) > 0;
}

struct MarkedRay {
  BoundaryRay ray;
  bool begins_sector;
};

bool is_reflex(const Sector& s) { return cross(s.first.direction, s.last.direction) < 0; }

// A direction strictly inside a sector that is not reflex.
Exact middle(const Sector& s) {
  const Exact& p = s.first.direction;
  const Exact& q = s.last.direction;
  return cross(p, q) == 0 ? Exact{-p.y, p.x} : p + q;
}

// Do all of them lie in some closed half-plane through 0? If so, then in one with one of them on
// its border.
bool lie_in_half_plane(const std::vector<Exact>& directions) {
  for (const Exact& p : directions) {
    for (const Exact& normal : {Exact{p.y, -p.x}, Exact{-p.y, p.x}}) {
      if (!(p == Exact{0, 0}) && std::all_of(directions.begin(), directions.end(),
                                             [&](const Exact& q) { return dot(q, normal) <= 0; })) {
        return true;
      }
    }
  }
  return false;
}

// Sectors that are not reflex are convex: their interiors are apart exactly if a line is between
// them. It may go through the point of a.
bool convex_sectors_meet(const Sector& a, const Sector& b, const Exact& d) {
  return !lie_in_half_plane({a.first.direction, a.last.direction, middle(a),
                             negated(b.first.direction), negated(b.last.direction),
                             negated(middle(b)), negated(d)});
}

// b lies in the convex complement of a exactly if its point and its two rays do.
bool leaves_complement(const Sector& a, const Sector& b, const Exact& d) {
  const Exact& p = a.last.direction;
  const Exact& q = a.first.direction;
  const auto is_in = [&](const Exact& x) { return cross(p, x) >= 0 && cross(x, q) >= 0; };
  return is_reflex(b) || !is_in(b.first.direction) || !is_in(b.last.direction) || !is_in(d);
}

bool sectors_meet(const Sector& a, const Sector& b, const Exact& d) {
  if (is_reflex(a)) {
    return leaves_complement(a, b, d);
  }
  if (is_reflex(b)) {
    return leaves_complement(b, a, negated(d));
  }
  return convex_sectors_meet(a, b, d);
}

std::optional<Contact> contact_between(const Solid& a, const BoundaryRay& p, const Solid& b,
                                       const BoundaryRay& q) {
  if (p.is_of_edge && q.is_of_edge) {
    return {};
  }
  if (p.is_of_edge) {
    return contact_of(a.edges[p.index], b.corners[q.index]);
  }
  return q.is_of_edge ? contact_of(a.corners[p.index], b.edges[q.index])
                      : contact_of(a.corners[p.index], b.corners[q.index]);
}

// By feature, each once.
void sort_once(std::vector<Contact>& contacts) {
  std::sort(contacts.begin(), contacts.end(),
            [](const Contact& c, const Contact& e) { return c.feature < e.feature; });
  const auto same =
      std::unique(contacts.begin(), contacts.end(),
                  [](const Contact& c, const Contact& e) { return c.feature == e.feature; });
  contacts.erase(same, contacts.end());
}

// The half-planes of edges and the corners at x, of each ring alone. Where rings touch they
// overlap.
std::vector<Sector> sectors_of_rings_at(const Solid& solid, const Exact& x) {
  std::vector<Sector> sectors;
  for (std::size_t k = 0; k < solid.edges.size(); ++k) {
    if (is_inside_edge(solid.edges[k], x)) {
      sectors.push_back({{solid.edges[k].to - x, true, k}, {solid.edges[k].from - x, true, k}});
    }
    if (solid.corners[k].place == x) {
      sectors.push_back(
          {{solid.corners[k].after - x, false, k}, {solid.corners[k].before - x, false, k}});
    }
  }
  return sectors;
}

// The features of a sector at x: those on its border; where rings touch, all corners there.
std::vector<BoundaryRay> features(const Solid& solid, const Sector& sector, const Exact& x) {
  const std::vector<Sector> of_rings = sectors_of_rings_at(solid, x);
  if (of_rings.size() == 1) {
    return {sector.first};  // the last ray has the same
  }
  std::vector<BoundaryRay> corners;
  for (const Sector& s : of_rings) {
    if (!s.first.is_of_edge) {
      corners.push_back(s.first);
    }
  }
  return corners;
}

}  // namespace

std::vector<Sector> sectors_at(const Solid& solid, const Exact& x) {
  std::vector<MarkedRay> rays;
  for (const Sector& s : sectors_of_rings_at(solid, x)) {
    rays.push_back({s.first, true});
    rays.push_back({s.last, false});
  }
  std::sort(rays.begin(), rays.end(), [](const MarkedRay& p, const MarkedRay& q) {
    return comes_before(p.ray.direction, q.ray.direction);
  });
  std::vector<Sector> sectors;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const MarkedRay& after = rays[(k + 1) % rays.size()];
    if (rays[k].begins_sector == after.begins_sector) {
      throw std::logic_error("no polygon has such rays at a point");
    }
    if (rays[k].begins_sector) {
      sectors.push_back({rays[k].ray, after.ray});
    }
  }
  return sectors;
}

bool meet_after(const Sector& a, const Sector& b, const Exact& d) {
  if (sectors_meet(a, b, {0, 0})) {
    throw std::logic_error("sectors that overlap without a motion");
  }
  return sectors_meet(a, b, d);
}

std::vector<Exact> contact_points(const Solid& a, const Solid& b) {
  std::vector<Exact> points;
  const auto take = [&](const Solid& of_corners, const Solid& of_edges) {
    for (const Corner& corner : of_corners.corners) {
      for (const Edge& edge : of_edges.edges) {
        if (on_segment(edge.from, edge.to, corner.place)) {
          points.push_back(corner.place);
        }
      }
    }
  };
  take(a, b);
  take(b, a);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

EnteredContacts entered_contacts(const Solid& a, const Solid& b, const Exact& d) {
  EnteredContacts result;
  for (const Exact& x : contact_points(a, b)) {
    std::vector<Contact> here;
    for (const Sector& s : sectors_at(a, x)) {
      for (const Sector& u : sectors_at(b, x)) {
        if (!meet_after(s, u, d)) {
          continue;
        }
        for (const BoundaryRay& p : features(a, s, x)) {
          for (const BoundaryRay& q : features(b, u, x)) {
            if (const auto contact = contact_between(a, p, b, q)) {
              here.push_back(*contact);
            }
          }
        }
      }
    }
    sort_once(here);
    if (sectors_of_rings_at(a, x).size() == 1 && sectors_of_rings_at(b, x).size() == 1) {
      result.contacts.insert(result.contacts.end(), here.begin(), here.end());
    } else if (!here.empty()) {
      result.where_rings_touch.push_back(here);
    }
  }
  sort_once(result.contacts);
  return result;
}

}  // namespace gcv::reference
