// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A grid over the sum, or over the part of it that is looked at, and cells of it that lie in the
// open sum int A + int B: parts of the sum of a cell inside A and a cell inside B, and cells inside
// witnesses. Together they cover lines and boxes that no witness covers alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "bit_rows.hpp"
#include "box.hpp"
#include "contributing_vertices.hpp"
#include "half_planes.hpp"
#include "witness.hpp"

namespace gcv {

class CoveredCells {
 public:
  // `slack`: how far points in relative coordinates may be off. O(n + m), and O(1) for each row of
  // the grid that an edge meets.
  CoveredCells(const Operands& operands, double slack);

  // Adds the cells that lie in a witness.
  void add(const Witness& witness);

  // Adds the cells that lie in the part of a box that half-planes share. In relative coordinates;
  // as in convex_sums.hpp, `least` allows for errors.
  void add(std::span<const HalfPlanes> half_planes, const Box& box);

  // Are there none, and never will be?
  [[nodiscard]] bool empty() const { return bits_.empty(); }
  // Do covered cells hold the box?
  [[nodiscard]] bool hold(const Box& box) const;

  // How far covered cells hold the line from t on: a parameter up to 1, at least t. Stops where it
  // enters the first column, or row, in which they do not.
  [[nodiscard]] double reach(const RelativeLine& line, double t) const;

 private:
  // How far the line stays in the grid from t on: a parameter up to 1, t if it is not there.
  [[nodiscard]] double end_in_grid(const RelativeLine& line, double t) const;
  // The cell that holds a coordinate in cells, or the nearest one.
  [[nodiscard]] std::uint32_t cell(double place) const {
    return place > 0 ? static_cast<std::uint32_t>(place < last_ ? place : last_) : 0;
  }
  // Are cells much larger than their margin?
  [[nodiscard]] bool has_room() const { return 64 * margin_ < size_.x && 64 * margin_ < size_.y; }
  // In column x of row y.
  [[nodiscard]] bool is_set(std::uint32_t x, std::uint32_t y) const {
    return (bits_[y * words_ + x / word_size] >> (x % word_size) & 1U) != 0;
  }

  // How far a half-plane holds rows, numbered from below: x up to, or from, first + step * row.
  struct RowBound {
    double first;
    double step;
  };
  std::vector<RowBound> lows_;  // of one polygon
  std::vector<RowBound> highs_;

  std::uint32_t side_ = 0;
  std::uint32_t words_ = 0;  // of a row
  double last_ = 0;          // the number of the last cell
  double margin_;
  Box box_{};  // of the grid
  Point origin_{};
  Point size_{};  // of a cell
  Point cells_a_unit_{};
  std::vector<Word> bits_;  // none for small polygons, or if no cell is certain
};

}  // namespace gcv
