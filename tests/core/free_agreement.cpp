// SPDX-License-Identifier: LGPL-3.0-or-later
#include "free_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "correct_rounding.hpp"
#include "exact_vertices.hpp"

namespace gcv::test {

namespace {

using invariants::exact;
using invariants::require;
using reference::Exact;
using reference::Rational;

gcv_status vertices_of(const gcv_region* region, Point* out, std::size_t capacity,
                       std::size_t* required) {
  return gcv_region_vertices(region, out == nullptr ? nullptr : out->data(), capacity, required);
}

void count_parts(const ExactParts& parts, FreeCounts& counts) {
  for (const ExactPart& part : parts) {
    std::size_t* const of_kind[] = {&counts.polygons, &counts.holes, &counts.segments,
                                    &counts.points};
    ++*of_kind[part.kind - 1];
  }
}

// Strictly outside of the window (-1), on its border (0), or inside.
int location_in(const Window& window, const Point& p) {
  if (!window) {
    return 1;
  }
  const auto& [x0, y0, x1, y1] = *window;
  if (p[0] < x0 || p[0] > x1 || p[1] < y0 || p[1] > y1) {
    return -1;
  }
  return p[0] == x0 || p[0] == x1 || p[1] == y0 || p[1] == y1 ? 0 : 1;
}

// On the border of a window, what touches is there only if there is something free beside it in the
// window, or if it is an exact fit.
bool may_lie(int located, int relation, int in_window) {
  if (in_window < 0 || relation == reference::overlapping) {
    return located == GCV_OUTSIDE;
  }
  if (in_window == 0) {
    return located == GCV_BOUNDARY || (located == GCV_OUTSIDE && relation == reference::touching);
  }
  return located == (relation == reference::touching ? GCV_BOUNDARY : GCV_INSIDE);
}

RelationAt relation_in(const PlacedSolids& solids, const MovingPolygon& moving) {
  return [&solids, &moving](const Exact& t) {
    return relation_to_all(solids, moved_there(moving, t));
  };
}

// Is it within 2^12 units in the last place, where none is free within 2 of them?
std::string distant_position_difference(const RelationAt& relation_at, const Point& got,
                                        const Exact& wanted, FreeCounts& counts) {
  const Point nearest = invariants::nearest(wanted);
  for (const std::size_t k : {0U, 1U}) {
    const double unit =
        std::nextafter(std::max(std::abs(nearest[0]), std::abs(nearest[1])), HUGE_VAL) -
        std::max(std::abs(nearest[0]), std::abs(nearest[1]));
    if (std::abs(got[k] - nearest[k]) > 0x1p13 * unit) {
      return "position " + text_of(got) + ", not near " + text_of(nearest);
    }
  }
  // One that is not found has none near it that is free.
  const int relation = relation_at(exact(got));
  return relation == reference::overlapping
             ? position_difference(relation_at, got.data(), relation, wanted, counts.contacts)
             : position_difference(relation_at, nearest.data(), reference::overlapping, wanted,
                                   counts.contacts);
}

bool is_within_two_units(double x, const Rational& wanted) {
  const double least = std::nextafter(std::nextafter(x, -HUGE_VAL), -HUGE_VAL);
  return Rational(least) <= wanted &&
         wanted <= Rational(std::nextafter(std::nextafter(x, HUGE_VAL), HUGE_VAL));
}

std::string best_difference(const RelationAt& relation_at, const Point& got, const Exact& wanted,
                            FreeCounts& counts) {
  const int relation = relation_at(exact(got));
  const bool is_near =
      is_within_two_units(got[0], wanted.x) && is_within_two_units(got[1], wanted.y);
  return is_near ? position_difference(relation_at, got.data(), relation, wanted, counts.contacts)
                 : distant_position_difference(relation_at, got, wanted, counts);
}

// Is a double near the place free?
bool is_shown(const RelationAt& relation_at, const Exact& p) {
  ContactCounts none;
  return !position_difference(relation_at, invariants::nearest(p).data(), reference::overlapping, p,
                              none)
              .empty();
}

// The furthest point, of several the lexicographically smallest; of fits, those alone that doubles
// show, if there is a relation.
std::optional<Exact> furthest(const ExactParts& whole, const Point& direction,
                              const std::optional<RelationAt>& relation_at, FreeCounts& counts) {
  std::optional<Exact> found;
  for (const ExactPart& part : whole) {
    const bool is_fit = part.kind >= GCV_PART_SEGMENT;
    for (const Exact& p : part.points) {
      const int order = found ? sign(dot(exact(direction), p - *found)) : 1;
      const bool is_further = order > 0 || (order == 0 && p < *found);
      counts.ties += order == 0 && !(p == *found) ? 1 : 0;
      if (is_further && (!is_fit || !relation_at || is_shown(*relation_at, p))) {
        found = p;
      }
    }
  }
  return found;
}

std::vector<Exact> corners(const ExactParts& whole) {
  std::vector<Exact> all;
  for (const ExactPart& part : whole) {
    all.insert(all.end(), part.points.begin(), part.points.end());
  }
  return all;
}

// Does it overlap, though a double near a corner is free?
bool overlaps_needlessly(const ExactParts& whole, const RelationAt& relation_at, const Point& got) {
  const std::vector<Exact> all = corners(whole);
  return relation_at(exact(got)) == reference::overlapping &&
         std::any_of(all.begin(), all.end(),
                     [&](const Exact& p) { return is_shown(relation_at, p); });
}

// Is it a free position near a corner, and has no corner that is further a free double near it?
bool passes_over(const ExactParts& whole, const Point& direction, const RelationAt& relation_at,
                 const Point& got) {
  const std::vector<Exact> all = corners(whole);
  return relation_at(exact(got)) != reference::overlapping &&
         std::any_of(all.begin(), all.end(), [&](const Exact& p) {
           FreeCounts none;
           return best_difference(relation_at, got, p, none).empty() &&
                  std::none_of(all.begin(), all.end(), [&](const Exact& q) {
                    const int order = sign(dot(exact(direction), q - p));
                    return (order > 0 || (order == 0 && q < p)) && is_shown(relation_at, q);
                  });
         });
}

// The point of the segment that is nearest.
Exact nearest_on(const Exact& p, const Exact& q, const Exact& x) {
  const Exact d = q - p;
  const Rational size = dot(d, d);
  const Rational t = size == 0 ? Rational(0) : Rational(dot(x - p, d) / size);
  return p + std::clamp<Rational>(t, 0, 1) * d;
}

// The shortest vector from there to what is free, of several the lexicographically smallest.
std::optional<Exact> way_out(const ExactParts& whole, const Exact& from, FreeCounts& counts) {
  std::optional<Exact> best;
  for (const ExactPart& part : whole) {
    for (std::size_t k = 0; k < part.points.size(); ++k) {
      const Exact way = nearest_on(part.points[k], invariants::next(part.points, k), from) - from;
      const Rational size = dot(way, way);
      const bool is_tie = best && size == dot(*best, *best) && !(way == *best);
      counts.ties += is_tie ? 1 : 0;
      if (!best || size < dot(*best, *best) || (is_tie && way < *best)) {
        best = way;
      }
    }
  }
  return best;
}

// The smallest id that has a contact of an edge and a vertex there, and its smallest one. Where
// none has, for rings of all touch, the smallest id.
struct Touched {
  Ids ids;
  std::optional<reference::Contact> contact;
};

Touched touched_at(const PlacedSolids& solids, const PlacedSolid& there) {
  Touched touched;
  for (const PlacedSolid* solid : solids) {
    if (squared_box_gap(*solid, there) > 0) {
      continue;
    }
    std::optional<reference::Contact> first;
    for (const reference::Contact& c : contacts(solid->solid, there.solid, 0, 0)) {
      if (c.feature.kind != reference::vertex_vertex && (!first || c.feature < first->feature)) {
        first = c;
      }
    }
    if (first) {
      return {{solid->id, 0}, first};
    }
    if (touched.ids.a == 0 && relation_of(*solid, there) == reference::touching) {
      touched.ids.a = solid->id;
    }
  }
  return touched;
}

std::string stuck_difference(const gcv_escape& got, const Point& position) {
  const bool stays = std::isinf(got.depth) && got.depth > 0 && got.translation[0] == 0 &&
                     got.translation[1] == 0 && got.position[0] == position[0] &&
                     got.position[1] == position[1] && got.relation == GCV_OVERLAPPING;
  return stays ? contact_difference(got.contact, nullptr) : "a way out, where nothing is free";
}

}  // namespace

ExactParts exact_parts(const gcv_region* region) {
  const auto parts = invariants::elements(gcv_region_exact_parts, region);
  std::size_t count = 0;
  for (const gcv_region_part& part : parts) {
    count += part.vertex_count;
  }
  const invariants::Ring all = invariants::exact_points(
      count, [&](auto... arguments) { return gcv_region_exact_vertex(region, arguments...); });
  ExactParts result;
  auto from = all.begin();
  for (const gcv_region_part& part : parts) {
    const auto end = from + static_cast<std::ptrdiff_t>(part.vertex_count);
    result.push_back({part.kind, {from, end}});
    from = end;
  }
  return result;
}

RegionHandle FreeQuestion::region(const Window& window) const {
  gcv_region* out = nullptr;
  require(gcv_scene_free_region(scene.handle, moving.handle, window ? window->data() : nullptr,
                                query, nullptr, &out),
          "a free region");
  return RegionHandle(out);
}

Messages check_places(const FreeQuestion& question, const gcv_region* region, const Window& window,
                      const Points& places, FreeCounts& counts) {
  count_parts(exact_parts(region), counts);
  Points all = places;
  for (const Point& p : invariants::elements(vertices_of, region)) {
    all.push_back(p);
  }
  std::vector<std::int8_t> relations(all.size());
  std::vector<std::int8_t> located(all.size());
  require(gcv_scene_relation(question.scene.handle, question.moving.handle, all.front().data(),
                             all.size(), question.query, nullptr, relations.data()),
          "relations");
  require(gcv_region_locate(region, all.front().data(), all.size(), located.data()), "locations");
  Messages messages;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const int in_window = location_in(window, all[k]);
    std::size_t& count = located[k] == GCV_INSIDE     ? counts.inside
                         : located[k] == GCV_BOUNDARY ? counts.boundary
                                                      : counts.outside;
    ++count;
    counts.on_border += in_window == 0 ? 1 : 0;
    if (!may_lie(located[k], relations[k], in_window)) {
      report(messages, all[k],
             "located " + std::to_string(located[k]) + ", with the relation " +
                 std::to_string(relations[k]) + " and in the window " + std::to_string(in_window));
    }
  }
  return messages;
}

Messages check_fits(const ExactParts& whole, const gcv_region* region, const Window& window,
                    FreeCounts& counts) {
  const auto is_fit = [](const ExactPart& part) { return part.kind >= GCV_PART_SEGMENT; };
  Messages messages;
  for (const ExactPart& part : whole) {
    for (const Exact& p : part.points) {
      const Point place = invariants::nearest(p);
      const int in_window = location_in(window, place);
      if (is_fit(part) && exact(place) == p && in_window >= 0) {
        std::int8_t located = 0;
        require(gcv_region_locate(region, place.data(), 1, &located), "a location");
        report(messages, place, located == GCV_BOUNDARY ? "" : "a fit that is not in the window");
        ++counts.fits_in_window;
      }
    }
  }
  for (const ExactPart& part : exact_parts(region)) {
    for (const Exact& p : part.points) {
      const bool is_known =
          !is_fit(part) || std::any_of(whole.begin(), whole.end(), [&](const ExactPart& other) {
            return is_fit(other) && nearest_on(other.points.front(), other.points.back(), p) == p;
          });
      report(messages, invariants::nearest(p), is_known ? "" : "a fit of the window alone");
    }
  }
  return messages;
}

Messages check_best(const FreeQuestion& question, const ExactParts& whole, const Points& directions,
                    FreeCounts& counts) {
  const PlacedSolids solids = asked_solids(question.scene, question.query);
  const RelationAt relation_at = relation_in(solids, question.moving);
  Messages messages;
  for (const Point& direction : directions) {
    const std::optional<Exact> shown = furthest(whole, direction, relation_at, counts);
    const std::optional<Exact> wanted =
        shown ? shown : furthest(whole, direction, std::nullopt, counts);
    Point got{77, 77};
    std::int32_t found = 77;
    require(gcv_scene_best(question.scene.handle, question.moving.handle, direction.data(),
                           question.query, nullptr, got.data(), &found),
            "a best position");
    if (!wanted) {
      ++counts.none;
      report(messages, direction, found == 0 && got == Point{0, 0} ? "" : "found, but not there");
    } else {
      const std::string difference = found != 1 ? "not found"
                                     : overlaps_needlessly(whole, relation_at, got)
                                         ? "overlaps, though other corners are free"
                                         : best_difference(relation_at, got, *wanted, counts);
      report(messages, direction,
             found == 1 && passes_over(whole, direction, relation_at, got) ? "" : difference);
    }
  }
  return messages;
}

Messages check_ways_out(const FreeQuestion& question, const ExactParts& whole,
                        const Points& positions, FreeCounts& counts) {
  const PlacedSolids solids = asked_solids(question.scene, question.query);
  const RelationAt relation_at = relation_in(solids, question.moving);
  std::vector<gcv_escape> got(positions.size());
  require(
      gcv_scene_penetration(question.scene.handle, question.moving.handle, positions.front().data(),
                            positions.size(), question.query, nullptr, got.data()),
      "ways out");
  Messages messages;
  for (std::size_t k = 0; k < positions.size(); ++k) {
    gcv_escape alone{};
    require(gcv_scene_penetration(question.scene.handle, question.moving.handle,
                                  positions[k].data(), 1, question.query, nullptr, &alone),
            "a way out");
    report(messages, positions[k],
           std::memcmp(&alone, &got[k], sizeof alone) == 0 ? "" : "another way out alone");
    const Exact start = exact(positions[k]);
    const bool overlaps = relation_at(start) == reference::overlapping;
    counts.contacts.overlapping += overlaps ? 1 : 0;
    const std::optional<Exact> way = overlaps ? way_out(whole, start, counts) : Exact{0, 0};
    if (!way) {
      ++counts.none;
      report(messages, positions[k], stuck_difference(got[k], positions[k]));
      continue;
    }
    std::string wrong;
    if (!invariants::is_nearest_root(got[k].depth, dot(*way, *way))) {
      wrong = "depth " + text_of(got[k].depth) + " is not the length of " + way->x.str() + " " +
              way->y.str();
    } else if (!are_nearest(got[k].translation, *way)) {
      wrong = "another translation, not " + way->x.str() + " " + way->y.str();
    } else {
      const Touched touched =
          overlaps ? touched_at(solids, moved_there(question.moving, start + *way)) : Touched{};
      wrong = contact_difference(got[k].contact, touched.contact ? &*touched.contact : nullptr,
                                 touched.ids);
    }
    report(messages, positions[k],
           wrong.empty() ? position_difference(relation_at, got[k].position, got[k].relation,
                                               start + *way, counts.contacts)
                         : wrong);
  }
  return messages;
}

}  // namespace gcv::test
