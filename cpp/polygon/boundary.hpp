// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One ring of a polygon, or all of its rings: validated, normalised, and prepared for sums. It
// holds everything that depends on one polygon alone. It does not change once it is made.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "box.hpp"
#include "box_tree.hpp"
#include "buffer.hpp"
#include "chain_index.hpp"
#include "chain_tree.hpp"
#include "chord_tree.hpp"
#include "convex_pieces.hpp"
#include "lazy.hpp"
#include "line_directions.hpp"
#include "point.hpp"
#include "ring_layout.hpp"
#include "touches.hpp"

namespace gcv {

// The most vertices that a polygon can have.
inline constexpr std::size_t vertex_limit = 0x7fffffff;

struct Boundary;

// A boundary at a position.
struct PlacedBoundary {
  const Boundary& boundary;
  Point position;
};

struct Boundary {
  // The solid is to the left of every edge. So outer rings are counter-clockwise and holes are
  // clockwise.
  enum class Kind : std::uint8_t { outer, hole };

  // The first vertex is the lexicographically smallest. No vertex is repeated, and no three in a
  // row are collinear. Edge i goes from vertex i to the next one on its ring. If there are several
  // rings, the outer one comes first.
  PointVector vertices;
  RingLayout layout;

  // What belongs to vertex i and to the edge behind it.
  struct Corner {
    Index vertex_number;  // the caller's
    Index edge_number;    // the caller's; if edges were merged, that of the first along the ring
    bool convex;          // is the solid strictly convex here? Else it is strictly reflex
  };
  Buffer<Corner> corners;

  // Where boundaries are joined at positions: that of each vertex, which is added to it exactly,
  // and each vertex at its position, relative to vertex 0 at its own, rounded.
  PointVector positions;
  PointVector relatives;

  // The first ring of each solid, where there are several. They may overlap. Only the first one can
  // be the outside of its ring. Empty if all rings bound one solid.
  std::vector<Index> solids;
  // The ring behind those of a solid.
  [[nodiscard]] Index solid_end(Index solid) const {
    return solid + 1 < solids.size() ? solids[solid + 1] : layout.ring_count();
  }

  bool is_convex = false;   // all vertices are
  Kind kind = Kind::outer;  // of the first ring

  Box bounds{};  // of the vertices, or of `relatives`
  // Relative bounds of where much is covered, if that is known not to be everywhere.
  std::optional<Box> crowd;
  Index lexicographic_min = 0;
  Index lexicographic_max = 0;

  [[nodiscard]] Index size() const { return static_cast<Index>(vertices.size()); }
  [[nodiscard]] Index next(Index i) const { return layout.next(i); }
  [[nodiscard]] Index previous(Index i) const { return layout.previous(i); }

  [[nodiscard]] Point position(Index i) const {
    return positions.empty() ? Point{0, 0} : positions[i];
  }
  // What is subtracted from `bounds` to make it relative to vertex 0.
  [[nodiscard]] Point origin() const { return positions.empty() ? vertices.front() : Point{0, 0}; }

  [[nodiscard]] Box relative_bounds() const {
    const Point p = origin();
    return {bounds.x0 - p.x, bounds.y0 - p.y, bounds.x1 - p.x, bounds.y1 - p.y};
  }

  // Vertex i relative to vertex 0, rounded. Searches filter with it, so that they filter as well
  // far from the origin as near it. Each coordinate is off by at most 2u times its size.
  [[nodiscard]] Point relative(Index i) const {
    if (!relatives.empty()) {
      return relatives[i];
    }
    const Point& p = vertices[i];
    const Point& origin = vertices.front();
    return {p.x - origin.x, p.y - origin.y};
  }

  // The line direction of edge i, as the direction from one point to another.
  struct LineDirection {
    const Point& from;
    const Point& to;
  };
  [[nodiscard]] LineDirection line_direction(Index i) const {
    const Point& p = vertices[i];
    const Point& q = vertices[next(i)];
    return points_up(p, q) ? LineDirection{p, q} : LineDirection{q, p};
  }

  // The three next parts are made on first use. A sum of two convex polygons needs neither, and so
  // do most sums of a convex polygon and another.
  [[nodiscard]] const LineDirections& line_directions() const;
  // Over relative vertices. Sums with few superset edges do not use it.
  [[nodiscard]] const ChainIndex& index() const;
  // In the order of the edges that is best, whatever it is.
  [[nodiscard]] const ChainIndex& search_index() const;
  // What sums with holes and exact fits take beside it. Made on first use, too.
  struct CoverIndex {
    ChordTree chords;
    Touches touches;  // where rings of one solid touch
    BoxTree solids;  // relative boxes of the solids, if there are several; an outside has the plane
  };
  [[nodiscard]] const CoverIndex& cover_index() const;
  // Of solids that are small and have one ring. Made on first use, too.
  [[nodiscard]] const ConvexPieces& convex_pieces() const;

  // The reflection -R = { -p : p in R }, with the same numbers. Each line direction stays, and each
  // edge points the other way. O(n): the line directions are sorted once for both.
  static Boundary reflected(std::shared_ptr<const Boundary> ring);
  // The complement: the solid is on the other side of all rings. The same numbers. If there are
  // several rings, each bounds a solid of its own.
  [[nodiscard]] Boundary complement() const;
  // All coordinates times a power of two that loses none of their bits. The same numbers.
  [[nodiscard]] Boundary scaled(double scale) const;

 private:
  std::shared_ptr<const Boundary> mirror_;  // the ring that this one reflects
  Lazy<LineDirections> line_directions_;
  Lazy<ChainIndex> index_;
  Lazy<std::optional<ChainIndex>> index_on_curve_;
  Lazy<CoverIndex> cover_index_;
  Lazy<ConvexPieces> convex_pieces_;
  ConvexPieces joined_pieces_;  // where boundaries are joined at positions

  [[nodiscard]] EdgeChain relative_chain() const;
  [[nodiscard]] Touches touches_of_solids() const;
  [[nodiscard]] BoxTree solid_boxes() const;
  friend Boundary joined(std::span<const PlacedBoundary> parts);
  friend Boundary joined(const Boundary& outer, std::span<const Boundary* const> holes);
};

// All of their solids as one boundary. At least one. Only the first can have an outside.
Boundary joined(std::span<const PlacedBoundary> parts);

// An outer ring and its holes as one.
Boundary joined(const Boundary& outer, std::span<const Boundary* const> holes);

// The caller's numbers of the vertices of a boundary and of the edges behind them. These are the
// numbers of the corners. Without corners, they count from `first`.
struct CallersNumbers {
  std::size_t first = 0;
  std::span<const Boundary::Corner> corners = {};
};

// Makes a ring from a boundary. The boundary may have either orientation, may be closed or not, and
// may have repeated and collinear vertices. `name` is its name in messages, such as "polygon".
// Throws Error: invalid_argument, not_finite, degenerate, not_simple.
Boundary make_ring(PointVector boundary, const char* name,
                   Boundary::Kind kind = Boundary::Kind::outer, const CallersNumbers& numbers = {});

}  // namespace gcv
