// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which exact vertex each vertex of a rounded ring stands for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "exact_ring.hpp"
#include "rounding.hpp"
#include "task.hpp"

namespace gcv {

// The places of a ring, each once: where several in a row are equal, the first.
struct DistinctPlaces {
  PointVector places;
  std::vector<std::uint64_t> indices;  // of each, where it comes from
};

// `first`: the number of the first place. Begins with that, or with the smallest place.
DistinctPlaces distinct_places(std::span<const Point> places, std::size_t first,
                               bool from_smallest);

// For each vertex of a ring that goes along another one the index of the vertex of that which is
// equal to it: the first of several. If there is none, that of the edge closest to the one from
// there, about: both of its ends count, and an edge the other way is as much further away as the
// edge is long. O(n log n).
std::vector<std::size_t> closest_edges(std::span<const Point> other, const PointVector& ring,
                                       Task& task);

// For each vertex of the rounded ring, the index of the exact vertex that was rounded to it, the
// lowest of those that fell together, or that was moved there. If there is none, as
// closest_edges().
std::vector<std::uint64_t> exact_indices(const ExactRing& exact, const RoundedRing& rounded);

}  // namespace gcv
