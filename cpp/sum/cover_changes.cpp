// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How far what follows a place on a superset edge is covered, or free.
#include <algorithm>
#include <optional>
#include <vector>

#include "cover.hpp"
#include "error.hpp"

namespace gcv {

namespace {

// Of an edge, the part that is searched first for where what is free ends.
constexpr double least_part_ahead = 0x1p-9;
// Where many pairs meet, those next to the edge come after so many others: in the one place of an
// exact fit, only these show that what follows is covered.
constexpr std::size_t patience = 16;

}  // namespace

template <class Visit>
void EdgeCover::for_each_slide(const PlacesOnLine& places, const WitnessSearch::Pair& pair,
                               Visit visit) {
  const Place start = places.start();
  const auto slide = [&](const PairEdge& edge, const std::vector<Index>& touching,
                         auto cones_overlap) {
    const Line line = Line::of(operands_, edge);
    if (places.turn_from(line) != 0 || !cones_overlap() || places.side_of(line, start) != 0) {
      return;
    }
    const auto visit_part = [&](const VertexSum& from, const VertexSum& to) {
      visit(edge.rank == places.line().edge.rank ? Slide{from, to} : Slide{to, from});
    };
    VertexSum from = start_of(edge);
    for (const Index vertex : touching) {
      const VertexSum to =
          edge.kind == PairEdge::translated ? VertexSum{vertex, edge.j} : VertexSum{edge.i, vertex};
      visit_part(from, to);
      from = to;
    }
    visit_part(from, end_of(operands_, edge));
  };
  const Index i = pair.i;
  const Index j = pair.j;
  slide(operands_.translated(i, j), touches_a_.on(i),
        [&] { return cones_.overlap(cones_.edge_of_a(i), cones_.vertex_of_b(j)); });
  slide(operands_.corner(i, j), touches_b_.on(j),
        [&] { return cones_.overlap(cones_.vertex_of_a(i), cones_.edge_of_b(j)); });
}

std::optional<Place> EdgeCover::exit_of_cover(const PlacesOnLine& places, const Place& place,
                                              const Containment& containment) {
  std::optional<Place> furthest;
  const auto take = [&](const Place& exit) {
    if (!furthest || places.compare(exit, *furthest) > 0) {
      furthest = exit;
    }
  };
  const auto take_exit_of = [&](const WitnessSearch::Pair& pair) {
    if (const std::optional<Parallelogram> sides = Parallelogram::of(operands_, pair.i, pair.j)) {
      const bool holds =
          std::all_of(sides->begin(), sides->end(), [&](const Parallelogram::Side& side) {
            const int here = places.side_of(side.line, place);
            return (here != 0 ? here : places.turn_from(side.line)) == side.sign;
          });
      if (holds) {
        take(sides->exit(places));
      }
    }
    for_each_slide(places, pair, [&](const Slide& slide) {
      if (places.compare(Place::of(slide.from), place) <= 0 &&
          places.compare(place, Place::of(slide.to)) < 0) {
        take(Place::of(slide.to));
      }
    });
  };
  // The last one has covered the place, as a rule.
  for (std::size_t k = met_pairs_.size(); k-- > 0;) {
    if (furthest && met_pairs_.size() - k > patience) {
      break;
    }
    take_exit_of(met_pairs_[k]);
  }
  if (containment.of_line) {
    take(containment.end ? *containment.end : places.end());
  }
  const auto take_exits_next_to_edge = [&] {
    const EdgeName& s = places.line().edge;
    for (const Index i : {operands_.a.previous(s.i), s.i, operands_.a.next(s.i)}) {
      for (const Index j : {operands_.b.previous(s.j), s.j, operands_.b.next(s.j)}) {
        if (i < seen_) {
          take_exit_of({i, j});
        }
      }
    }
  };
  for (std::size_t met = 0; !furthest; ++met) {
    if (met == patience) {
      take_exits_next_to_edge();
    } else if (const std::optional<WitnessSearch::Pair> pair = next_pair(true)) {
      take_exit_of(*pair);
    } else {
      break;
    }
  }
  return furthest;
}

std::optional<Place> EdgeCover::leave_cover(const PlacesOnLine& places, const RelativeLine& line,
                                            const Place& place,
                                            const std::optional<Containment>& containment) {
  std::optional<Place> furthest = exit_of_cover(places, place, containment.value_or(Containment{}));
  if (!furthest && !containment) {
    furthest = exit_of_cover(places, place, contained_at(places, line, place));
  }
  if (!furthest) {
    throw Error(Status::internal, "no witness covers what follows a covered place");
  }
  return skip_between(places, line, place, *furthest);
}

Place EdgeCover::next_change(const PlacesOnLine& places, const RelativeLine& line,
                             const Place& place, bool right_is_free) {
  Place first = places.end();
  const auto come = [&](const Place& change) {
    if (places.compare(change, first) < 0) {
      first = change;
    }
  };
  std::optional<Place> germ_exit;
  const auto meet = [&](const WitnessSearch::Pair& pair) {
    for_each_slide(places, pair, [&](const Slide& slide) {
      if (places.compare(Place::of(slide.from), place) > 0) {
        come(Place::of(slide.from));
      }
    });
    const std::optional<Parallelogram> sides = Parallelogram::of(operands_, pair.i, pair.j);
    if (!sides) {
      return;
    }
    bool holds_germ = true;
    bool is_right = true;  // does it hold the germ between its entry and its exit?
    bool holds_places = true;
    std::optional<Place> entry;
    for (const Parallelogram::Side& side : *sides) {
      const int turn = places.turn_from(side.line);
      const int here = places.side_of(side.line, place);
      if (turn == 0) {
        const bool is_same_way = side.line.edge.rank == places.line().edge.rank;
        holds_places = holds_places && here == side.sign;
        is_right = is_right && (here != 0 ? here : is_same_way ? -1 : 1) == side.sign;
        holds_germ = holds_germ && is_right;
      } else {
        holds_germ = holds_germ && (here != 0 ? here : turn) == side.sign;
        if (turn == side.sign) {
          const Place crossing = places.crossing(side.line);
          if (!entry || places.compare(crossing, *entry) > 0) {
            entry = crossing;
          }
        }
      }
    }
    const Place exit = sides->exit(places);
    if (holds_germ && (!germ_exit || places.compare(exit, *germ_exit) > 0)) {
      germ_exit = exit;
    }
    if (!entry || places.compare(*entry, exit) >= 0) {
      return;
    }
    const int order = places.compare(*entry, place);
    if ((holds_places && order >= 0) || (right_is_free && is_right && order > 0)) {
      come(*entry);
    }
  };
  // What begins further ahead than the first change does not matter.
  const double from = parameters_of(line, place).lo;
  double ahead = least_part_ahead;
  double to = (from > 0 ? from : 0) + ahead;  // `from` is not finite where nothing is certain
  search_.approach(from, to);
  while (true) {
    while (const std::optional<WitnessSearch::Pair> pair = next_pair()) {
      meet(*pair);
    }
    if (germ_exit) {
      come(*germ_exit);  // the last one: what holds the germ is near
    }
    const double furthest = parameters_of(line, first).hi;
    if (to > 1 || furthest < to) {
      return first;
    }
    ahead *= 8;
    to += ahead;
    search_.approach_further(std::min(to, furthest));
  }
}

}  // namespace gcv
