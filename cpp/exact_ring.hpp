// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The ring of the outer face, exactly: each vertex is known by what it is made of, and
// its coordinates are fractions that are worked out on demand.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "outer_face.hpp"
#include "polygon.hpp"
#include "superset.hpp"

namespace gcv {

// A polygon, its name in messages, such as "a" or "fixed", and how far it may be from what
// it stands for.
struct Operand {
  std::shared_ptr<const Polygon> polygon;
  const char* name;
  double error_bound = 0;
};

struct ExactRing {
  Operand a;
  Operand b;
  Point shift;  // added to every vertex
  std::vector<RingVertex> vertices;
  bool chains_are_repeated = false;  // as in Walk

  [[nodiscard]] std::size_t size() const { return vertices.size(); }
};

// On which side of the line of ring edge `edge` does vertex `vertex` lie, exactly: 1 left,
// -1 right, 0 on it?
int exact_side(const ExactRing& ring, std::size_t edge, std::size_t vertex, Tally& tally);

// Vertex k as "p/q r/s", in lowest terms with positive denominators.
std::string exact_vertex(const ExactRing& ring, std::size_t k);

}  // namespace gcv
