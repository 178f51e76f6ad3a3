// SPDX-License-Identifier: LGPL-3.0-or-later
#include "turned_boxes.hpp"

#include <algorithm>
#include <cmath>

#include "task.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

// Sines of angles that count as none: of edges with the longest one, and of that with an axis.
constexpr double parallel = 0x1p-5;
constexpr double level = 0x1p-20;

// Edges along the longest one are so long together, in times of the extents of their polygon.
// Turned layouts, which have up to 5 of these, take 1.2 times as long with these boxes. Turned
// combs and slit plates have 14 to 400, and take 0.02 to 0.7 of the time.
constexpr double least_times_extents = 8;

// Calls visit(vector, length) for the edges.
template <class Visit>
void for_each_edge(const ChordTree& tree, Visit visit) {
  for (const ChordTree::Block& block : tree.blocks) {
    for_each_lane(block.lanes, [&](std::uint32_t k) {
      if (block.extent[k] < 0) {
        visit(Point{block.x1[k] - block.x0[k], block.y1[k] - block.y0[k]}, block.length[k]);
      }
    });
  }
}

}  // namespace

TurnedBoxes::TurnedBoxes(const ChordTree& a, const ChordTree& b) {
  double longest = 0;
  double all = 0;
  for (const ChordTree* tree : {&a, &b}) {
    for_each_edge(*tree, [&](const Point& edge, double length) {
      all += length;
      if (length > longest) {
        longest = length;
        axis_ = edge;
      }
    });
  }
  axis_ = unit_vector(axis_);
  if (!(std::min(std::abs(axis_.x), std::abs(axis_.y)) > level)) {
    return;
  }
  double all_along = 0;
  double times_extents = 0;
  for (const ChordTree* tree : {&a, &b}) {
    double along = 0;
    for_each_edge(*tree, [&](const Point& edge, double length) {
      const Point seen = turned(edge);
      if (std::min(std::abs(seen.x), std::abs(seen.y)) < parallel * length) {
        along += length;
      }
    });
    all_along += along;
    times_extents += along / extents_of(tree->box(ChordTree::root));
  }
  if (all_along > all / 2 && times_extents > least_times_extents) {
    a_ = boxes_of(a);
    b_ = boxes_of(b);
  }
}

std::vector<TurnedBoxes::Boxes> TurnedBoxes::boxes_of(const ChordTree& tree) const {
  std::vector<Boxes> result(tree.blocks.size());
  Pace pace;
  for (std::size_t number = result.size(); number-- > 0;) {
    pace.step();
    const ChordTree::Block& block = tree.blocks[number];
    for (std::uint32_t lane = 0; lane < ChordTree::width; ++lane) {
      result[number].put(lane, empty_box);
    }
    for_each_lane(block.lanes, [&](std::uint32_t lane) {
      Box box = empty_box;
      if (block.extent[lane] < 0) {
        box = box_of(turned({block.x0[lane], block.y0[lane]}),
                     turned({block.x1[lane], block.y1[lane]}));
      } else {
        for (std::uint32_t k = 0; k < ChordTree::width; ++k) {
          box = hull_of(box, result[block.below[lane]].box(k));
        }
      }
      result[number].put(lane, box);
    });
  }
  return result;
}

}  // namespace gcv
