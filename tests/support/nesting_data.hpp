// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Nesting instances from outside the project, the folder esicup of the polygon data: stored no-fit
// and inner-fit polygons, and jigsaws.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "point.hpp"

namespace gcv::test {

// Up to a translation, and as precise as its maker was.
struct StoredRing {
  std::size_t fixed;   // index of the piece; unused in inner fits
  std::size_t moving;  // index of the piece
  PointVector ring;
};

struct NestingInstance {
  std::string name;
  PointVector board;
  std::vector<PointVector> pieces;
  std::vector<std::size_t> quantities;  // of the pieces
  std::vector<StoredRing> no_fits;
  std::vector<StoredRing> inner_fits;  // in the board
};

// Pieces in place. They tile the rectangle from (0, 0) to (width, height).
struct Jigsaw {
  std::string name;
  double width;
  double height;
  std::vector<PointVector> pieces;
};

std::vector<NestingInstance> read_nesting_instances(const std::filesystem::path& directory);
std::vector<Jigsaw> read_jigsaws(const std::filesystem::path& directory);

}  // namespace gcv::test
