// SPDX-License-Identifier: LGPL-3.0-or-later
//
// No-fit polygons, fixed + (-moving), of parts that fit exactly: slits of width 0, which
// rounding the input opens or closes by less than a unit in the last place.
#include "catalogue.hpp"
#include "shapes.hpp"

namespace gcv::hard {

namespace {

// Each pair as it is, turned exactly, and turned in doubles.
Pairs also_turned(const Pairs& fixed_and_moving, Random& random) {
  Pairs pairs;
  for (const auto& [fixed, moving] : fixed_and_moving) {
    const Map maps[] = {{}, exact_rotation(2, 1), random_rotation(random), random_rotation(random)};
    for (const Map& map : maps) {
      pairs.push_back({mapped(fixed, map), negated(mapped(moving, map))});
    }
  }
  return pairs;
}

// The walls of the slit lie on each other, or cross after rounding.
Pairs slots() {
  Random random(1);
  Pairs pairs;
  for (int k = 0; k < 25; ++k) {
    const Slot slot{uniform(random, 1, 9), uniform(random, 1, 20), 1, 1};
    const Slot straight{slot.neck_width, slot.neck_depth, slot.neck_width, 1};
    pairs.push_back(
        {block_with(straight), rectangle(slot.neck_width, uniform(random, 1, slot.neck_depth))});
  }
  return also_turned(pairs, random);
}

// A shaft that fits the neck exactly and turns nowhere, with a bow that stays outside.
Pairs key_in_lock() {
  Random random(2);
  Pairs pairs;
  for (int k = 0; k < 25; ++k) {
    const Slot slot = random_slot(random);
    const Slot key{slot.neck_width, slot.neck_depth, slot.neck_width + 4, 3};
    pairs.push_back({block_with(slot), negated(key_of(key))});
  }
  return also_turned(pairs, random);
}

// The key touches its slot all around: one isolated position, deep inside.
Pairs t_slot_with_its_key() {
  Random random(3);
  Pairs pairs;
  for (int k = 0; k < 25; ++k) {
    const Slot slot = random_slot(random);
    pairs.push_back({block_with(slot), key_of(slot)});
  }
  return also_turned(pairs, random);
}

// A chamber of free positions behind a slit that is open by a unit in the last place or
// closed.
Pairs pockets_behind_slits() {
  Random random(4);
  Pairs pairs;
  for (int k = 0; k < 25; ++k) {
    const Slot slot = random_slot(random);
    pairs.push_back(
        {block_with(slot), rectangle(slot.neck_width, uniform(random, 1, slot.chamber_depth))});
  }
  return also_turned(pairs, random);
}

// Two pieces along one border of knobs.
Pairs jigsaw_neighbours() {
  Random random(5);
  Pairs pairs;
  for (int knobs = 1; knobs < 6; ++knobs) {
    Polygon border{{10, 0}};
    for (int k = 0; k < knobs; ++k) {
      const double y = 8 * k;
      const double out = uniform(random, 0, 1) == 0 ? -1 : 1;
      const double head = uniform(random, 2, 4);
      for (const auto& [x, height] :
           Polygon{{0, 2}, {1, 2}, {1, 1}, {1 + head, 1}, {1 + head, 6}, {1, 6}, {1, 4}, {0, 4}}) {
        border.push_back({10 + out * x, y + height});
      }
    }
    border.push_back({10, 8.0 * knobs});
    Polygon left = border;
    left.insert(left.end(), {{0, 8.0 * knobs}, {0, 0}});
    Polygon right(border.rbegin(), border.rend());
    right.insert(right.end(), {{20, 0}, {20, 8.0 * knobs}});
    pairs.push_back({left, right});
  }
  return also_turned(pairs, random);
}

// All teeth of one comb fit all gaps of the other at once.
Pairs combs_that_mesh() {
  Random random(6);
  Pairs pairs;
  for (const int teeth : {2, 3, 7, 20}) {
    const Polygon fixed = comb(teeth, 2, 3, 9);
    pairs.push_back({fixed, negated(comb(teeth, 3, 2, 9))});
    pairs.push_back({fixed, negated(comb(teeth - 1, 3, 2, 5))});
  }
  return also_turned(pairs, random);
}

std::vector<Polygon> shapes_of_all_kinds() {
  Random random(7);
  std::vector<Polygon> shapes = small_shapes();
  for (int k = 0; k < 30; ++k) {
    shapes.push_back(random_on_grid(random, uniform(random, 3, 8), 6));
    shapes.push_back(mapped(shapes[static_cast<std::size_t>(k)], random_rotation(random)));
  }
  for (const int quarter : {2, 10, 40}) {
    shapes.push_back(random_star(random, quarter));
  }
  return shapes;
}

// Each edge meets itself the other way round.
Pairs with_its_negative() {
  Pairs pairs;
  for (const Polygon& shape : shapes_of_all_kinds()) {
    pairs.push_back({shape, negated(shape)});
  }
  return pairs;
}

// Each edge merges with itself.
Pairs with_itself() {
  Pairs pairs;
  for (const Polygon& shape : shapes_of_all_kinds()) {
    pairs.push_back({shape, shape});
  }
  return pairs;
}

}  // namespace

std::vector<Family> fits() {
  return {{"slots", slots},
          {"key_in_lock", key_in_lock},
          {"t_slot_with_its_key", t_slot_with_its_key},
          {"pockets_behind_slits", pockets_behind_slits},
          {"jigsaw_neighbours", jigsaw_neighbours},
          {"combs_that_mesh", combs_that_mesh},
          {"with_its_negative", with_its_negative},
          {"with_itself", with_itself}};
}

}  // namespace gcv::hard
