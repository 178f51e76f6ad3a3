// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pairs of polygons that are measured, in sets.
#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "point.hpp"

namespace gcv::bench {

using Rings = std::pair<PointVector, PointVector>;

struct Pair {
  std::string name;
  std::function<Rings()> make;
};

struct Set {
  std::string name;
  std::vector<Pair> pairs = {};
  bool for_all_peers = true;  // or else for the principal ones alone
  bool grows = false;         // in size: who is cut off on a pair would be on later ones
  double most_vertex_pairs_for_peers = std::numeric_limits<double>::infinity();
  bool is_on_demand = false;  // measured only where it is named, with the sizes of supersets
};

// All sets; those of data only where the data is. A quick run has fewer and smaller pairs.
std::vector<Set> all_sets(bool quick);

// The blocks of pairs.txt in the folder of the data; comments divide them.
std::vector<Set> blocks_of_pairs(const std::filesystem::path& directory);
// Pairs of parts of nesting instances, drawn at random.
Set nesting(const std::filesystem::path& directory, int count);

// Of 3 to 8 vertices each, by random numbers.
Set tiny_pairs(int count);
// The pairs of the folder lost_holes.
Set lost_holes(const std::filesystem::path& directory);

// Pairs of random polygons of 3 to 12 vertices on small integer grids.
Set random_small_pairs(int count);
// From each family of regions so many sums with a hole or an exact fit of polygons without holes.
Set region_ties(int of_each_family);

// The pairs of the report on accuracy: the real ones only where the data is.
std::vector<Pair> accuracy_pairs(bool quick);

// Turned slots and what fits them exactly.
std::vector<Pair> rotated_slots(int count);

// What every system is given: counter-clockwise, not closed, no vertex repeated in a row.
PointVector tidy(const PointVector& ring);

}  // namespace gcv::bench
