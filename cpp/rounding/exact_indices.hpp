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

// For each point the index of the vertex of the ring that is equal to it: the first of several. If
// there is none, that of the vertex whose edge lies closest, about. O(n log n).
std::vector<std::size_t> closest_edges(std::span<const Point> ring, const PointVector& points,
                                       Task& task);

// For each vertex of the rounded ring, the index of the exact vertex that was rounded to it, the
// first of those that fell together. If there is none, that of the vertex whose edge lies closest.
std::vector<std::uint64_t> exact_indices(const ExactRing& exact, const RoundedRing& rounded);

}  // namespace gcv
