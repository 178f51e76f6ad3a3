// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pairs of polygons, and translations of the second one near contact, in contact, and before a
// motion.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::bench {

using Ring = PointVector;

// Counter-clockwise rings, not closed, no vertex repeated in a row.
struct Scene {
  std::string family;
  std::string pair;
  Ring a;
  Ring b;
};

// Where B is put, in turn; with motions that start there, or without.
struct Placements {
  std::string kind;
  Ring translations;
  Ring motions;
};

struct Situation {
  Scene scene;
  double size;  // half the larger side of the box of the no-fit region
  std::vector<Placements> placements;
};

struct SceneFamily {
  std::string name;
  std::vector<std::function<Scene()>> scenes;
  std::size_t count;  // of the placements of each kind
};

// Those of data only where the data is. A quick run has fewer and smaller pairs.
std::vector<SceneFamily> scene_families(bool quick);

// Three kinds of placements. "contact": vertices of the no-fit region in doubles. "near": such
// vertices, and up to 0.001 to 0.1 of the size away from each. "motion": those of the second kind
// where the polygons are apart, with motions to others of them and as far again.
Situation situation(const Scene& scene, std::size_t count);

}  // namespace gcv::bench
