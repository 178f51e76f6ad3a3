// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cover.hpp"

#include <algorithm>
#include <cmath>

#include "box.hpp"
#include "error.hpp"

namespace gcv {

namespace {

// Where a place lies in the parallelogram of a pair of edges. Parallel ones have none but a border.
enum class Enclosure : std::uint8_t { outside, border, inside };

Enclosure enclosure_in(const Operands& operands, const WitnessSearch::Pair& pair,
                       const PlacesOnLine& places, const Place& place) {
  const std::optional<Parallelogram> sides = Parallelogram::of(operands, pair.i, pair.j);
  if (!sides) {
    return Enclosure::border;
  }
  Enclosure enclosure = Enclosure::inside;
  for (const Parallelogram::Side& side : *sides) {
    const int here = places.side_of(side.line, place);
    if (here == -side.sign) {
      return Enclosure::outside;
    }
    if (here == 0) {
      enclosure = Enclosure::border;
    }
  }
  return enclosure;
}

}  // namespace

double EdgeCover::parameter_of(const RelativeLine& line, const Place& place) const {
  double t = 0;
  if (place.is_sum) {
    const Point x = operands_.relative(place.sum.i, place.sum.j);
    t = std::abs(line.dx) >= std::abs(line.dy) ? (x.x - line.origin.x) / line.dx
                                               : (x.y - line.origin.y) / line.dy;
  } else {
    t = place.parameter.lo + (place.parameter.hi - place.parameter.lo) / 2;
  }
  return t > 0 ? std::min(t, 1.0) : 0;  // 0 if it is not a number
}

Interval EdgeCover::parameters_of(const RelativeLine& line, const Place& place) const {
  if (!place.is_sum) {
    return {std::max(place.parameter.lo, 0.0), std::min(place.parameter.hi, 1.0)};
  }
  const double t = parameter_of(line, place);
  const double error = 2 * search_.slack() / std::max(std::abs(line.dx), std::abs(line.dy));
  return {t - error, t + error};
}

Containment EdgeCover::contained_at(const PlacesOnLine& places, const RelativeLine& line,
                                    const Place& place) const {
  if (operands_.a.solids.empty()) {
    return {false, false, false, std::nullopt};
  }
  const Interval parameters = parameters_of(line, place);
  const Box around =
      widened(box_of(line.at(parameters.lo), line.at(parameters.hi)), search_.slack());
  return containment_at(operands_, places, place, around, seen_, tally_);
}

std::optional<Place> EdgeCover::skip(const PlacesOnLine& places, const RelativeLine& line,
                                     double from, const Place& start) {
  if (seen_ < operands_.a.size()) {
    return start;  // for witnesses of all are searched
  }
  const double t = search_.reach(from);
  if (t == 1) {
    return std::nullopt;
  }
  if (t == from) {
    return start;
  }
  std::optional<Place> furthest;
  search_.approach(t, t);
  search_.prefer_last_witness();
  while (const std::optional<WitnessSearch::Pair> pair =
             furthest ? search_.next_found_pair() : search_.next_pair()) {
    const std::optional<Parallelogram> sides = Parallelogram::of(operands_, pair->i, pair->j);
    if (!sides) {
      continue;
    }
    const bool holds =
        std::all_of(sides->begin(), sides->end(), [&](const Parallelogram::Side& side) {
          const int turn = places.turn_from(side.line);
          if (turn == 0) {
            return places.side_of(side.line, places.start()) == side.sign;
          }
          const Interval parameter = crossing_parameter(places.line().at, side.line.at);
          return turn == side.sign ? parameter.hi < t : parameter.lo > t;
        });
    if (holds) {
      const Place exit = sides->exit(places);
      if (!furthest || exit.parameter.lo > furthest->parameter.lo) {
        furthest = exit;
      }
    }
  }
  if (!furthest || places.compare(*furthest, start) <= 0) {
    const bool with_sums = search_.uses_sums();
    search_.begin(line, !with_sums);  // for the start lies further back
    return with_sums ? skip(places, line, from, start) : start;
  }
  return places.compare(*furthest, places.end()) > 0 ? std::nullopt : furthest;
}

std::optional<Place> EdgeCover::skip_between(const PlacesOnLine& places, const RelativeLine& line,
                                             const Place& from, const Place& to) {
  if (places.compare(to, places.end()) > 0) {
    return std::nullopt;
  }
  const double first = parameter_of(line, from);
  const double last = parameter_of(line, to);
  const double middle = first + (last - first) / 2;
  const bool is_certain =
      (from.is_sum || from.parameter.hi < middle) && !to.is_sum && to.parameter.lo > middle;
  return is_certain && first < middle ? skip(places, line, middle, to) : to;
}

// It goes on along an edge f, with the open sum on its left: there lie the parallelograms of its
// edge and both edges at its vertex. One of them holds what follows on s, as a rule.
std::optional<Place> EdgeCover::leave_ring(const PlacesOnLine& places, const RelativeLine& line,
                                           const Place& place) {
  if (places.compare(place, places.end()) >= 0) {
    return std::nullopt;
  }
  if (place.is_sum) {
    return place;
  }
  const EdgeName& f = place.crossing;
  const bool is_translated = f.kind == PairEdge::translated;
  const WitnessSearch::Pair before = is_translated
                                         ? WitnessSearch::Pair{f.i, operands_.b.previous(f.j)}
                                         : WitnessSearch::Pair{operands_.a.previous(f.i), f.j};
  for (const WitnessSearch::Pair& pair : {WitnessSearch::Pair{f.i, f.j}, before}) {
    const std::optional<Parallelogram> sides = Parallelogram::of(operands_, pair.i, pair.j);
    const auto holds = [&](const Parallelogram::Side& side) {
      const EdgeName& edge = side.line.edge;
      const int here = edge == f ? 0 : places.side_of(side.line, place);
      return (here != 0 ? here : places.turn_from(side.line)) == side.sign;
    };
    if (sides && std::all_of(sides->begin(), sides->end(), holds)) {
      return skip_between(places, line, place, sides->exit(places));
    }
  }
  return place;
}

const EdgeCover::Run* EdgeCover::find_run(const PlacesOnLine& places, const RelativeLine& line,
                                          const Place& place) const {
  if (runs_.empty()) {
    return nullptr;
  }
  const Interval here = parameters_of(line, place);
  const auto run = std::find_if(runs_.begin(), runs_.end(), [&](const Run& r) {
    return order_of(r.parameters, here) == 0 && places.compare(r.from, place) <= 0 &&
           places.compare(place, r.to) < 0;
  });
  return run == runs_.end() ? nullptr : &*run;
}

bool EdgeCover::is_at(const PlacesOnLine& places, const Place& place, const VertexSum& sum) const {
  if (place.is_sum && place.sum == sum) {
    return true;
  }
  return side(places.line().at, operands_.point(sum), tally_) == 0 &&
         places.compare(place, Place::of(sum)) == 0;
}

bool EdgeCover::is_sum_of_touches(const PlacesOnLine& places, const Place& place,
                                  const WitnessSearch::Pair& pair) const {
  for (const Index i : touches_a_.on(pair.i)) {
    for (const Index j : touches_b_.on(pair.j)) {
      if (is_at(places, place, {i, j})) {
        return true;
      }
    }
  }
  return false;
}

std::optional<WitnessSearch::Pair> EdgeCover::next_pair(bool longest_first) {
  while (const std::optional<WitnessSearch::Pair> pair = search_.next_pair(longest_first)) {
    if (pair->i < seen_) {
      met_pairs_.push_back(*pair);
      return pair;
    }
  }
  return std::nullopt;
}

EdgeCover::Surroundings EdgeCover::look(const PlacesOnLine& places, const RelativeLine& line,
                                        const Place& place) {
  approach(line, place);
  if (seen_ < operands_.a.size()) {
    return look_anew(places, place).surroundings;
  }
  for (const Looked& looked : looked_) {
    if (is_at(places, place, *looked.sum)) {
      return looked.surroundings;
    }
  }
  const std::uint64_t before = search_.visits();
  Looked looked = look_anew(places, place);
  if (!looked.sum || search_.visits() - before <= many_visits) {
    return std::move(looked.surroundings);
  }
  looked.surroundings.blocked.leave_few();
  looked.surroundings.blocked_inside.leave_few();
  if (looked_.size() == most_looked) {
    looked_.pop_front();
  }
  looked_.push_back(std::move(looked));
  return looked_.back().surroundings;
}

EdgeCover::Looked EdgeCover::look_anew(const PlacesOnLine& places, const Place& place) {
  Looked looked{
      place.is_sum ? std::optional(place.sum) : std::nullopt,
      {false, BlockedDirections(operands_.directions), BlockedDirections(operands_.directions)}};
  Surroundings& result = looked.surroundings;
  bool is_inside = false;  // is the pair no border's?
  const auto contact = [&](const ConesOfPoint& cones_a, const ConesOfPoint& cones_b) {
    result.is_covered = cones_.overlap(cones_a, cones_b);
    if (!result.is_covered) {
      cones_a.for_each([&](const DirectionArc& a) {
        cones_b.for_each([&](const DirectionArc& b) {
          const DirectionArc sum = cones_.sum(a, b);
          result.blocked.add(sum);
          if (is_inside) {
            result.blocked_inside.add(sum);
          }
        });
      });
    }
  };
  // Is the place strictly between the ends of the edge?
  const auto lies_on = [&](const PairEdge& edge) {
    const Line other = Line::of(operands_, edge);
    if (places.side_of(other, place) != 0) {
      return false;
    }
    const Place from = Place::of(start_of(edge));
    const Place to = Place::of(end_of(operands_, edge));
    if (places.turn_from(other) == 0) {
      return places.compare(from, place) * places.compare(place, to) > 0;
    }
    const Line& s = places.line();
    return side(s.at, operands_.start(edge), tally_) * side(s.at, operands_.end(edge), tally_) < 0;
  };
  const auto is_among = [&](const std::vector<Index>& touching, auto sum) {
    return std::any_of(touching.begin(), touching.end(),
                       [&](Index vertex) { return is_at(places, place, sum(vertex)); });
  };
  while (const std::optional<WitnessSearch::Pair> pair = next_pair()) {
    const Index i = pair->i;
    const Index j = pair->j;
    is_inside = border_ != nullptr && i < border_->first;
    if (is_at(places, place, {i, j})) {
      looked.sum = VertexSum{i, j};
      contact(cones_.vertex_of_a(i), cones_.vertex_of_b(j));
    } else if (const Enclosure enclosure = enclosure_in(operands_, *pair, places, place);
               enclosure == Enclosure::inside) {
      result.is_covered = !is_sum_of_touches(places, place, *pair);
    } else if (enclosure == Enclosure::border && lies_on(operands_.translated(i, j))) {
      // Where another ring touches the edge, the vertex of that tells.
      if (!is_among(touches_a_.on(i), [&](Index k) { return VertexSum{k, j}; })) {
        contact(cones_.edge_of_a(i), cones_.vertex_of_b(j));
      }
    } else if (enclosure == Enclosure::border && lies_on(operands_.corner(i, j))) {
      if (!is_among(touches_b_.on(j), [&](Index k) { return VertexSum{i, k}; })) {
        contact(cones_.vertex_of_a(i), cones_.edge_of_b(j));
      }
    }
    if (result.is_covered) {
      break;
    }
  }
  return looked;
}

}  // namespace gcv
