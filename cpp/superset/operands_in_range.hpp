// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Operands that searches are quick with. Where extents are so large or so small that squares of
// them leave the range of doubles, nothing is certain in doubles. Names of edges and vertices do
// not depend on the scale: so searches for these take scaled polygons.
#pragma once

#include <optional>

#include "contributing_vertices.hpp"

namespace gcv {

class OperandsInRange {
 public:
  // The operands must live longer. O(1) where they are in range or cannot be scaled exactly, else
  // O(n + m).
  explicit OperandsInRange(const Operands& operands);
  OperandsInRange(const OperandsInRange&) = delete;
  OperandsInRange& operator=(const OperandsInRange&) = delete;

  // These, or those of the scaled polygons.
  [[nodiscard]] const Operands& operands() const { return scaled_ ? scaled_->operands : given_; }
  [[nodiscard]] bool are_scaled() const { return scale_ != 1; }
  // What coordinates are multiplied by, a power of two.
  [[nodiscard]] double scale() const { return scale_; }
  // A point of the sum among them. Nothing where that loses bits.
  [[nodiscard]] std::optional<Point> scaled(const Point& p) const;

 private:
  struct Scaled {
    Boundary a;
    Boundary b;
    Operands operands;

    Scaled(const Operands& given, double scale);
  };

  const Operands& given_;
  double scale_ = 1;
  std::optional<Scaled> scaled_;
};

}  // namespace gcv
