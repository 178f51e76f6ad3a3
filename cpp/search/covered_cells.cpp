// SPDX-License-Identifier: LGPL-3.0-or-later
#include "covered_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace gcv {

namespace {

using Word = std::uint64_t;
constexpr std::uint32_t word_size = 64;

// Calls visit(word, mask) for the words of a row with the bits from one to before another, until it
// returns false.
template <class Bits, class Visit>
bool for_each_word(Bits* row, std::uint32_t from, std::uint32_t to, Visit visit) {
  const std::uint32_t first = from / word_size;
  const std::uint32_t last = (to - 1) / word_size;
  for (std::uint32_t k = first; k <= last; ++k) {
    Word mask = ~Word{0};
    if (k == first) {
      mask <<= from % word_size;
    }
    if (k == last) {
      mask &= ~Word{0} >> (word_size - 1 - (to - 1) % word_size);
    }
    if (!visit(row[k], mask)) {
      return false;
    }
  }
  return true;
}

void set(Word* row, std::uint32_t from, std::uint32_t to) {
  for_each_word(row, from, to, [](Word& word, Word mask) {
    word |= mask;
    return true;
  });
}

// Each bit becomes the parity of those up to it.
Word parities(Word word) {
  for (std::uint32_t shift = 1; shift < word_size; shift *= 2) {
    word ^= word << shift;
  }
  return word;
}

// Cells in a row that lie inside a solid: from one to before another.
struct Run {
  std::uint32_t row;
  std::uint32_t from;
  std::uint32_t to;
};

// The cells of a grid that lie inside a solid, also if they are larger by the margin on each side.
// The first cell begins in the corner of the bounds.
class SolidCells {
 public:
  SolidCells(const Boundary& solid, const Point& size, double margin)
      : solid_(solid),
        corner_{solid.bounds.x0 - solid.vertices.front().x,
                solid.bounds.y0 - solid.vertices.front().y},
        size_(size),
        cells_a_unit_{1 / size.x, 1 / size.y},
        margin_(margin),
        columns_(count(solid.bounds.x1 - solid.bounds.x0, size.x)),
        rows_(count(solid.bounds.y1 - solid.bounds.y0, size.y)),
        words_((columns_ + word_size - 1) / word_size),
        touched_(std::size_t{rows_} * words_),
        crossed_(std::size_t{rows_} * words_) {
    for (Index i = 0; i < solid_.size(); ++i) {
      add_edge(at(i), at(solid_.next(i)));
    }
  }

  [[nodiscard]] std::vector<Run> runs() const {
    std::vector<Run> result;
    const Word outside = solid_.kind == Boundary::Kind::outer ? 0 : ~Word{0};
    for (std::uint32_t row = 0; row < rows_; ++row) {
      Word before = outside;
      Word last = 0;  // is the cell before the word inside?
      std::uint32_t from = 0;
      for (std::uint32_t k = 0; k < words_; ++k) {
        const std::size_t at = std::size_t{row} * words_ + k;
        const Word parity = parities(crossed_[at]) ^ before;
        before = (parity >> (word_size - 1)) != 0 ? ~Word{0} : 0;
        const Word inside = parity & ~touched_[at] & columns_of_word(k);
        for (Word changes = inside ^ (inside << 1U | last); changes != 0; changes &= changes - 1) {
          const auto bit = static_cast<std::uint32_t>(std::countr_zero(changes));
          const std::uint32_t column = k * word_size + bit;
          if ((inside >> bit & 1U) != 0) {
            from = column;
          } else {
            result.push_back({row, from, column});
          }
        }
        last = inside >> (word_size - 1);
      }
      if (last != 0) {
        result.push_back({row, from, columns_});
      }
    }
    return result;
  }

 private:
  static std::uint32_t count(double extent, double size) {
    return static_cast<std::uint32_t>(extent / size) + 1;
  }

  // The bits of the columns that there are.
  [[nodiscard]] Word columns_of_word(std::uint32_t k) const {
    const std::uint32_t columns = columns_ - k * word_size;
    return columns < word_size ? ~(~Word{0} << columns) : ~Word{0};
  }

  [[nodiscard]] Point at(Index i) const {
    const Point p = solid_.relative(i);
    return {p.x - corner_.x, p.y - corner_.y};
  }
  static std::uint32_t clamped(double place, std::uint32_t count) {
    return place > 0 ? static_cast<std::uint32_t>(std::min(place, count - 1.0)) : 0;
  }
  [[nodiscard]] std::uint32_t column(double x) const {
    return clamped(x * cells_a_unit_.x, columns_);
  }
  [[nodiscard]] std::uint32_t row(double y) const { return clamped(y * cells_a_unit_.y, rows_); }

  void add_edge(const Point& p, const Point& q) {
    const Point& low = p.y <= q.y ? p : q;
    const Point& high = p.y <= q.y ? q : p;
    const double slope = low.y == high.y ? 0 : (high.x - low.x) / (high.y - low.y);
    const double left = std::min(p.x, q.x);
    const double right = std::max(p.x, q.x);
    const auto x_at = [&](double y) {
      return y <= low.y    ? low.x
             : y >= high.y ? high.x
                           : std::min(std::max(low.x + (y - low.y) * slope, left), right);
    };
    const std::uint32_t last = row(high.y + margin_);
    for (std::uint32_t k = row(low.y - margin_); k <= last; ++k) {
      Word* const touched = &touched_[std::size_t{k} * words_];
      const double y = k * size_.y;
      double from = left;
      double to = right;
      if (low.y != high.y) {
        from = x_at(y - margin_);
        to = x_at(y + size_.y + margin_);
      }
      set(touched, column(std::min(from, to) - margin_), column(std::max(from, to) + margin_) + 1);
      const double middle = y + size_.y / 2;
      if (low.y <= middle && middle < high.y) {
        const std::uint32_t c = column(x_at(middle));
        crossed_[std::size_t{k} * words_ + c / word_size] ^= Word{1} << (c % word_size);
      }
    }
  }

  const Boundary& solid_;
  Point corner_;
  Point size_;
  Point cells_a_unit_;
  double margin_;
  std::uint32_t columns_;
  std::uint32_t rows_;
  std::uint32_t words_;
  std::vector<Word> touched_;  // cells that the boundary comes near
  std::vector<Word> crossed_;  // where it crosses the middle of a row, an odd number of times
};

// With fewer pairs of vertices, a grid takes longer than what it saves.
constexpr std::uint64_t fewest_pairs = 150;

// Finer grids leave fewer edges to search for, and take longer: with the third power of the side
// where solids are cut into many runs. bench/regions is quickest about here, from stars of 40
// vertices to coasts of 10^4.
std::uint32_t side_of_grid(std::uint64_t pairs) {
  return static_cast<std::uint32_t>(
      std::min(12 * std::sqrt(std::sqrt(static_cast<double>(pairs))), 2048.0));
}

// Where solids are cut into more runs than that allows, the grid is made coarser: grilles. Shapes
// without many bars take 40 to 160.
constexpr std::uint64_t sums_a_vertex = 500;

}  // namespace

// The corners of cells, the number of the cell of a point, and where a line enters a cell, are
// computed with errors that are worth less than the margin.
CoveredCells::CoveredCells(const Operands& operands, double slack) : margin_(slack) {
  const std::uint64_t pairs = std::uint64_t{operands.a.size()} * operands.b.size();
  const std::uint64_t most_sums =
      sums_a_vertex * (std::uint64_t{operands.a.size()} + operands.b.size());
  if (pairs < fewest_pairs) {
    return;
  }
  const Box bounds = operands.relative_bounds();
  origin_ = {bounds.x0, bounds.y0};
  std::vector<Run> of_a;
  std::vector<Run> of_b;
  side_ = 2 * side_of_grid(pairs);
  do {
    side_ /= 2;
    size_ = {(bounds.x1 - bounds.x0) / side_, (bounds.y1 - bounds.y0) / side_};
    if (!(64 * margin_ < size_.x && 64 * margin_ < size_.y)) {
      return;
    }
    of_a = SolidCells(operands.a, size_, margin_).runs();
    of_b = SolidCells(operands.b, size_, margin_).runs();
  } while (std::uint64_t{of_a.size()} * of_b.size() > most_sums);
  words_ = (side_ + word_size - 1) / word_size;
  last_ = side_ - 1;
  cells_a_unit_ = {1 / size_.x, 1 / size_.y};
  bits_.resize(std::size_t{side_} * words_);
  // The sum of two cells is a square of four: the lower two, then the upper two.
  for (const Run& a : of_a) {
    for (const Run& b : of_b) {
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

bool CoveredCells::hold(const Box& box) const {
  if (bits_.empty()) {
    return false;
  }
  const std::uint32_t from = cell((box.x0 - origin_.x) * cells_a_unit_.x);
  const std::uint32_t to = cell((box.x1 - origin_.x) * cells_a_unit_.x) + 1;
  const std::uint32_t last = cell((box.y1 - origin_.y) * cells_a_unit_.y);
  for (std::uint32_t row = cell((box.y0 - origin_.y) * cells_a_unit_.y); row <= last; ++row) {
    if (!for_each_word(&bits_[std::size_t{row} * words_], from, to,
                       [](Word word, Word mask) { return (word & mask) == mask; })) {
      return false;
    }
  }
  return true;
}

double CoveredCells::reach(const RelativeLine& line, double t) const {
  if (bits_.empty()) {
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
  const std::uint32_t last = cell(from.x + (1 - t) * way.x);
  double y = from.y;
  double end = t;
  for (std::uint32_t column = cell(from.x);;) {
    const bool is_last = column == last;
    const double along = is_last ? (1 - t) * way.x : column + (way.x > 0 ? 1 : 0) - from.x;
    const double next_y = from.y + along * slope;
    const std::uint32_t to = cell(std::max(y, next_y));
    for (std::uint32_t row = cell(std::min(y, next_y)); row <= to; ++row) {
      if (!(swap ? is_set(row, column) : is_set(column, row))) {
        return end;
      }
    }
    if (is_last) {
      return 1;
    }
    y = next_y;
    end = std::min(std::max(end, t + along * inverse), 1.0);
    column = way.x > 0 ? column + 1 : column - 1;
  }
}

}  // namespace gcv
