// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Jigsaws of our own: a square cut into pieces that share their corners, random doubles.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "invariants.hpp"

namespace gcv::test {

using Corner = std::size_t;
using Cycle = std::vector<Corner>;  // of a ring

// The boundary of triangles; empty if it is not one ring that passes no corner twice.
inline Cycle boundary_of(const std::vector<Cycle>& triangles) {
  std::map<std::pair<Corner, Corner>, bool> edges;
  for (const Cycle& triangle : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges[{triangle[k], triangle[(k + 1) % 3]}] = true;
    }
  }
  std::map<Corner, Corner> next;
  for (const auto& [edge, there] : edges) {
    if (edges.count({edge.second, edge.first}) == 0 && !next.insert(edge).second) {
      return {};
    }
  }
  Cycle ring;
  for (Corner at = next.begin()->first; ring.empty() || at != ring.front(); at = next[at]) {
    ring.push_back(at);
  }
  return ring.size() == next.size() ? ring : Cycle{};
}

// The corners of `cells` by `cells` cells, off the grid by random doubles; those on the sides of
// the square stay there.
inline std::vector<invariants::Point> jittered_grid(std::mt19937_64& random, std::size_t cells) {
  const auto off = [&](std::size_t place) {
    const double by = static_cast<double>(random() >> 11) * 0x1p-53 * 0.6 - 0.3;
    return static_cast<double>(place) + (place % cells == 0 ? 0 : by);
  };
  std::vector<invariants::Point> corners;
  for (std::size_t row = 0; row <= cells; ++row) {
    for (std::size_t column = 0; column <= cells; ++column) {
      const double x = off(column);
      corners.push_back({x, off(row)});
    }
  }
  return corners;
}

// Each cell is cut into two triangles, and these are joined across random edges until there are
// `count` pieces, each of eight triangles at most.
inline std::vector<std::vector<Cycle>> joined_triangles(std::mt19937_64& random, std::size_t cells,
                                                        std::size_t count) {
  std::vector<std::vector<Cycle>> pieces;
  for (std::size_t k = 0; k < cells * cells; ++k) {
    const Corner a = k / cells * (cells + 1) + k % cells;
    const Cycle cell{a, a + 1, a + cells + 2, a + cells + 1};
    const std::size_t from = random() % 2;
    pieces.push_back({{cell[from], cell[from + 1], cell[from + 2]}});
    pieces.push_back({{cell[from], cell[from + 2], cell[(from + 3) % 4]}});
  }
  std::map<std::pair<Corner, Corner>, std::size_t> triangle_at;
  std::vector<std::array<std::size_t, 2>> neighbours;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const Cycle& triangle = pieces[k].front();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::pair<Corner, Corner> edge{triangle[i], triangle[(i + 1) % 3]};
      triangle_at[edge] = k;
      if (const auto other = triangle_at.find({edge.second, edge.first});
          other != triangle_at.end()) {
        neighbours.push_back({k, other->second});
      }
    }
  }
  std::vector<std::size_t> piece_of(pieces.size());
  std::iota(piece_of.begin(), piece_of.end(), std::size_t{0});
  for (std::size_t left = pieces.size(); left > count && !neighbours.empty();) {
    std::swap(neighbours[random() % neighbours.size()], neighbours.back());
    const std::size_t into = piece_of[neighbours.back()[0]];
    const std::size_t from = piece_of[neighbours.back()[1]];
    neighbours.pop_back();
    std::vector<Cycle> both = pieces[into];
    both.insert(both.end(), pieces[from].begin(), pieces[from].end());
    if (into != from && both.size() <= 8 && !boundary_of(both).empty()) {
      pieces[into] = both;
      pieces[from].clear();
      std::replace(piece_of.begin(), piece_of.end(), from, into);
      --left;
    }
  }
  const auto is_empty = [](const std::vector<Cycle>& piece) { return piece.empty(); };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), is_empty), pieces.end());
  return pieces;
}

// The pieces of a square from (0, 0) to (cells, cells), in place.
inline std::vector<invariants::Polygon> jigsaw_of(std::mt19937_64& random, std::size_t cells,
                                                  std::size_t count) {
  const std::vector<invariants::Point> corners = jittered_grid(random, cells);
  std::vector<invariants::Polygon> result;
  for (const std::vector<Cycle>& piece : joined_triangles(random, cells, count)) {
    invariants::Polygon& vertices = result.emplace_back();
    for (const Corner corner : boundary_of(piece)) {
      vertices.push_back(corners[corner]);
    }
  }
  return result;
}

}  // namespace gcv::test
