// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scenes as text, for messages.
#pragma once

#include <gcv/gcv.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "contact_scenes.hpp"

namespace gcv::test {

inline std::string text_of_rings(const std::vector<invariants::Polygon>& rings) {
  std::string text = "POLYGON (";
  for (const invariants::Polygon& ring : rings) {
    text += &ring == &rings.front() ? "(" : ", (";
    for (const invariants::Point& p : ring) {
      char vertex[80];
      static_cast<void>(std::snprintf(vertex, sizeof vertex, "%s%.17g %.17g",
                                      &p == &ring.front() ? "" : ", ", p[0], p[1]));
      text += vertex;
    }
    text += ")";
  }
  return text + ")";
}

// With the ids of the members.
inline std::string text_of(const MemberScene& scene, const std::vector<std::uint64_t>& ids) {
  std::string text;
  for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
    text += "\nshape " + std::to_string(k) + ": " + text_of_rings(scene.shapes[k]);
  }
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const MemberScene::Member& member = scene.members[k];
    char place[120];
    static_cast<void>(std::snprintf(place, sizeof place, "shape %zu at %.17g %.17g, layers %x",
                                    member.shape, member.position[0], member.position[1],
                                    static_cast<unsigned>(member.layers)));
    text += "\nmember " + std::to_string(ids[k]) + ": " + place;
  }
  text += "\nmoving: shape " + std::to_string(scene.moving);
  return scene.container ? text + ", container: shape " + std::to_string(*scene.container) : text;
}

inline std::string text_of(const gcv_query& query) {
  std::string text = "\nquery: layers " + std::to_string(query.layers) + ", without";
  for (std::size_t k = 0; k < query.ignore_count; ++k) {
    text += ' ';
    text += std::to_string(query.ignore[k]);
  }
  return text;
}

}  // namespace gcv::test
