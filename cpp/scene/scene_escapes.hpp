// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How a polygon gets out of its overlaps with a scene.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "free_positions.hpp"
#include "penetration.hpp"

namespace gcv {

// A way out of all overlaps, and the solid that the polygon touches there: 0 if it overlapped none.
struct SceneEscape {
  Id id;
  Escape escape;  // the depth is infinite where nothing is free
};

// Finds ways out, one after the other. Solids that were joined for one position serve others with
// the same solids near.
class SceneEscapeSearch {
 public:
  // The positions must live longer. `places`: from how many ways out are sought, about.
  SceneEscapeSearch(const FreePositions& positions, std::size_t places, Tally& tally);
  SceneEscapeSearch(SceneEscapeSearch&& other) noexcept;
  ~SceneEscapeSearch();

  // The shortest way out, of several the lexicographically smallest. Throws Error: cancelled,
  // internal.
  SceneEscape find(const Point& position, Task& task);

 private:
  struct Neighbourhood;

  // For the solids near a box, and perhaps more. Of the search with that number for a position, at
  // most `distance` away.
  Neighbourhood& neighbourhood(std::size_t number, const Box& near, const Point& position,
                               double distance);

  const FreePositions& positions_;
  Tally& tally_;
  std::uint64_t places_;                                        // that are still to come
  std::vector<std::unique_ptr<Neighbourhood>> neighbourhoods_;  // by the number of the search
};

}  // namespace gcv
