// SPDX-License-Identifier: LGPL-3.0-or-later
#include "chord_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "chain_tree.hpp"
#include "repetition.hpp"
#include "task.hpp"
#include "vector.hpp"

namespace gcv {

namespace {

class Builder {
 public:
  Builder(const EdgeChain& chain, const RingLayout& layout)
      : chain_(chain), layout_(layout), repetition_(chain, layout) {}

  ChordTree build() {
    tree_.chains_repeat = repetition_.exists();
    tree_.blocks.reserve(chain_.size() / 2 + 2);
    add_block();
    put(0, 0, {0, chain_.size()});
    return std::move(tree_);
  }

 private:
  // Edges from `first` to before `last`.
  struct Range {
    Index first;
    Index last;
    [[nodiscard]] Index size() const { return last - first; }
  };

  // A block of missing nodes.
  void add_block() {
    ChordTree::Block block{};
    for (std::uint32_t lane = 0; lane < ChordTree::width; ++lane) {
      block.boxes.put(lane, empty_box);
      block.extent[lane] = -1;
    }
    tree_.blocks.push_back(block);
  }

  // Distances of the points of a chain from its chord, at least: where a point lies beyond an end
  // of the chord, the sum of how far it is beyond, and how far from the line.
  struct Furthest {
    double distance = 0;
    Index point = 0;  // the furthest one in the middle half of the chain
    double of_point = -1;
  };
  [[nodiscard]] Furthest furthest(const Range& range) const {
    const std::span<const Point> points = chain_.ends(range.first, range.size());
    const Point& from = points.front();
    const Point chord{points.back().x - from.x, points.back().y - from.y};
    const bool is_point = chord == Point{0, 0};
    const Point unit = is_point ? Point{1, 0} : unit_vector(chord);
    const double length = is_point ? 0 : unit.x * chord.x + unit.y * chord.y;
    const Index n = range.size();
    const Index low = n / 4;
    Furthest furthest;
    for (Index k = 1; k < n; ++k) {
      const double dx = points[k].x - from.x;
      const double dy = points[k].y - from.y;
      const double along = unit.x * dx + unit.y * dy;
      const double beyond = along - std::min(std::max(along, 0.0), length);
      const double distance = std::abs(beyond) + std::abs(unit.x * dy - unit.y * dx);
      furthest.distance = std::max(furthest.distance, distance);
      if (k >= low && k <= n - low && distance > furthest.of_point) {
        furthest.of_point = distance;
        furthest.point = range.first + k;
      }
    }
    if (std::isnan(furthest.distance) || furthest.point == 0) {
      furthest.point = range.first + n / 2;
    }
    if (repetition_.exists()) {
      furthest.point = repetition_.cut(range.first, range.last);
    }
    return furthest;
  }

  [[nodiscard]] bool is_chain(const Range& range) const {
    return layout_.ring_of(range.first) == layout_.ring_of(range.last - 1);
  }

  // Where to split a range of at least two edges: between rings, or in a vertex of one.
  [[nodiscard]] Index middle(const Range& range) const {
    const Index first_ring = layout_.ring_of(range.first);
    const Index last_ring = layout_.ring_of(range.last - 1);
    return first_ring == last_ring ? furthest(range).point
                                   : layout_.begin(first_ring + (last_ring - first_ring + 1) / 2);
  }

  void put(std::uint32_t block, std::uint32_t lane, const Range& range) {
    pace_.step(range.size());
    const bool is_one_chain = is_chain(range);
    Furthest of_chain;
    if (!is_one_chain) {
      of_chain.distance = infinity;
    } else if (range.size() > 1) {
      of_chain = furthest(range);
    }
    const std::span<const Point> points = chain_.ends(range.first, range.size());
    const Box box = box_of(points);
    {
      ChordTree::Block& in = tree_.blocks[block];
      in.boxes.put(lane, box);
      in.x0[lane] = points.front().x;
      in.y0[lane] = points.front().y;
      in.x1[lane] = points.back().x;
      in.y1[lane] = points.back().y;
      in.radius[lane] = of_chain.distance;
      in.length[lane] = is_one_chain ? length_bound(points.back().x - points.front().x,
                                                    points.back().y - points.front().y)
                                     : 0;
      const double extent = (box.x1 - box.x0) + (box.y1 - box.y0);
      if (range.size() == 1) {
        in.extent[lane] = -1;
      } else if (extent >= 0) {
        in.extent[lane] = extent;
      } else {  // not a number
        in.extent[lane] = infinity;
      }
      in.lanes |= 1U << lane;
      in.below[lane] = range.first;
    }
    if (range.size() > 1) {
      split(block, lane, range, is_one_chain ? of_chain.point : middle(range));
    }
  }

  // Makes up to four children: all edges, or two on each side of the cut.
  void split(std::uint32_t block, std::uint32_t lane, const Range& range, Index cut) {
    const auto below = static_cast<std::uint32_t>(tree_.blocks.size());
    tree_.blocks[block].below[lane] = below;
    add_block();
    std::uint32_t child = 0;
    if (range.size() <= ChordTree::width) {
      for (Index k = range.first; k < range.last; ++k) {
        put(below, child++, {k, k + 1});
      }
      return;
    }
    const auto put_half = [&](const Range& half) {
      if (half.size() == 1) {
        put(below, child++, half);
        return;
      }
      const Index point = middle(half);
      put(below, child++, {half.first, point});
      put(below, child++, {point, half.last});
    };
    put_half({range.first, cut});
    put_half({cut, range.last});
  }

  const EdgeChain& chain_;
  const RingLayout& layout_;
  const Repetition repetition_;
  ChordTree tree_;
  Pace pace_;
};

}  // namespace

ChordTree build_chord_tree(const EdgeChain& chain, const RingLayout& layout) {
  return Builder(chain, layout).build();
}

}  // namespace gcv
