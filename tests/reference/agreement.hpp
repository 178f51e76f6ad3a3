// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The walk against both references, on one pair.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>

#include "boundary.hpp"
#include "minkowski_sum.hpp"
#include "outer_face.hpp"
#include "reference.hpp"
#include "ring_predicates.hpp"
#include "wkt.hpp"

namespace gcv::reference {

inline FractionRing walked(const Boundary& a, const Boundary& b) {
  Tally tally;
  Task task;
  Walk walk = walk_outer_face(a, b, task, tally);
  const ExactRing ring{{std::make_shared<Boundary>(a), "a"},
                       {std::make_shared<Boundary>(b), "b"},
                       {0, 0},
                       std::move(walk.vertices)};
  FractionRing fractions;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    fractions.push_back(exact_vertex(ring, k));
  }
  return fractions;
}

inline std::string describe(const PointVector& a, const PointVector& b) {
  return "A = " + format_polygon(a) + "\nB = " + format_polygon(b);
}

// Fails where the walk and the references differ.
inline void expect_agreement(const PointVector& ring_a, const PointVector& ring_b) {
  const Boundary a = make_ring(ring_a, "a");
  const Boundary b = make_ring(ring_b, "b");
  const FractionRing ring = walked(a, b);
  ASSERT_EQ(ring, arrangement_outer_face(superset(a, b))) << describe(ring_a, ring_b);
  ASSERT_EQ(ring, reduced_convolution(a.vertices, b.vertices)) << describe(ring_a, ring_b);
}

}  // namespace gcv::reference
