// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Systems that answer questions about two polygons, of which the second is moved.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "scene.hpp"

namespace gcv::bench {

enum class Question { relation, distance, cast };

// Which relations a system tells apart.
enum class Tells { all_three, apart_or_not, overlap_or_not };

// Puts the questions first, ..., first + count - 1, and writes the answers at the same places of
// `out`. Relations are 1 for apart, 0 for touching, -1 for overlapping; casts are the part of the
// motion up to the hit, 1 without one.
using Ask = std::function<void(std::size_t first, std::size_t count, double* out)>;

struct Asker {
  std::string name;
  Question question;
  // Where the polygons exist, and are prepared if the system knows how to.
  std::function<Ask(const Scene&, const Placements&)> prepare;
  Tells tells = Tells::all_three;
  bool is_given_rounded = false;  // B is moved in doubles beforehand, untimed
  double most_vertex_pairs = std::numeric_limits<double>::infinity();
};

// The first one for each question is what others are compared to.
std::vector<Asker> libgcv_askers();
std::vector<Asker> geos_askers();
std::vector<Asker> boost_askers();
std::vector<Asker> cgal_askers();
std::vector<Asker> parry_askers();

// B at a translation, each coordinate rounded.
inline Ring rounded_at(const Ring& ring, const Point& translation) {
  Ring moved = ring;
  for (Point& p : moved) {
    p = {p.x + translation.x, p.y + translation.y};
  }
  return moved;
}

// The same for all translations: make(ring) for each.
template <class Make>
auto moved_and_made(const Scene& scene, const Placements& placements, Make make) {
  std::vector<decltype(make(scene.b))> all;
  all.reserve(placements.translations.size());
  for (const Point& translation : placements.translations) {
    all.push_back(make(rounded_at(scene.b, translation)));
  }
  return all;
}

}  // namespace gcv::bench
