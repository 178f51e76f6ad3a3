// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Real polygons from outside the project: the folder named by GCV_DATA_DIR, or the one
// that lies beside the project.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::test {

struct NamedPair {
  std::string name;
  PointVector a;
  PointVector b;
};

// Where the data is, if it is there.
std::optional<std::filesystem::path> data_directory();

// All rings of a polygon, the outer one first.
std::vector<PointVector> read_rings(const std::filesystem::path& file);
// The outer one.
PointVector read_polygon(const std::filesystem::path& file);

// The pairs of the folder's pairs.txt.
std::vector<NamedPair> read_pairs(const std::filesystem::path& directory);

}  // namespace gcv::test
