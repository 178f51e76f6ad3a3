// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solid_cells.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "bit_rows.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// Each bit becomes the parity of those up to it.
Word parities(Word word) {
  for (std::uint32_t shift = 1; shift < word_size; shift *= 2) {
    word ^= word << shift;
  }
  return word;
}

class Rasteriser {
 public:
  Rasteriser(const Boundary& solid, const Box& box, const Point& size, double margin)
      : solid_(solid),
        corner_{box.x0, box.y0},
        size_(size),
        cells_a_unit_{1 / size.x, 1 / size.y},
        margin_(margin),
        columns_(count(box.x1 - box.x0, size.x)),
        rows_(count(box.y1 - box.y0, size.y)),
        words_((columns_ + word_size - 1) / word_size),
        touched_(std::size_t{rows_} * words_),
        crossed_(std::size_t{rows_} * words_) {
    Pace pace;
    for (Index i = 0; i < solid_.size(); ++i) {
      pace.step(4);
      add_edge(at(i), at(solid_.next(i)));
    }
  }

  [[nodiscard]] std::vector<CellRun> runs() const {
    std::vector<CellRun> result;
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
    // What is left of the box tells what is inside.
    if (left > (columns_ + 1) * size_.x || low.y > (rows_ + 1) * size_.y || high.y < -size_.y) {
      return;
    }
    const auto x_at = [&](double y) {
      return y <= low.y    ? low.x
             : y >= high.y ? high.x
                           : std::min(std::max(low.x + (y - low.y) * slope, left), right);
    };
    const bool is_slanted = left < right && low.y < high.y;
    std::uint32_t first_column = column(left - margin_);
    std::uint32_t last_column = column(right + margin_);
    const std::uint32_t last = row(high.y + margin_);
    for (std::uint32_t k = row(low.y - margin_); k <= last; ++k) {
      Word* const touched = &touched_[std::size_t{k} * words_];
      const double y = k * size_.y;
      if (is_slanted) {
        const double from = x_at(y - margin_);
        const double to = x_at(y + size_.y + margin_);
        first_column = column(std::min(from, to) - margin_);
        last_column = column(std::max(from, to) + margin_);
      }
      set(touched, first_column, last_column + 1);
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

}  // namespace

std::vector<CellRun> cells_inside(const Boundary& solid, const Box& box, const Point& size,
                                  double margin) {
  return Rasteriser(solid, box, size, margin).runs();
}

}  // namespace gcv
