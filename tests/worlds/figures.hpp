// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Figures of unit squares, and of halves of them: with slots, holes and exact fits.
#pragma once

#include <vector>

#include "catalogue.hpp"
#include "symmetries.hpp"

namespace worlds {

// What there is of each square of a box: nothing, all of it, or one of four halves.
class Figure {
 public:
  static constexpr int kStates = 6;

  Figure(int box, std::vector<int> states) : box_(box), states_(std::move(states)) {}

  // Do its pieces hang together, by edges?
  [[nodiscard]] bool is_connected() const;

  [[nodiscard]] std::vector<Convex> pieces() const { return pieces(states_); }

  // What is not there of the box.
  [[nodiscard]] std::vector<Convex> rest() const;

  // Its rings. It is connected.
  [[nodiscard]] Polygon polygon() const;

 private:
  int box_;
  std::vector<int> states_;

  [[nodiscard]] std::vector<Convex> pieces(const std::vector<int>& states) const;
};

// All connected figures of whole squares that fit into a box, in the corner of it.
struct SquareFigures {
  explicit SquareFigures(int box);

  std::vector<Figure> figures;
  Images images;
};

// A connected figure of squares and halves.
Figure random_figure(Random& random, int box);

}  // namespace worlds
