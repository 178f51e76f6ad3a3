// SPDX-License-Identifier: LGPL-3.0-or-later
#include "figures.hpp"

#include <algorithm>

#include "parts.hpp"

namespace worlds {
namespace {

bool share_an_edge(const Convex& a, const Convex& b) {
  return std::count_if(a.begin(), a.end(),
                       [&](Point p) { return std::find(b.begin(), b.end(), p) != b.end(); }) > 1;
}

// The squares of a box, as bits, moved to its corner; 0 for none.
unsigned in_corner(int box, const std::vector<Point>& squares) {
  Point low{box, box};
  for (const Point& p : squares) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  }
  unsigned bits = 0;
  for (const Point& p : squares) {
    bits |= 1U << (box * (p.x - low.x) + p.y - low.y);
  }
  return bits;
}

std::vector<Point> squares_of(int box, unsigned bits) {
  std::vector<Point> squares;
  for (int k = 0; k < box * box; ++k) {
    if ((bits >> k & 1) != 0) {
      squares.push_back({k / box, k % box});
    }
  }
  return squares;
}

}  // namespace

std::vector<Convex> Figure::pieces(const std::vector<int>& states) const {
  std::vector<Convex> all;
  for (int k = 0; k < box_ * box_; ++k) {
    const int state = states[static_cast<std::size_t>(k)];
    const Int x = k / box_;
    const Int y = k % box_;
    Convex square{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    if (state > 1) {
      square.erase(square.begin() + state - 2);
    }
    if (state > 0) {
      all.push_back(square);
    }
  }
  return all;
}

std::vector<Convex> Figure::rest() const {
  std::vector<int> others = states_;
  for (int& state : others) {
    state = state < 2 ? 1 - state : 2 + state % 4;
  }
  return pieces(others);
}

bool Figure::is_connected() const {
  std::vector<Convex> left = pieces();
  if (left.empty()) {
    return false;
  }
  std::vector<Convex> reached{left.back()};
  left.pop_back();
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const Convex from = reached[k];
    const auto near = std::partition(
        left.begin(), left.end(), [&](const Convex& piece) { return !share_an_edge(piece, from); });
    reached.insert(reached.end(), near, left.end());
    left.erase(near, left.end());
  }
  return left.empty();
}

Polygon Figure::polygon() const {
  OpenSum sum;
  sum.add(pieces(), {{{0, 0}}});
  const Parts::Face face = parts(sum, Shown::sum).faces.at(0);
  Polygon polygon{face.outer};
  polygon.insert(polygon.end(), face.holes.begin(), face.holes.end());
  for (Ring& ring : polygon) {
    for (Point& p : ring) {
      p = {p.x / kUnit, p.y / kUnit};
    }
  }
  return polygon;
}

SquareFigures::SquareFigures(int box) {
  std::vector<unsigned> all;
  for (unsigned bits = 1; bits >> (box * box) == 0; ++bits) {
    std::vector<int> states;
    for (int k = 0; k < box * box; ++k) {
      states.push_back(static_cast<int>(bits >> k & 1));
    }
    const Figure figure(box, states);
    if (in_corner(box, squares_of(box, bits)) == bits && figure.is_connected()) {
      all.push_back(bits);
      figures.push_back(figure);
    }
  }
  for (int symmetry = 0; symmetry < 8; ++symmetry) {
    for (const unsigned bits : all) {
      std::vector<Point> squares = squares_of(box, bits);
      for (Point& p : squares) {
        p = image(symmetry, p);
      }
      const auto found = std::lower_bound(all.begin(), all.end(), in_corner(box, squares));
      images[static_cast<std::size_t>(symmetry)].push_back(
          static_cast<std::size_t>(found - all.begin()));
    }
  }
}

Figure random_figure(Random& random, int box) {
  std::vector<int> states(static_cast<std::size_t>(box * box), 1);
  // Changes one square after another, where that leaves the figure connected.
  for (int k = 0; k < 4 * box * box; ++k) {
    std::vector<int> changed = states;
    changed[static_cast<std::size_t>(random.below(box * box))] =
        static_cast<int>(random.below(Figure::kStates));
    if (Figure(box, changed).is_connected()) {
      states = changed;
    }
  }
  return {box, states};
}

}  // namespace worlds
