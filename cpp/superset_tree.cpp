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
  // That of the centre of a box.
  [[nodiscard]] std::uint32_t cell(const FourFloats& box) const {
    return spread(coordinate(box[0] + box[2])) | spread(coordinate(box[1] + box[3])) << 1U;
  }

 private:
  // Of twice a number. Where numbers have overflowed, any will do.
  [[nodiscard]] std::uint32_t coordinate(float twice_x) const {
    const auto cells = static_cast<float>(1U << bits_);
    const float place = (twice_x + 2) * (cells / 4);
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

constexpr float infinity = std::numeric_limits<float>::infinity();

// Boxes have their sides in the order of SupersetTree::Block.
constexpr FourFloats nothing{infinity, infinity, -infinity, -infinity};
constexpr FourFloats everything{-infinity, -infinity, infinity, infinity};

// A vertex of a polygon, with its coordinates twice, and the box of the edge behind it, in the
// unit of the tree.
struct ScaledVertex {
  FourFloats point;
  FourFloats box;
};

void scale_vertices(const Polygon& polygon, double scale, ScaledVertex* vertices) {
  const auto point = [&](Index i) {
    const Point p = polygon.relative(i);
    const auto x = static_cast<float>(p.x * scale);
    const auto y = static_cast<float>(p.y * scale);
    return FourFloats{x, y, x, y};
  };
  vertices[0].point = point(0);
  for (Index i = 0; i < polygon.size(); ++i) {
    const Index next = polygon.next(i);
    if (next != 0) {
      vertices[next].point = point(next);
    }
    const FourFloats& p = vertices[i].point;
    const FourFloats& q = vertices[next].point;
    vertices[i].box = FourFloats{std::min(p[0], q[0]), std::min(p[1], q[1]), std::max(p[0], q[0]),
                                 std::max(p[1], q[1])};
  }
}

struct BoxedEdge {
  FourFloats box;
  PairEdge edge;
  std::uint32_t cell;
};

void put(SupersetTree::Block& block, std::uint32_t lane, const FourFloats& box) {
  for (unsigned side = 0; side < 4; ++side) {
    block.sides[side][lane] = box[side];
  }
}

FourFloats join(const SupersetTree::Block& block) {
  const auto& sides = block.sides;
  FourFloats box{sides[0][0], sides[1][0], sides[2][0], sides[3][0]};
  for (std::uint32_t lane = 1; lane < EightLanes::width; ++lane) {
    box = FourFloats{std::min(box[0], sides[0][lane]), std::min(box[1], sides[1][lane]),
                     std::max(box[2], sides[2][lane]), std::max(box[3], sides[3][lane])};
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
  std::vector<ScaledVertex> scaled(std::size_t{operands.a.size()} + operands.b.size());
  ScaledVertex* const scaled_a = scaled.data();
  ScaledVertex* const scaled_b = scaled_a + operands.a.size();
  scale_vertices(operands.a, scale_, scaled_a);
  scale_vertices(operands.b, scale_, scaled_b);
  const auto add = [&](const PairEdge& edge, const FourFloats& sum) {
    const FourFloats box = scale_ == 0 ? everything : sum;
    const std::uint32_t cell = order.cell(box);
    ++places[cell + 1];
    edges.push_back({box, edge, cell});
  };
  for_each_cone(operands.b, operands.directions.rank_b, [&](Index j, Rank in, Rank out) {
    ranked.a.for_each(in, out, [&](Index i) {
      add(operands.translated(i, j), scaled_a[i].box + scaled_b[j].point);
    });
  });
  for_each_cone(operands.a, operands.directions.rank_a, [&](Index i, Rank in, Rank out) {
    ranked.b.for_each(
        in, out, [&](Index j) { add(operands.corner(i, j), scaled_a[i].point + scaled_b[j].box); });
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
  std::uint32_t blocks = 0;
  for (std::uint32_t level = 0; level < levels_; ++level) {
    nodes_[level] = counts[levels_ - 1 - level];
    first_block_[level] = blocks;
    blocks += nodes_[level];
  }
  nodes_[levels_] = static_cast<std::uint32_t>(size);
  blocks_.resize(blocks);
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
    for (std::uint32_t k = 0; k < width * nodes_[level]; ++k) {
      put(blocks_[first_block_[level] + k / width], k % width,
          k < nodes_[level + 1] ? join(blocks_[first_block_[level + 1] + k]) : nothing);
    }
  }
}

}  // namespace gcv
