// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>

#include "contributing_vertices.hpp"
#include "place.hpp"
#include "places_on_line.hpp"

namespace gcv {

// The sum of an edge of A and an edge of B.
class Parallelogram {
 public:
  // A side, and on which side of its line the inside is: 1 left, -1 right.
  struct Side {
    Line line;
    int sign;
  };

  // Nothing for parallel edges.
  static std::optional<Parallelogram> of(const Operands& operands, Index i, Index j);

  [[nodiscard]] const Side* begin() const { return sides_; }
  [[nodiscard]] const Side* end() const { return sides_ + 4; }

  // The first crossing of s with a side through which it goes out.
  [[nodiscard]] Place exit(const PlacesOnLine& places) const;

 private:
  Side sides_[4];
};

}  // namespace gcv
