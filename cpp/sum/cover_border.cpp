// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Segments on the border of a window.
#include "cover.hpp"

namespace gcv {

std::vector<WindowBorder::Part> EdgeCover::segments_along_border(const PlacesOnLine& places,
                                                                 const WindowBorder::Part& part) {
  const PairEdge& s = places.line().edge;
  const RelativeLine line{operands_.relative_start(s), places.line().at.dx, places.line().at.dy};
  std::vector<WindowBorder::Part> segments;
  search_.begin(line);
  seen_ = border_->first;
  std::optional<Place> segment;  // where one has begun
  for (std::optional<Place> place = part.from; place;) {
    const Surroundings surroundings = look(places, line, *place);
    const Containment containment = contained_at(places, line, *place);
    const bool is_end = places.compare(*place, part.to) >= 0;
    const bool leads_on = !is_end && !surroundings.is_covered && !containment.of_place &&
                          !surroundings.blocked.holds(s.rank);
    const bool is_segment = leads_on && surroundings.blocked.hold_right_of(s.rank);
    if (segment && !is_segment) {
      segments.push_back(border_->clipped(operands_, places, {*segment, *place}));
      segment.reset();
    }
    if (is_end) {
      break;
    }
    if (is_segment && !segment) {
      segment = place;
    }
    place = leads_on ? next_change(places, line, *place, !is_segment)
                     : leave_cover(places, line, *place, containment);
  }
  seen_ = operands_.a.size();
  return segments;
}

}  // namespace gcv
