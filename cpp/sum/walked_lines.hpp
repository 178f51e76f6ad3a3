// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Superset edges of one direction on one line, of which thousands can overlap: those of combs and
// grids. Each part of a line needs to be walked once.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "contributing_vertices.hpp"
#include "tally.hpp"

namespace gcv {

class WalkedLines {
 public:
  // `slack`: how far coordinates of points in relative coordinates may be off.
  WalkedLines(const Operands& operands, double slack, Tally& tally);

  // Do others that were walked hold the whole edge? Takes it for walked. Where no other edge has
  // its direction it does not ask.
  bool hold(const PairEdge& s);

 private:
  // A part of a line from one sum of vertices to another.
  struct Part {
    VertexSum from;
    VertexSum to;
  };
  struct Line {
    PairEdge edge;            // that lies on it
    std::vector<Part> parts;  // in order, apart from one another
  };

  // The place of the line of the edge, in units of several times the slack; the same for all edges
  // on it, or next to that.
  [[nodiscard]] std::int64_t place_of(const PairEdge& s) const;
  static std::uint64_t key(const PairEdge& s, std::int64_t place);
  // Null if nothing on it was walked.
  Line* line_of(const PairEdge& s);
  // The sign of the way from p to q along the edge.
  int compare_along(const PairEdge& s, const VertexSum& p, const VertexSum& q);

  const Operands& operands_;
  double unit_;
  Tally& tally_;
  std::vector<std::uint32_t> edges_of_rank_;
  std::unordered_map<std::uint64_t, std::vector<Line>> lines_;
};

}  // namespace gcv
