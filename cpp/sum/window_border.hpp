// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The border of a window: part of the free set is looked at, that in a rectangle with sides along
// the axes. Solids of A whose sums with B are what lies outside of it make the border.
#pragma once

#include <algorithm>
#include <array>

#include "box.hpp"
#include "places_on_line.hpp"
#include "tree_product.hpp"

namespace gcv {

struct WindowBorder {
  Box window;                     // of points of the sum
  Index first;                    // the vertices of A from this one on are those of the window
  std::array<EdgeName, 4> sides;  // superset edges along them, the window on the right

  // For operands of which no more than the window is looked at.
  [[nodiscard]] Box focus(const Operands& operands) const {
    return widened(operands.relative_box(window), slack_of(operands));
  }

  [[nodiscard]] bool makes(const EdgeName& edge) const { return edge.i >= first; }

  // Does a superset edge that it does not make lie on the line of one of its sides?
  [[nodiscard]] bool holds(const Operands& operands, const PlacesOnLine& places) const {
    return std::any_of(sides.begin(), sides.end(), [&](const EdgeName& side) {
      const Line line = Line::of(operands, operands.named(side));
      return places.turn_from(line) == 0 && places.side_of(line, places.start()) == 0;
    });
  }

  struct Part {
    Place from;
    Place to;
  };
  // What lies in the window, of a part of such an edge. Its end may lie before its start.
  [[nodiscard]] Part clipped(const Operands& operands, const PlacesOnLine& places,
                             const Part& part) const {
    Part result = part;
    for (const EdgeName& side : sides) {
      const Line line = Line::of(operands, operands.named(side));
      const int turn = places.turn_from(line);
      if (turn == 0) {
        continue;
      }
      const Place crossing = places.crossing(line);
      Place& end = turn < 0 ? result.from : result.to;
      if (turn * places.compare(crossing, end) < 0) {
        end = crossing;
      }
    }
    return result;
  }
};

}  // namespace gcv
