// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Convex parts of the open sum int A + int B, where A is several solids at positions: the sums of
// convex pieces of both polygons, and what is beyond the bounding box of a hole that is their first
// ring. They are larger than witnesses (witness.hpp), and are told by fewer numbers. For one pair
// of polygons, to find them takes longer than they save.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "box.hpp"
#include "contributing_vertices.hpp"
#include "covered_cells.hpp"
#include "half_planes.hpp"
#include "simd.hpp"
#include "witness.hpp"

namespace gcv {

class ConvexSums {
 public:
  // `slack`: as in witness.hpp; there are none if it is infinite. O(m) for m solids; sums are
  // computed when they are near what is asked. Then cells that lie in them are added to `cells`,
  // which must live longer.
  ConvexSums(const Operands& operands, double slack, CoveredCells& cells);

  [[nodiscard]] bool is_empty() const { return solids_.empty(); }

  // Does one of them hold the box, in relative coordinates?
  bool hold(const Box& box);

  // How far they hold the line from t on: a parameter up to 1, at least t. Goes from one to the
  // next where that is progress by so much.
  double reach(const RelativeLine& line, double t, double least_progress);

 private:
  static constexpr std::uint32_t unknown = ~std::uint32_t{0};

  // Elements of a vector from one to before another.
  struct Span {
    std::uint32_t first = unknown;
    std::uint32_t end = unknown;
  };
  // The points x with e x (x - p) > least.
  struct HalfPlane {
    Point p;
    Point e;
    double least;
  };
  // Four sums: what their half-planes share.
  struct Sums {
    BoxBlock<SimdDouble, Box> boxes;
    std::uint32_t piece_a[SimdDouble::width];
    std::uint32_t piece_b[SimdDouble::width];
    Span half_planes[SimdDouble::width];
    unsigned lanes;  // those that are used, as bits
  };
  struct Range {
    double from;
    double to;
  };

  // `size`: how long x - p can be, or 0 if e is exact.
  [[nodiscard]] HalfPlane half_plane(const Point& p, const Point& e, double size) const;
  Span add_half_planes(std::span<const HalfPlane> half_planes);
  // Those of the edges of a piece, beside a piece of the other polygon.
  void find_half_planes(const Boundary& one, std::span<const Index> piece, const Boundary& other,
                        std::span<const Index> beside, double size);
  // Unknown if there are too many.
  const Span& half_planes_of(Sums& sums, std::uint32_t lane);

  // Adds a sum after `count` others of the same solid.
  void add_sum(std::uint32_t count, const Box& box, std::uint32_t piece_a, std::uint32_t piece_b,
               const Span& half_planes);
  void add_sums_of_pieces(Index solid);
  void add_what_is_beyond();
  const Span& sums_of(Index solid);
  // Adds the cells in sums of the largest piece of a solid, and in those with the largest one of B.
  void add_cells(const Span& sums_of_solid);

  // Is test(half-planes, box) true for a sum of a solid that `lanes_of` finds by the boxes?
  template <class Lanes, class Test>
  bool any_of(Index solid, Lanes lanes_of, Test test);

  [[nodiscard]] bool hold(const Box& box, const Span& half_planes) const;
  // Of the parameters in a range, those of points that the half-planes share.
  [[nodiscard]] Range cut(const RelativeLine& line, const Span& half_planes,
                          const Range& range) const;
  // How far sums that hold the point at t on the line hold it.
  double next_reach(const RelativeLine& line, double t);

  const Operands& operands_;
  double slack_;
  CoveredCells& cells_;
  std::vector<Box> boxes_b_;  // of the pieces of B
  std::vector<Box> parts_b_;  // boxes that hold these, to search by
  std::vector<Span> solids_;  // the sums of each, once they are known
  std::vector<Sums> sums_;
  std::vector<HalfPlanes> half_planes_;
  std::size_t most_half_planes_ = 0;
  std::vector<HalfPlane> found_;  // of one sum
};

}  // namespace gcv
