// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "polygon_pair.hpp"

namespace gcv {

// A node of a tree with its box, relative to the first vertex of A.
struct BoxedNode {
  ChainTree::Node node;
  Box box;
};

// Is there such a child? The box of a missing one holds no point. Searches ask where numbers that
// overflow leave no box apart.
inline bool has_child(const ChainTree::Block& block, std::uint32_t lane) {
  return block.x0[lane] <= block.x1[lane];
}

inline Box moved(const Box& box, const Point& offset) {
  return {box.x0 + offset.x, box.y0 + offset.y, box.x1 + offset.x, box.y1 + offset.y};
}
inline double extent(const Box& box) { return (box.x1 - box.x0) + (box.y1 - box.y0); }

}  // namespace gcv
