// SPDX-License-Identifier: LGPL-3.0-or-later
#include "table.hpp"

#include <algorithm>
#include <bit>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace gcv {

namespace {

std::uint64_t count_contributions(const EdgesByRank& edges, const Boundary& polygon,
                                  const Ranks& ranks) {
  std::uint64_t count = 0;
  for_each_cone(polygon, ranks,
                [&](Index /*v*/, Rank in, Rank out) { count += edges.count(in, out); });
  return count;
}

// The cells of a grid in the order of a Z-shaped curve (Morton, 1966), in which neighbours are
// near; one to four for each edge.
class ZOrder {
 public:
  explicit ZOrder(std::size_t edges)
      : bits_(std::min((static_cast<unsigned>(std::bit_width(edges)) + 1) / 2, 8U)),
        mask_(0x00010001U * ((1U << bits_) - 1)) {}

  [[nodiscard]] std::size_t cells() const { return std::size_t{1} << (2 * bits_); }
  // That of the centre of a box. Both coordinates lie side by side, of 16 bits each.
  [[nodiscard]] std::uint32_t cell(const FourShorts& box) const {
    const auto from_zero = std::bit_cast<std::uint64_t>(box) ^ 0x8000800080008000U;
    const std::uint64_t halves = from_zero >> 1U & 0x7fff7fff7fff7fffU;
    const auto centre =
        static_cast<std::uint32_t>(halves) + static_cast<std::uint32_t>(halves >> 32U);
    // Their first bits, 8 at most, with zeros between them.
    std::uint32_t z = centre >> (16 - bits_) & mask_;
    z = (z | z << 4U) & 0x0f0f0f0fU;
    z = (z | z << 2U) & 0x33333333U;
    z = (z | z << 1U) & 0x55555555U;
    return (z | z >> 15U) & 0xffffU;
  }

 private:
  unsigned bits_;
  std::uint32_t mask_;
};

using ShortBox = SimdBox<SimdShort>;

constexpr ShortBox no_box{SimdShort::highest, SimdShort::highest, SimdShort::lowest,
                          SimdShort::lowest};

// A vertex of a polygon, with its coordinates twice, and the box of the edge behind it.
struct PlacedVertex {
  FourShorts point;
  FourShorts box;
};

void place_vertices(const Boundary& polygon, const CoarseGrid& grid, PlacedVertex* vertices) {
  const auto point = [&](Index i) {
    const Point p = grid.place(polygon.relative(i));
    const auto x = static_cast<std::int16_t>(CoarseGrid::rounded(p.x));
    const auto y = static_cast<std::int16_t>(CoarseGrid::rounded(p.y));
    return FourShorts{x, y, x, y};
  };
  for (Index i = 0; i < polygon.size(); ++i) {
    vertices[i].point = point(i);
  }
  polygon.layout.for_each_edge([&](Index i, Index next) {
    const FourShorts& p = vertices[i].point;
    const FourShorts& q = vertices[next].point;
    vertices[i].box = FourShorts{std::min(p[0], q[0]), std::min(p[1], q[1]), std::max(p[0], q[0]),
                                 std::max(p[1], q[1])};
  });
}

struct BoxedEdge {
  FourShorts box;
  PairEdge edge;
  std::uint32_t cell;
};

// Of the box of a polygon, relative to its vertex 0.
Point middle_of(const Boundary& polygon) {
  const Box box = polygon.relative_bounds();
  return {(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2};
}

// For whole extents of 2^16 units less a few.
Point scale_of(const Operands& operands) {
  constexpr double units = 65520;
  const Box& a = operands.a.bounds;
  const Box& b = operands.b.bounds;
  return {units / ((a.x1 - a.x0) + (b.x1 - b.x0)), units / ((a.y1 - a.y0) + (b.y1 - b.y0))};
}

}  // namespace

SupersetCount count_superset(const Operands& operands, const RankedEdges& ranked) {
  return {count_contributions(ranked.a, operands.b, operands.directions.rank_b),
          count_contributions(ranked.b, operands.a, operands.directions.rank_a)};
}

CoarseGrid::CoarseGrid(const Operands& operands) : scale_(scale_of(operands)) {
  const Point a = middle_of(operands.a);
  const Point b = middle_of(operands.b);
  middle_ = {a.x + b.x, a.y + b.y};
}

CoarseGrid CoarseGrid::of(const Boundary& polygon) const { return {scale_, middle_of(polygon)}; }

bool CoarseGrid::is_fine_enough(const Operands& operands) const {
  const Point shortest{2 / scale_.x, 2 / scale_.y};
  const auto are_long_or_few = [&](const Boundary& polygon) {
    Index short_edges = 0;
    polygon.layout.for_each_edge([&](Index i, Index next) {
      const Point& p = polygon.vertices[i];
      const Point& q = polygon.vertices[next];
      if (std::abs(q.x - p.x) <= shortest.x && std::abs(q.y - p.y) <= shortest.y) {
        ++short_edges;
      }
    });
    return short_edges <=
           std::max(limits::most_short_edges, polygon.size() / limits::edges_a_short_one);
  };
  const auto is_usable = [](double scale) { return scale > 0 && std::isfinite(scale); };
  return is_usable(scale_.x) && is_usable(scale_.y) && are_long_or_few(operands.a) &&
         are_long_or_few(operands.b);
}

SupersetTable::SupersetTable(const Operands& operands, const CoarseGrid& grid,
                             const RankedEdges& ranked, std::size_t size)
    : grid_(grid) {
  const ZOrder order(size);
  // What few edges take is on the stack: 5 KB.
  boost::container::small_vector<std::uint32_t, 257> places(order.cells() + 1);  // of first edges
  boost::container::small_vector<BoxedEdge, 64> edges;
  edges.reserve(size);
  boost::container::small_vector<PlacedVertex, 64> placed(
      std::size_t{operands.a.size()} + operands.b.size(), boost::container::default_init);
  PlacedVertex* const placed_a = placed.data();
  PlacedVertex* const placed_b = placed_a + operands.a.size();
  place_vertices(operands.a, grid.of(operands.a), placed_a);
  place_vertices(operands.b, grid.of(operands.b), placed_b);
  const auto add = [&](const PairEdge& edge, const FourShorts& box) {
    const std::uint32_t cell = order.cell(box);
    ++places[cell + 1];
    edges.push_back({box, edge, cell});
  };
  for_each_cone(operands.b, operands.directions.rank_b, [&](Index j, Rank in, Rank out) {
    ranked.a.for_each(in, out, [&](Index i) {
      add(operands.translated(i, j), placed_a[i].box + placed_b[j].point);
    });
  });
  for_each_cone(operands.a, operands.directions.rank_a, [&](Index i, Rank in, Rank out) {
    ranked.b.for_each(
        in, out, [&](Index j) { add(operands.corner(i, j), placed_a[i].point + placed_b[j].box); });
  });
  std::partial_sum(places.begin(), places.end(), places.begin());

  constexpr std::uint32_t width = SimdShort::width;
  const auto leaves = static_cast<std::uint32_t>((size + width - 1) / width);
  for (std::uint32_t nodes = 1; nodes < leaves; nodes *= width) {
    first_leaf_ = width * first_leaf_ + 1;
  }
  blocks_.resize(std::size_t{first_leaf_} + leaves);
  edges_.resize(size);
  Block* level = &blocks_[first_leaf_];
  for (const BoxedEdge& e : edges) {
    const std::uint32_t place = places[e.cell]++;
    edges_[place] = e.edge;
    level[place / width].put(place % width, std::bit_cast<ShortBox>(e.box));
  }
  for (auto k = static_cast<std::uint32_t>(size); k % width != 0; ++k) {
    level[k / width].put(k % width, no_box);
  }
  std::uint32_t first = first_leaf_;
  for (std::uint32_t count = leaves; count > 1; count = (count + width - 1) / width) {
    const Block* const below = &blocks_[first];
    first = (first - 1) / width;
    level = &blocks_[first];
    for (std::uint32_t k = 0; k < count; ++k) {
      level[k / width].put(k % width, below[k].hull());
    }
    for (std::uint32_t k = count; k % width != 0; ++k) {
      level[k / width].put(k % width, no_box);
    }
  }
}

}  // namespace gcv
