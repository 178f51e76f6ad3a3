// SPDX-License-Identifier: LGPL-3.0-or-later
#include "contact_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace gcv::test {

namespace {

using Place = invariants::Point;
using Polygon = invariants::Polygon;
using Polygons = std::vector<Polygon>;

bool one_in(Random& random, int count) { return uniform(random, 1, count) == 1; }

template <class List>
const auto& one_of(Random& random, const List& list) {
  return list[static_cast<std::size_t>(uniform(random, 0, static_cast<int>(std::size(list)) - 1))];
}

Place plus(const Place& p, const Place& q) { return {p[0] + q[0], p[1] + q[1]}; }
Place minus(const Place& p, const Place& q) { return {p[0] - q[0], p[1] - q[1]}; }
Place times(double s, const Place& p) { return {s * p[0], s * p[1]}; }

// At most the largest doubles.
Place finite(const Place& p) {
  static constexpr double largest = std::numeric_limits<double>::max();
  const auto at_most = [](double x) {
    return std::isnan(x) ? 0 : std::clamp(x, -largest, largest);
  };
  return {at_most(p[0]), at_most(p[1])};
}

// Between -12 and 12 units.
Place random_place(Random& random, double unit) {
  const double x = uniform(random, -48, 48) / 4.0;
  return {unit * x, unit * (uniform(random, -48, 48) / 4.0)};
}

// The size of 1 of the family.
double random_unit(Random& random) {
  switch (uniform(random, 0, 10)) {
    case 0:  // subnormal numbers
      return std::ldexp(1.0, uniform(random, -1074, -1040));
    case 1:  // up to the largest doubles
      return std::ldexp(1.0, uniform(random, 990, 1019));
    case 2:
      return one_of(random, std::array{1e150, 1e300, 1e-300, 1.0 / 3});
    case 3:
      return std::ldexp(1.0, uniform(random, -600, 600));
    case 4:  // with squares near the ends of the range
      return std::ldexp(
          1.0, one_in(random, 2) ? uniform(random, 505, 513) : uniform(random, -545, -530));
    default:
      return 1;
  }
}

Place random_offset(Random& random, double unit) {
  switch (uniform(random, 0, 7)) {
    case 0:  // integers stay exact
      return times(std::ldexp(1.0, uniform(random, 20, 44)), random_place(random, unit));
    case 1:
      return times(1.0 / 3, random_place(random, unit));
    default:
      return {0, 0};
  }
}

// The same ring, passed in another way.
void pass_otherwise(Random& random, Polygon& ring) {
  if (one_in(random, 4)) {
    std::reverse(ring.begin(), ring.end());
  }
  if (one_in(random, 4)) {
    const int start = uniform(random, 0, static_cast<int>(ring.size()) - 1);
    std::rotate(ring.begin(), ring.begin() + start, ring.end());
  }
  if (one_in(random, 8)) {
    const int k = uniform(random, 0, static_cast<int>(ring.size()) - 1);
    const Place repeated = ring[static_cast<std::size_t>(k)];
    ring.insert(ring.begin() + k, repeated);
  }
  if (one_in(random, 8)) {
    const Place closing = ring.front();
    ring.push_back(closing);
  }
}

Polygons placed(Random& random, const Rings& rings, double unit, const Place& offset) {
  Polygons result;
  for (const Ring& ring : rings) {
    Polygon polygon;
    for (const Point& p : ring) {
      polygon.push_back(plus({unit * p.x, unit * p.y}, offset));
    }
    pass_otherwise(random, polygon);
    result.push_back(polygon);
  }
  return result;
}

// The container as the hole of a block.
Rings block_around(const Ring& container) {
  Ring block{{-20, -20}, {40, -20}, {40, 40}, {-20, 40}};
  return {block, container};
}

struct Span {
  Place from;
  Place to;
};

Span random_edge(Random& random, const Polygons& rings) {
  const Polygon& ring = one_of(random, rings);
  const auto k = static_cast<std::size_t>(uniform(random, 0, static_cast<int>(ring.size()) - 1));
  return {ring[k], ring[(k + 1) % ring.size()]};
}

// A vertex, or a point of an edge at an eighth of it.
Place random_boundary_point(Random& random, const Polygons& rings) {
  const Span e = random_edge(random, rings);
  const double share = std::max(uniform(random, -7, 7), 0) / 8.0;
  return plus(e.from, times(share, minus(e.to, e.from)));
}

// A vertex meets a vertex or an edge, but for roundings.
Place random_contact(Random& random, const Polygons& a, const Polygons& b) {
  const bool is_vertex_of_a = one_in(random, 2);
  const Place on_a =
      is_vertex_of_a ? random_edge(random, a).from : random_boundary_point(random, a);
  return minus(on_a,
               is_vertex_of_a ? random_boundary_point(random, b) : random_edge(random, b).from);
}

// Some units in the last place off.
Place beside(Random& random, Place p) {
  for (int k = uniform(random, 1, 3); k > 0; --k) {
    double& x = p[static_cast<std::size_t>(uniform(random, 0, 1))];
    x = std::nextafter(x, one_in(random, 2) ? HUGE_VAL : -HUGE_VAL);
  }
  return p;
}

Place random_translation(Random& random, const Polygons& a, const Polygons& b, double unit) {
  const Place contact = random_contact(random, a, b);
  const Place step = random_place(random, unit);
  switch (uniform(random, 0, 9)) {
    case 0:
    case 1:
      return contact;
    case 2:
      return beside(random, contact);
    case 3:
      return plus(contact, times(1.0 / 1024, step));
    case 4:
      return plus(contact, times(std::ldexp(1.0, uniform(random, 4, 60)), step));
    case 5:  // as the family has them: many exact fits
      return {0, 0};
    case 6:
      return step;
    default:
      return plus(contact, times(1.0 / 8, step));
  }
}

Place random_motion(Random& random, const Polygons& a, const Polygons& b, const Place& from,
                    double unit) {
  static constexpr std::array factors{1.0, 0.5, 2.0, 1.5, 0.25, 4.0, -1.0};
  const double factor = one_of(random, factors);
  const Place step = random_place(random, unit);
  switch (uniform(random, 0, 9)) {
    case 0:
      return {0, 0};
    case 1:
    case 2:
    case 3:  // through a contact
      return times(factor, minus(random_contact(random, a, b), from));
    case 4:
    case 5: {  // along an edge
      const Span e = random_edge(random, one_in(random, 2) ? a : b);
      return times(factor, minus(e.to, e.from));
    }
    case 6:
      return one_in(random, 2) ? Place{step[0], 0} : Place{0, step[1]};
    case 7:
      return times(std::ldexp(1.0, uniform(random, -50, 50)), step);
    default:
      return step;
  }
}

RegionCase spiky_stars(Random& random) {
  const Ring a = random_spiky_star(random, uniform(random, 6, 24));
  return {{a}, {random_spiky_star(random, uniform(random, 6, 12))}, false, {0, 0}};
}

RegionCase larger_integers(Random& random) {
  const Ring a = random_small_integer_polygon(random, uniform(random, 12, 24), 12);
  return {{a}, {random_small_integer_polygon(random, uniform(random, 5, 10), 8)}, false, {0, 0}};
}

// Where positions begin. Far out, multiples of some units are exact, and most vertices are not.
Place random_base(Random& random, double unit) {
  if (!one_in(random, 3)) {
    return {0, 0};
  }
  const double x = std::ldexp(uniform(random, -3, 3), uniform(random, 46, 56));
  return {unit * x, one_in(random, 2) ? unit * std::ldexp(1.0, uniform(random, 46, 56)) : 0};
}

// The rectangle round all members, but for roundings: exactly, or wider or narrower; perhaps with a
// hole.
Polygons room_around(Random& random, const MemberScene& scene, double unit) {
  Place low{HUGE_VAL, HUGE_VAL};
  Place high{-HUGE_VAL, -HUGE_VAL};
  for (const MemberScene::Member& member : scene.members) {
    for (const Place& p : scene.shapes[member.shape].front()) {
      const Place place = plus(p, member.position);
      low = {std::min(low[0], place[0]), std::min(low[1], place[1])};
      high = {std::max(high[0], place[0]), std::max(high[1], place[1])};
    }
  }
  const double margin = unit * uniform(random, -1, 6);
  low = minus(low, {margin, margin});
  high = plus(high, {margin, margin});
  Polygons room{{low, {high[0], low[1]}, high, {low[0], high[1]}}};
  if (one_in(random, 3)) {
    const Place third = times(0.25, minus(high, low));
    const Place p = plus(low, third);
    room.push_back({p, plus(p, {third[0], 0}), plus(p, times(2, third))});
  }
  return room;
}

// Mostly not that of the container.
std::size_t random_shape(Random& random, const MemberScene& scene) {
  const auto last = static_cast<int>(scene.shapes.size()) - 1;
  const auto shape = static_cast<std::size_t>(uniform(random, 0, last));
  return shape == scene.container && !one_in(random, 6) ? (shape + 1) % scene.shapes.size() : shape;
}

// One of some places that are far from each other.
Place sparse_place(Random& random, const Place& base, double unit) {
  const double x = 32 * uniform(random, -2, 2);
  return plus(base, {unit * x, unit * (32 * uniform(random, -2, 2))});
}

// For a shape, in contact with the container or a member or nearly so.
Place position_beside(Random& random, const MemberScene& scene, std::size_t shape,
                      const Place& base, double unit) {
  const Polygons& rings = scene.shapes[shape];
  if (scene.container && (scene.members.empty() || one_in(random, 3))) {
    return random_translation(random, scene.shapes[*scene.container], rings, unit);
  }
  if (scene.members.empty()) {
    return plus(base, random_place(random, unit));
  }
  const MemberScene::Member& other = one_of(random, scene.members);
  return plus(other.position, random_translation(random, scene.shapes[other.shape], rings, unit));
}

void add_case(Random& random, const RegionCase& c, double unit, MemberScene& scene) {
  const Place offset = random_offset(random, unit);
  // The sum of a and b is where a and the negated b overlap.
  const Rings b = c.inner_fit ? c.b : negated(c.b);
  const bool is_hole = c.inner_fit && c.a.size() == 1 && one_in(random, 2);
  if (c.inner_fit && !is_hole && !scene.container) {
    scene.container = scene.shapes.size();
  }
  scene.shapes.push_back(placed(random, is_hole ? block_around(c.a.front()) : c.a, unit, offset));
  scene.shapes.push_back(
      placed(random, b, unit, one_in(random, 2) ? offset : random_offset(random, unit)));
}

std::uint32_t random_layers(Random& random) {
  return one_in(random, 2) ? UINT32_MAX : static_cast<std::uint32_t>(uniform(random, 0, 7));
}

}  // namespace

std::span<const RegionFamily> contact_families() {
  static const std::vector<RegionFamily> families = [] {
    const auto of_regions = region_families();
    std::vector<RegionFamily> all(of_regions.begin(), of_regions.end());
    all.push_back({"spiky stars", spiky_stars});
    all.push_back({"larger integers", larger_integers});
    return all;
  }();
  return families;
}

ContactScene contact_scene(const RegionFamily& family, Random& random, int translations) {
  const RegionCase c = family.next_case(random);
  const double unit = random_unit(random);
  // The sum of a and b is where a and the negated b overlap.
  const Rings b = c.inner_fit ? c.b : negated(c.b);
  const bool is_hole = c.inner_fit && c.a.size() == 1 && one_in(random, 2);
  const Place offset = random_offset(random, unit);
  ContactScene scene;
  scene.a = placed(random, is_hole ? block_around(c.a.front()) : c.a, unit, offset);
  scene.b = placed(random, b, unit, one_in(random, 2) ? offset : random_offset(random, unit));
  for (int k = 0; k < translations; ++k) {
    Place t = finite(random_translation(random, scene.a, scene.b, unit));
    const Place motion = finite(random_motion(random, scene.a, scene.b, t, unit));
    if (one_in(random, 2)) {  // t is on the way
      t = finite(minus(t, times(uniform(random, 1, 8) / 4.0, motion)));
    }
    scene.translations.push_back(t);
    scene.motions.push_back(motion);
  }
  return scene;
}

MemberScene member_scene(const RegionFamily& family, Random& random, int most_members,
                         int positions) {
  MemberScene scene;
  const double unit = random_unit(random);
  for (int k = uniform(random, 1, 2); k > 0; --k) {
    add_case(random, family.next_case(random), unit, scene);
  }
  const Place base = scene.container ? Place{0, 0} : random_base(random, unit);
  for (int k = uniform(random, 0, most_members); k > 0; --k) {
    const std::size_t shape = random_shape(random, scene);
    const Place position = finite(!scene.container && one_in(random, 2)
                                      ? sparse_place(random, base, unit)
                                      : position_beside(random, scene, shape, base, unit));
    scene.members.push_back({shape, position, random_layers(random)});
  }
  if (!scene.container && !scene.members.empty() && one_in(random, 3)) {
    scene.container = scene.shapes.size();
    scene.shapes.push_back(room_around(random, scene, unit));
  }
  scene.moving = random_shape(random, scene);
  for (int k = 0; k < positions; ++k) {
    Place position = finite(position_beside(random, scene, scene.moving, base, unit));
    const Polygons& other = scene.shapes[random_shape(random, scene)];
    const Place motion = finite(
        random_motion(random, other, scene.shapes[scene.moving], minus(position, base), unit));
    if (!one_in(random, 4)) {  // it is on the way
      position = finite(minus(position, times(uniform(random, 1, 8) / 4.0, motion)));
    }
    scene.positions.push_back(position);
    scene.motions.push_back(motion);
  }
  return scene;
}

}  // namespace gcv::test
