// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A scene as one operand of a sum.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "box.hpp"
#include "query.hpp"
#include "scene.hpp"
#include "window_border.hpp"

namespace gcv {

struct JoinedSolids {
  // The outside of the container comes first; without one, that of a frame round the window. Then
  // the members, those near each other in a row, then the window.
  std::shared_ptr<const Boundary> boundary;
  std::vector<Id> owners;  // the solid that each ring belongs to; 0 for the frame and the window
  std::optional<WindowBorder> border;

  [[nodiscard]] const WindowBorder* border_or_null() const { return border ? &*border : nullptr; }
};

// The solids that a query admits, of which a polygon can touch one in the container; with a window,
// those that it can touch from a position there. `reflected` is the polygon's reflection. Throws
// Error: invalid_argument without a container and a window; range where the corners of a frame are
// beyond the largest double.
JoinedSolids join_solids(const Scene& scene, const Query& query, const Boundary& reflected,
                         const std::optional<Box>& window);

// The same in the container, without a window. Of scenes that are not too large, they are kept: the
// next question before a change has them.
std::shared_ptr<const JoinedSolids> join_all_solids(const Scene& scene, const Query& query,
                                                    const Boundary& reflected);

// The container, and the members that a query admits that a polygon can touch from a position in a
// box. The query must admit the container.
JoinedSolids join_solids_near(const Scene& scene, const Query& query, const Boundary& reflected,
                              const Box& positions);

using Slots = std::vector<BoxForest::Slot>;

// The members that a query admits whose boxes meet a box, in order.
Slots slots_near(const Scene& scene, const Query& query, const Box& box);

// The container, if the query admits it, and members, in an order that does not depend on theirs.
// There must be one of these. Of large ones, what matters within a box, if one is given.
JoinedSolids join_members(const Scene& scene, const Query& query, const Slots& slots,
                          const std::optional<Box>& reach);

}  // namespace gcv
