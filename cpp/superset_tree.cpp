// SPDX-License-Identifier: LGPL-3.0-or-later
#include "superset_tree.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace gcv {

namespace {

std::uint64_t count_contributions(const EdgesByRank& edges, const Polygon& polygon,
                                  const Ranks& ranks) {
  std::uint64_t count = 0;
  for_each_cone(polygon, ranks,
                [&](Index /*v*/, Rank in, Rank out) { count += edges.count(in, out); });
  return count;
}

// The cells of a grid in the order of a Z-shaped curve (Morton, 1966), in which neighbours are
// near, over numbers from -1 to 1; one to four for each edge.
class ZOrder {
 public:
  explicit ZOrder(std::size_t edges)
      : bits_((static_cast<unsigned>(std::bit_width(edges)) + 1) / 2) {}

  [[nodiscard]] std::size_t cells() const { return std::size_t{1} << (2 * bits_); }
  [[nodiscard]] std::uint32_t cell(float x, float y) const {
    return spread(coordinate(x)) | spread(coordinate(y)) << 1U;
  }

 private:
  // Where numbers have overflowed, any will do.
  [[nodiscard]] std::uint32_t coordinate(float x) const {
    const auto cells = static_cast<float>(1U << bits_);
    const float place = (x + 1) / 2 * cells;
    return place > 0 ? static_cast<std::uint32_t>(std::min(place, cells - 1)) : 0;
  }
  // The bits of a number below 2^8, with zeros between them.
  static std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 4U) & 0x0f0fU;
    x = (x | x << 2U) & 0x3333U;
    return (x | x << 1U) & 0x5555U;
  }

  unsigned bits_;
};

struct FloatBox {
  float sides[4];  // in the order of SupersetTree::Block
};

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr FloatBox nothing{{infinity, infinity, -infinity, -infinity}};
constexpr FloatBox everything{{-infinity, -infinity, infinity, infinity}};

struct BoxedEdge {
  PairEdge edge;
  FloatBox box;
  std::uint32_t cell;
};

FloatBox box_of_edge(const Operands& operands, const PairEdge& e, double scale) {
  if (scale == 0) {
    return everything;
  }
  const Point from = operands.relative_start(e);
  const Point to = operands.relative_end(e);
  const auto x0 = static_cast<float>(from.x * scale);
  const auto y0 = static_cast<float>(from.y * scale);
  const auto x1 = static_cast<float>(to.x * scale);
  const auto y1 = static_cast<float>(to.y * scale);
  return {{std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1)}};
}

void put(SupersetTree::Block& block, std::uint32_t lane, const FloatBox& box) {
  for (unsigned side = 0; side < 4; ++side) {
    block.sides[side][lane] = box.sides[side];
  }
}

FloatBox join(const SupersetTree::Block& block) {
  const auto& sides = block.sides;
  FloatBox box{{sides[0][0], sides[1][0], sides[2][0], sides[3][0]}};
  for (std::uint32_t lane = 1; lane < EightLanes::width; ++lane) {
    box = {{std::min(box.sides[0], sides[0][lane]), std::min(box.sides[1], sides[1][lane]),
            std::max(box.sides[2], sides[2][lane]), std::max(box.sides[3], sides[3][lane])}};
  }
  return box;
}

double scale_of(const Operands& operands) {
  const Box& a = operands.a.bounds;
  const Box& b = operands.b.bounds;
  return scale_to_one(std::max((a.x1 - a.x0) + (b.x1 - b.x0), (a.y1 - a.y0) + (b.y1 - b.y0)));
}

}  // namespace

std::uint64_t count_superset(const Operands& operands, const RankedEdges& ranked) {
  return count_contributions(ranked.a, operands.b, operands.directions.rank_b) +
         count_contributions(ranked.b, operands.a, operands.directions.rank_a);
}

SupersetTree::SupersetTree(const Operands& operands, const RankedEdges& ranked, std::size_t size)
    : scale_(scale_of(operands)) {
  const ZOrder order(size);
  std::vector<std::uint32_t> places(order.cells() + 1);  // of the first edge of each cell
  std::vector<BoxedEdge> edges;
  edges.reserve(size);
  const auto add = [&](const PairEdge& edge) {
    const FloatBox box = box_of_edge(operands, edge, scale_);
    const std::uint32_t cell =
        order.cell((box.sides[0] + box.sides[2]) / 2, (box.sides[1] + box.sides[3]) / 2);
    ++places[cell + 1];
    edges.push_back({edge, box, cell});
  };
  for_each_cone(operands.b, operands.directions.rank_b, [&](Index j, Rank in, Rank out) {
    ranked.a.for_each(in, out, [&](Index i) { add({PairEdge::translated, i, j}); });
  });
  for_each_cone(operands.a, operands.directions.rank_a, [&](Index i, Rank in, Rank out) {
    ranked.b.for_each(in, out, [&](Index j) { add({PairEdge::corner, i, j}); });
  });
  std::partial_sum(places.begin(), places.end(), places.begin());

  constexpr std::uint32_t width = EightLanes::width;
  std::uint32_t counts[most_levels];  // of blocks, from those of edges up
  auto count = static_cast<std::uint32_t>(size);
  levels_ = 0;
  do {
    count = (count + width - 1) / width;
    counts[levels_++] = count;
  } while (count > 1);
  first_block_[0] = 0;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    first_block_[level + 1] = first_block_[level] + counts[levels_ - 1 - level];
  }
  blocks_.resize(first_block_[levels_]);
  edges_.resize(size);
  Block* const leaves = &blocks_[first_block_[levels_ - 1]];
  for (const BoxedEdge& e : edges) {
    const std::uint32_t place = places[e.cell]++;
    edges_[place] = e.edge;
    put(leaves[place / width], place % width, e.box);
  }
  for (auto k = static_cast<std::uint32_t>(size); k % width != 0; ++k) {
    put(leaves[k / width], k % width, nothing);
  }
  for (std::uint32_t level = levels_ - 1; level-- > 0;) {
    const std::uint32_t children = counts[levels_ - 2 - level];
    for (std::uint32_t k = 0; k < width * counts[levels_ - 1 - level]; ++k) {
      put(blocks_[first_block_[level] + k / width], k % width,
          k < children ? join(blocks_[first_block_[level + 1] + k]) : nothing);
    }
  }
}

}  // namespace gcv
