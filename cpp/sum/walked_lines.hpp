// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Superset edges of one direction on one line, of which thousands can overlap: those of combs and
// grids. Each part of a line needs to be walked once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contributing_vertices.hpp"
#include "edge_lines.hpp"
#include "tally.hpp"

namespace gcv {

class WalkedLines {
 public:
  // `slack`: how far coordinates of points in relative coordinates may be off.
  WalkedLines(const Operands& operands, double slack, Tally& tally);

  // From now on none was walked.
  void clear() { lines_.clear(); }

  // A part of a line from one sum of vertices to another.
  struct Part {
    VertexSum from;
    VertexSum to;
  };
  // The parts of an edge that others left, in order. Takes it for walked. Where no other edge has
  // its direction it does not ask.
  std::span<const Part> left_of(const PairEdge& s);

 private:
  // The sign of the way from p to q along the edge.
  int compare_along(const PairEdge& s, const VertexSum& p, const VertexSum& q);

  const Operands& operands_;
  Tally& tally_;
  std::vector<std::uint32_t> edges_of_rank_;
  EdgeLines<std::vector<Part>> lines_;  // their parts, in order, apart from one another
  std::vector<Part> left_;
};

}  // namespace gcv
