// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Outlines of trees whose nodes are the cells of a square grid and whose edges join
// neighbours: mazes, and Hilbert's curve.
#include <array>
#include <cstddef>
#include <utility>

#include "shapes.hpp"

namespace gcv::bench {

namespace {

struct Cell {
  int x = 0;
  int y = 0;
};

// East, north, west, south.
constexpr std::array<Cell, 4> ahead{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Cell neighbour(const Cell& cell, int direction) {
  const Cell& step = ahead[static_cast<std::size_t>(direction % 4)];
  return {cell.x + step.x, cell.y + step.y};
}

class GridTree {
 public:
  explicit GridTree(int size)
      : size_(size), joined_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

  [[nodiscard]] bool has(const Cell& cell) const {
    return cell.x >= 0 && cell.x < size_ && cell.y >= 0 && cell.y < size_;
  }
  [[nodiscard]] bool is_joined(const Cell& cell, int direction) const {
    return joined_[index(cell)][static_cast<std::size_t>(direction % 4)];
  }
  [[nodiscard]] bool is_free(const Cell& cell) const {
    return joined_[index(cell)] == std::array<bool, 4>{};
  }

  Cell join(const Cell& cell, int direction) {
    const Cell next = neighbour(cell, direction);
    joined_[index(cell)][static_cast<std::size_t>(direction % 4)] = true;
    joined_[index(next)][static_cast<std::size_t>((direction + 2) % 4)] = true;
    return next;
  }

  // Goes round the tree with its right hand on the outline, a quarter of a cell away.
  [[nodiscard]] Ring outline() const {
    Cell cell{0, 0};
    int direction = is_joined(cell, 0) ? 0 : 1;
    const int first = direction;
    Ring ring;
    do {
      cell = neighbour(cell, direction);
      direction = turn(ring, cell, direction);
    } while (cell.x != 0 || cell.y != 0 || direction != first);
    return ring;
  }

 private:
  [[nodiscard]] std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(size_) +
           static_cast<std::size_t>(cell.x);
  }

  // Turns right as far as the tree goes; adds the corners of the outline.
  int turn(Ring& ring, const Cell& cell, int direction) const {
    if (is_joined(cell, direction + 3)) {
      add_corner(ring, cell, direction + 2, direction + 3);
      return (direction + 3) % 4;
    }
    while (!is_joined(cell, direction)) {
      add_corner(ring, cell, direction, direction + 3);
      direction = (direction + 1) % 4;
    }
    return direction;
  }

  static void add_corner(Ring& ring, const Cell& cell, int one_side, int other_side) {
    const Cell p = neighbour(neighbour(cell, one_side), other_side);
    ring.push_back({cell.x + 0.25 * (p.x - cell.x), cell.y + 0.25 * (p.y - cell.y)});
  }

  int size_;
  std::vector<std::array<bool, 4>> joined_;
};

}  // namespace

Ring maze(Random& random, int cells_in_a_row) {
  GridTree tree(cells_in_a_row);
  std::vector<Cell> path{{0, 0}};
  while (!path.empty()) {
    const int first = test::uniform(random, 0, 3);
    int turns = 0;
    for (; turns < 4; ++turns) {
      const Cell next = neighbour(path.back(), first + turns);
      if (tree.has(next) && tree.is_free(next)) {
        path.push_back(tree.join(path.back(), first + turns));
        break;
      }
    }
    if (turns == 4) {
      path.pop_back();
    }
  }
  return tree.outline();
}

namespace {

// The place of the cell with this number along Hilbert's curve.
Cell hilbert_cell(int level, int number) {
  Cell cell;
  for (int size = 1; size < 1 << level; size *= 2) {
    const int right = number / 2 % 2;
    const int up = (number ^ right) % 2;
    if (up == 0) {
      if (right == 1) {
        cell = {size - 1 - cell.x, size - 1 - cell.y};
      }
      std::swap(cell.x, cell.y);
    }
    cell = {cell.x + size * right, cell.y + size * up};
    number /= 4;
  }
  return cell;
}

}  // namespace

Ring hilbert(int level) {
  GridTree tree(1 << level);
  Cell cell = hilbert_cell(level, 0);
  for (int number = 1; number < 1 << 2 * level; ++number) {
    const Cell next = hilbert_cell(level, number);
    int direction = 0;
    while (neighbour(cell, direction).x != next.x || neighbour(cell, direction).y != next.y) {
      ++direction;
    }
    cell = tree.join(cell, direction);
  }
  return tree.outline();
}

}  // namespace gcv::bench
