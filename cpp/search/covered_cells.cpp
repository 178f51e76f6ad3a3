// SPDX-License-Identifier: LGPL-3.0-or-later
#include "covered_cells.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bit_rows.hpp"
#include "solid_cells.hpp"

namespace gcv {

namespace {

// With fewer pairs of vertices, a grid takes longer than what it saves.
constexpr std::uint64_t fewest_pairs = 150;

// Finer grids leave fewer edges to search for, and take longer: with the third power of the side
// where solids are cut into many runs. bench/regions is quickest about here, from stars of 40
// vertices to coasts of 10^4.
std::uint32_t side_for_pairs(std::uint64_t pairs) {
  return static_cast<std::uint32_t>(
      std::min(12 * std::sqrt(std::sqrt(static_cast<double>(pairs))), 2048.0));
}

// Where solids are cut into more runs than that allows, the grid is made coarser: grilles. Shapes
// without many bars take 40 to 160.
constexpr std::uint64_t sums_a_vertex = 500;

// So that each of many rings spread over the grid is so many cells wide, and high: else no cell
// would lie inside a block of a wall.
constexpr int cells_a_ring = 8;
std::uint32_t side_for_rings(std::size_t rings) {
  return static_cast<std::uint32_t>(
      std::min(cells_a_ring * std::sqrt(static_cast<double>(rings)), 2048.0));
}

// That is of use beside small polygons: walls and plates with up to 20 take 0.06 to 0.7 of the
// time, those with 40 to 330 up to 2.5 times as long.
constexpr std::uint64_t sums_a_vertex_of_rings = 25;

// Are sums of convex pieces to be added, of pieces that make up the solids? They cover what sums of
// cells do, which take up to 14 % of the time of a layout.
bool have_convex_sums(const Operands& operands) {
  const auto are_in_pieces = [](const Boundary& solids) {
    const Index container = solids.kind == Boundary::Kind::hole ? solids.layout.end(0) : 0;
    return solids.convex_pieces().vertices.size() >= solids.size() - container;
  };
  return !operands.a.positions.empty() && !operands.a.solids.empty() && are_in_pieces(operands.a) &&
         are_in_pieces(operands.b);
}

}  // namespace

// The corners of cells, the number of the cell of a point, and where a line enters a cell, are
// computed with errors that are worth less than the margin.
CoveredCells::CoveredCells(const Operands& operands, double slack) : margin_(slack) {
  const std::uint64_t pairs = std::uint64_t{operands.a.size()} * operands.b.size();
  if (pairs < fewest_pairs) {
    return;
  }
  // What both grids hold. Where one solid alone is near, cells would save little.
  const Box of_b = operands.b.relative_bounds();
  Box of_a = operands.a.crowd ? *operands.a.crowd : operands.a.relative_bounds();
  if (operands.focus) {
    const Box& focus = *operands.focus;
    of_a = {std::max(of_a.x0, focus.x0 - of_b.x1), std::max(of_a.y0, focus.y0 - of_b.y1),
            std::min(of_a.x1, focus.x1 - of_b.x0), std::min(of_a.y1, focus.y1 - of_b.y0)};
  }
  if (!(of_a.x0 < of_a.x1 && of_a.y0 < of_a.y1)) {
    return;  // nothing of it is near
  }
  const Box bounds = sum_of(of_a, of_b);
  box_ = bounds;
  origin_ = {bounds.x0, bounds.y0};
  struct Cut {
    const Boundary& solid;
    Box box;
    std::vector<CellRun> inside{};
  };
  Cut cut_a{operands.a, of_a};
  Cut cut_b{operands.b, of_b};
  const bool a_has_more = cut_a.solid.layout.ring_count() > cut_b.solid.layout.ring_count();
  Cut& more = a_has_more ? cut_a : cut_b;
  Cut& fewer = a_has_more ? cut_b : cut_a;
  const bool are_convex = have_convex_sums(operands);
  // `least`: how many runs of that with more rings to expect at least.
  const auto are_few_sums = [&](std::uint32_t side, std::uint64_t a_vertex, std::uint64_t least) {
    side_ = side;
    size_ = {(bounds.x1 - bounds.x0) / side, (bounds.y1 - bounds.y0) / side};
    if (!has_room()) {
      return false;
    }
    if (are_convex) {
      return true;
    }
    const std::uint64_t most = a_vertex * (std::uint64_t{operands.a.size()} + operands.b.size());
    fewer.inside = cells_inside(fewer.solid, fewer.box, size_, margin_);
    if (least * fewer.inside.size() > most) {
      return false;
    }
    more.inside = cells_inside(more.solid, more.box, size_, margin_);
    return std::uint64_t{more.inside.size()} * fewer.inside.size() <= most;
  };
  std::uint32_t side = side_for_pairs(pairs);
  const std::size_t rings = more.solid.layout.ring_count();
  const std::uint32_t finer = side_for_rings(rings);
  if (!(finer > side && are_few_sums(finer, sums_a_vertex_of_rings, rings * cells_a_ring / 2))) {
    while (!are_few_sums(side, sums_a_vertex, 0)) {
      if (!has_room()) {
        return;
      }
      side /= 2;
    }
  }
  words_ = (side_ + word_size - 1) / word_size;
  last_ = side_ - 1;
  cells_a_unit_ = {1 / size_.x, 1 / size_.y};
  bits_.resize(std::size_t{side_} * words_);
  // The sum of two cells is a square of four: the lower two, then the upper two.
  for (const CellRun& a : cut_a.inside) {
    for (const CellRun& b : cut_b.inside) {
      const std::uint32_t row = a.row + b.row;
      const std::uint32_t from = a.from + b.from;
      if (row < side_ && from < side_) {
        set(&bits_[std::size_t{row} * words_], from, std::min(a.to + b.to, side_));
      }
    }
  }
  for (std::size_t k = bits_.size(); k-- > words_;) {
    bits_[k] |= bits_[k - words_];
  }
}

// A strip leaves those columns of a row of cells that lie between two lines.
void CoveredCells::add(const Witness& witness) {
  const Point& corner = witness.corner;
  const Box& box = witness.bounds;
  if (bits_.empty() || !((box.x1 - box.x0) > size_.x && (box.y1 - box.y0) > size_.y)) {
    return;
  }
  double first_row = std::ceil((box.y0 - origin_.y) * cells_a_unit_.y);
  double end_row = std::floor((box.y1 - origin_.y) * cells_a_unit_.y);
  const double height = size_.y + 2 * margin_;  // of a row with its margin
  const double left = origin_.x - corner.x;
  const double low = origin_.y - corner.y - margin_;  // of the first row, from the corner
  // Both ends of what it leaves of the first row, in columns, and how they move from row to row.
  struct Columns {
    double from;
    double to;
    double step;
  };
  Columns columns[2];
  for (int k = 0; k < 2; ++k) {
    const Witness::Strip& strip = witness.strips[k];
    if (!(strip.least < strip.most)) {
      return;
    }
    if (strip.p == 0) {
      // It leaves whole rows.
      const double bound = -1 / strip.q;
      const double from = std::min(strip.least * bound, strip.most * bound);
      const double to = std::max(strip.least * bound, strip.most * bound);
      first_row = std::max(first_row, std::ceil((from - low + margin_) * cells_a_unit_.y));
      end_row = std::min(end_row, std::floor((to - low - 3 * margin_) * cells_a_unit_.y));
      columns[k] = {0, static_cast<double>(side_), 0};
      continue;
    }
    const double inverse = 1 / strip.p;
    const double slope = strip.q * inverse;
    const double a = strip.least * inverse;
    const double b = strip.most * inverse;
    const double reach = std::max(std::abs(low), std::abs(low + (side_ + 1) * size_.y));
    const double error = 0x1p-49 * (std::abs(a) + std::abs(b) + std::abs(slope) * reach) +
                         (2 + 4 * std::abs(slope)) * margin_;
    const double at_low = slope * low;
    const double at_high = slope * (low + height);
    columns[k] = {(std::min(a, b) + std::max(at_low, at_high) + error - left) * cells_a_unit_.x,
                  (std::max(a, b) + std::min(at_low, at_high) - error - left) * cells_a_unit_.x,
                  slope * size_.y * cells_a_unit_.x};
    // Nearly level strips overflow. Nothing is certain then.
    if (!std::isfinite(columns[k].from) || !std::isfinite(columns[k].to) ||
        !std::isfinite(columns[k].step)) {
      return;
    }
  }
  first_row = std::max(first_row, 0.0);
  end_row = std::min(end_row, last_ + 1);
  if (!(first_row < end_row)) {
    return;
  }
  const auto end = static_cast<std::uint32_t>(end_row);
  for (auto row = static_cast<std::uint32_t>(first_row); row < end; ++row) {
    const double from =
        std::max(columns[0].from + row * columns[0].step, columns[1].from + row * columns[1].step);
    const double to =
        std::min(columns[0].to + row * columns[0].step, columns[1].to + row * columns[1].step);
    if (!(to - from >= 1) || !(to >= 1) || !(from <= last_)) {
      continue;
    }
    const std::uint32_t column = from > 0 ? static_cast<std::uint32_t>(std::ceil(from)) : 0;
    const auto last = static_cast<std::uint32_t>(std::min(to, last_ + 1));
    if (column < last) {
      set(&bits_[std::size_t{row} * words_], column, last);
    }
  }
}

// A point of a cell is off by less than the margin, and so are the columns here. The bounds of a
// row have some roundings of |e| times the size of the grid, which `least` allows for.
void CoveredCells::add(std::span<const HalfPlanes> half_planes, const Box& box) {
  if (bits_.empty()) {
    return;
  }
  const double margin = 2 * margin_;
  double low = box.y0;
  double high = box.y1;
  lows_.clear();
  highs_.clear();
  for (const HalfPlanes& four : half_planes) {
    for (std::uint32_t lane = 0; lane < SimdDouble::width; ++lane) {
      const double ex = four.ex[lane];
      const double ey = four.ey[lane];
      if (ey == 0) {
        const double bound = four.py[lane] + four.least[lane] / ex;
        low = ex > 0 ? std::max(low, bound) : low;
        high = ex < 0 ? std::min(high, bound) : high;
        continue;
      }
      const double inverse = 1 / ey;
      const double y = ex > 0 ? origin_.y - margin : origin_.y + size_.y + margin;
      const RowBound bound{four.px[lane] + (ex * (y - four.py[lane]) - four.least[lane]) * inverse,
                           ex * size_.y * inverse};
      if (!std::isfinite(bound.first) || !std::isfinite(bound.step)) {
        return;  // it is nearly level
      }
      (ey > 0 ? highs_ : lows_).push_back(bound);
    }
  }
  const std::uint32_t first = cell((low + margin - origin_.y) * cells_a_unit_.y) + 1;
  const std::uint32_t end = cell((high - margin - origin_.y) * cells_a_unit_.y);
  for (std::uint32_t rows = first; rows < end; rows += SimdDouble::width) {
    const double number = rows;
    const double numbers[SimdDouble::width] = {number, number + 1, number + 2, number + 3};
    const SimdDouble row = SimdDouble::load(numbers);
    SimdDouble from = SimdDouble::of(box.x0);
    SimdDouble to = SimdDouble::of(box.x1);
    for (const RowBound& bound : lows_) {
      from = larger(from, bound.step * row + bound.first);
    }
    for (const RowBound& bound : highs_) {
      to = smaller(to, bound.step * row + bound.first);
    }
    double columns_from[SimdDouble::width];
    double columns_to[SimdDouble::width];
    (cells_a_unit_.x * (from + (margin - origin_.x))).store(columns_from);
    (cells_a_unit_.x * (to + (-margin - origin_.x))).store(columns_to);
    for (std::uint32_t lane = 0; lane < SimdDouble::width && rows + lane < end; ++lane) {
      const std::uint32_t column = cell(columns_from[lane]) + 1;
      const std::uint32_t last = cell(columns_to[lane]);
      if (column < last) {
        set(&bits_[std::size_t{rows + lane} * words_], column, last);
      }
    }
  }
}

bool CoveredCells::hold(const Box& box) const {
  const bool is_in_grid =
      box.x0 >= box_.x0 && box.y0 >= box_.y0 && box.x1 <= box_.x1 && box.y1 <= box_.y1;
  if (bits_.empty() || !is_in_grid) {
    return false;
  }
  const std::uint32_t from = cell((box.x0 - origin_.x) * cells_a_unit_.x);
  const std::uint32_t to = cell((box.x1 - origin_.x) * cells_a_unit_.x) + 1;
  const std::uint32_t first = cell((box.y0 - origin_.y) * cells_a_unit_.y);
  const std::uint32_t last = cell((box.y1 - origin_.y) * cells_a_unit_.y);
  const auto hold_row = [&](std::uint32_t row) {
    return for_each_word(&bits_[std::size_t{row} * words_], from, to,
                         [](Word word, Word mask) { return (word & mask) == mask; });
  };
  // Those at the ends are the least likely ones.
  if (!hold_row(last)) {
    return false;
  }
  for (std::uint32_t row = first; row < last; ++row) {
    if (!hold_row(row)) {
      return false;
    }
  }
  return true;
}

double CoveredCells::end_in_grid(const RelativeLine& line, double t) const {
  const Point at = line.at(t);
  if (!(at.x >= box_.x0 && at.y >= box_.y0 && at.x <= box_.x1 && at.y <= box_.y1)) {
    return t;
  }
  const double along_x = ((line.dx > 0 ? box_.x1 : box_.x0) - at.x) / line.dx;
  const double along_y = ((line.dy > 0 ? box_.y1 : box_.y0) - at.y) / line.dy;
  // One of them may be not a number.
  double end = 1;
  end = t + along_x < end ? t + along_x : end;
  end = t + along_y < end ? t + along_y : end;
  return end;
}

double CoveredCells::reach(const RelativeLine& line, double t) const {
  if (bits_.empty()) {
    return t;
  }
  const double until = end_in_grid(line, t);
  if (!(until > t)) {
    return t;
  }
  const Point at = line.at(t);
  Point from{(at.x - origin_.x) * cells_a_unit_.x, (at.y - origin_.y) * cells_a_unit_.y};
  Point way{line.dx * cells_a_unit_.x, line.dy * cells_a_unit_.y};
  // Goes from column to column; from row to row where the line meets more of these.
  const bool swap = std::abs(way.y) > std::abs(way.x);
  if (swap) {
    std::swap(from.x, from.y);
    std::swap(way.x, way.y);
  }
  const double slope = way.y / way.x;
  const double inverse = 1 / way.x;
  const std::uint32_t last = cell(from.x + (until - t) * way.x);
  double y = from.y;
  double end = t;
  for (std::uint32_t column = cell(from.x);;) {
    const bool is_last = column == last;
    const double along = is_last ? (until - t) * way.x : column + (way.x > 0 ? 1 : 0) - from.x;
    const double next_y = from.y + along * slope;
    const std::uint32_t to = cell(std::max(y, next_y));
    for (std::uint32_t row = cell(std::min(y, next_y)); row <= to; ++row) {
      if (!(swap ? is_set(row, column) : is_set(column, row))) {
        return end;
      }
    }
    if (is_last) {
      return until;
    }
    y = next_y;
    end = std::min(std::max(end, t + along * inverse), until);
    column = way.x > 0 ? column + 1 : column - 1;
  }
}

}  // namespace gcv
