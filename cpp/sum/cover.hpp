// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the open sum O = int A + int B leaves of a superset edge s: the free places of s.
//
// The free set F is the complement of O. Its boundary lies on superset edges: x on it is a contact
// without overlap, which is Definition 1 with closed cones and no reflex vertex. So what is not
// covered of each superset edge tells all of it. Three questions are asked of a place of s:
// - Is the place itself in O? Its contacts say so (contacts.hpp), or an open parallelogram.
// - Is what follows on s, by a first infinitesimal? If not, s runs along F there.
// - Is the germ, to the right of that by a second, infinitely smaller one? If not, a face of F lies
//   on the right, and a ring runs along s. If it is, both sides of s are in O: a segment.
// Sources: docs/METHOD.md.
//
// The walk along s goes from witness to witness in doubles (search/witness.hpp). Where none leads
// on, it goes on exactly: from one crossing with a side of a parallelogram to the next.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "contacts.hpp"
#include "containment.hpp"
#include "contributing_vertices.hpp"
#include "parallelogram.hpp"
#include "places_on_line.hpp"
#include "walked_lines.hpp"
#include "window_border.hpp"
#include "witness_search.hpp"

namespace gcv {

// The solid of B is connected. Those of A may be several. Then one of them may lie inside x - B, or
// that inside one of them, where their boundaries do not meet.
//
// Walks along superset edges. Takes what it finds to a visitor:
//   knows_rings: does it have
//     known_runs(places, runs): adds where rings that are known pass along s;
//   ring(places, from): a ring passes along s from that place on: returns where it leaves s;
//   segment(places, from, to): s runs along F, with O on both sides;
//   point(places, place): an isolated point of F.
class EdgeCover {
 public:
  // A part of s along which a ring passes.
  struct Run {
    Place from;
    Place to;
    Interval parameters{};  // of all its places
  };

  // With the border of a window, fits are those of what is free without it, in the window.
  EdgeCover(const Operands& operands, Tally& tally, const WindowBorder* border = nullptr)
      : operands_(operands),
        border_(border),
        seen_(operands.a.size()),
        touches_a_(operands.a.cover_index().touches),
        touches_b_(operands.b.cover_index().touches),
        cones_(operands, touches_a_, touches_b_),
        tally_(tally),
        search_(operands) {}
  EdgeCover(const EdgeCover&) = delete;
  EdgeCover& operator=(const EdgeCover&) = delete;

  struct Surroundings {
    bool is_covered;  // it lies in the open sum
    BlockedDirections blocked;
    BlockedDirections blocked_inside;  // by contacts that the border of a window does not make
  };

  // Calls the visitor for all that the open sum leaves of a part of s, from its start to its end.
  template <class Visitor>
  void walk(const PairEdge& s, const WalkedLines::Part& asked, Visitor& visitor);

  // The same for all of s.
  template <class Visitor>
  void walk(const PairEdge& s, Visitor& visitor) {
    walk(s, {start_of(s), end_of(operands_, s)}, visitor);
  }

  // The same for all superset edges of the half-plane of directions that begins with that rank.
  // Returns how many there were. Calls pass(pairs), as the search does.
  template <class Visitor, class Pass>
  std::uint64_t walk_half_plane(Rank first, Visitor& visitor, Pass pass) {
    WalkedLines lines(operands_, search_.slack(), tally_);
    std::uint64_t edges = 0;
    search_.for_each_uncovered_edge(
        first,
        [&](const PairEdge& s) {
          ++edges;
          if (border_ != nullptr && border_->makes(s)) {
            walk(s, visitor);
            return;
          }
          for (const WalkedLines::Part& part : lines.left_of(s)) {
            walk(s, part, visitor);
          }
        },
        pass);
    return edges;
  }

  // The same for the sums of points in which rings of A touch with such points of B. These can be
  // isolated points of F that lie on no superset edge. Leaves out those that is_wanted(sum) does
  // not want.
  template <class Visitor, class IsWanted>
  void visit_touches(Visitor& visitor, IsWanted is_wanted) {
    for (const Touch& p : touches_a_.all()) {
      for (const Touch& q : touches_b_.all()) {
        if (!is_wanted(VertexSum{p.vertices.front(), q.vertices.front()})) {
          continue;
        }
        const PairEdge s = operands_.translated(p.vertices.front(), q.vertices.front());
        const PlacesOnLine places(operands_, s, tally_);
        const RelativeLine line{operands_.relative_start(s), places.line().at.dx,
                                places.line().at.dy};
        search_.begin(line);
        const Surroundings surroundings = look(places, line, places.start());
        if (is_point(surroundings) && !contained_at(places, line, places.start()).of_place) {
          visitor.point(places, places.start());
        }
      }
    }
  }

  // Vectors into the middles of the directions in which all is free next to a place of s.
  std::vector<Point> ways_off(const PairEdge& s, const Place& place);

  // What follows the place on the line is free. The next place where this may end; if the right
  // side counts, where that may be no longer free.
  Place end_of_free(const PlacesOnLine& places, const Place& place, bool right_counts) {
    const Line& s = places.line();
    return next_change(places, {operands_.relative_start(s.edge), s.at.dx, s.at.dy}, place,
                       right_counts);
  }

  // What it searches with. A walk begins it anew.
  [[nodiscard]] WitnessSearch& search() { return search_; }

 private:
  // A ring has left s in the place, as a rule into what is covered. Then nothing, or a place beyond
  // that, as skip() has it. Else the place itself.
  std::optional<Place> leave_ring(const PlacesOnLine& places, const RelativeLine& line,
                                  const Place& place);
  // What lies between two places is covered. Nothing, or a place beyond, as skip() has it.
  std::optional<Place> skip_between(const PlacesOnLine& places, const RelativeLine& line,
                                    const Place& from, const Place& to);
  // Does a ring that is known pass through the place, along another superset edge?
  template <class Visitor>
  bool lies_on_known_ring(const PlacesOnLine& places, const Place& place, Visitor& visitor);
  // The run that passes along s from the place on, or nullptr.
  [[nodiscard]] const Run* find_run(const PlacesOnLine& places, const RelativeLine& line,
                                    const Place& place) const;
  // Goes on from t on s, from witness to witness. Nothing if they reach the end of s. Else a place
  // beyond t, up to which s is covered; `start` if there is none.
  std::optional<Place> skip(const PlacesOnLine& places, const RelativeLine& line, double from,
                            const Place& start);
  // Do rings of A touch at a point of edge i, and rings of B at one of edge j, so that their sum is
  // the place? Then the parallelogram of these edges does not tell whether it lies in O.
  [[nodiscard]] bool is_sum_of_touches(const PlacesOnLine& places, const Place& place,
                                       const WitnessSearch::Pair& pair) const;
  [[nodiscard]] bool is_at(const PlacesOnLine& places, const Place& place,
                           const VertexSum& sum) const;
  // Is the place an isolated point of F? With a border, also a point of a segment there.
  [[nodiscard]] bool is_point(const Surroundings& surroundings) const {
    return !surroundings.is_covered && surroundings.blocked.hold_all() &&
           (border_ == nullptr || surroundings.blocked_inside.hold_almost_all());
  }
  // Of an edge that lies on the border of a window: the segments that are there without it.
  template <class Visitor>
  void visit_segments_along_border(const PlacesOnLine& places, const WindowBorder::Part& part,
                                   Visitor& visitor) {
    for (const auto& [from, to] : segments_along_border(places, part)) {
      if (const int order = places.compare(from, to); order < 0) {
        visitor.segment(places, from, to);
      } else if (order == 0) {
        visitor.point(places, from);
      }
    }
  }
  // In a part of s, those that are segments of F where the border is not seen, clipped to the
  // window.
  std::vector<WindowBorder::Part> segments_along_border(const PlacesOnLine& places,
                                                        const WindowBorder::Part& part);
  // Begins to meet the pairs of edges near a place.
  void approach(const RelativeLine& line, const Place& place) {
    const Interval parameters = parameters_of(line, place);
    search_.approach(parameters.lo, parameters.hi);
    met_pairs_.clear();
  }
  // The contacts at a place; not all of them if it is covered.
  Surroundings look(const PlacesOnLine& places, const RelativeLine& line, const Place& place);
  // A place that was looked at, as a sum of vertices if one is known to be there.
  struct Looked {
    std::optional<VertexSum> sum;
    Surroundings surroundings;
  };
  Looked look_anew(const PlacesOnLine& places, const Place& place);
  // The next pair of edges near what the search has approached, as the search has it.
  std::optional<WitnessSearch::Pair> next_pair(bool longest_first = false);
  [[nodiscard]] Containment contained_at(const PlacesOnLine& places, const RelativeLine& line,
                                         const Place& place) const;
  // What follows the place on s is covered if a pair of edges shows it: then a place beyond, up to
  // which that is so. Of pairs that were not met yet, the first one tells.
  std::optional<Place> exit_of_cover(const PlacesOnLine& places, const Place& place,
                                     const Containment& containment = {});
  // The same of a place that was not looked at.
  std::optional<Place> exit_near(const PlacesOnLine& places, const RelativeLine& line,
                                 const Place& place) {
    approach(line, place);
    return exit_of_cover(places, place);
  }
  // What follows the place on s is covered: a place beyond, up to which that is so; or nothing if s
  // ends first.
  std::optional<Place> leave_cover(const PlacesOnLine& places, const RelativeLine& line,
                                   const Place& place,
                                   const std::optional<Containment>& containment);
  // What follows the place on s is free, and its right side is covered. The next place where this
  // may end. If the right side is free, also the next one where that may end.
  Place next_change(const PlacesOnLine& places, const RelativeLine& line, const Place& place,
                    bool right_is_free = false);

  [[nodiscard]] double parameter_of(const RelativeLine& line, const Place& place) const;
  // Parameters that enclose that of a place on s.
  [[nodiscard]] Interval parameters_of(const RelativeLine& line, const Place& place) const;

  // Edges of which one slides along s with a vertex of the other on it, their solid sides on the
  // same side: covered from `from` to `to`.
  struct Slide {
    VertexSum from;
    VertexSum to;
  };
  // Where other rings touch the edge, each part of it slides for itself.
  template <class Visit>
  void for_each_slide(const PlacesOnLine& places, const WitnessSearch::Pair& pair, Visit visit);

  const Operands& operands_;
  const WindowBorder* border_;
  Index seen_;  // vertices of A from this one on are not seen
  const Touches& touches_a_;
  const Touches& touches_b_;
  Cones cones_;
  Tally& tally_;
  WitnessSearch search_;
  std::vector<WitnessSearch::Pair> met_pairs_;  // since a place was looked at
  // The last sums of vertices that took long to look at. Many superset edges meet there.
  static constexpr std::uint64_t many_visits = 256;
  static constexpr std::size_t most_looked = 8;
  std::deque<Looked> looked_;
  std::vector<Run> runs_;         // of an edge
  std::vector<Run> runs_across_;  // of others through a place on it
};

template <class Visitor>
void EdgeCover::walk(const PairEdge& s, const WalkedLines::Part& asked, Visitor& visitor) {
  const PlacesOnLine places(operands_, s, tally_);
  const RelativeLine line{operands_.relative_start(s), places.line().at.dx, places.line().at.dy};
  const bool has_points = border_ == nullptr || !border_->makes(s);
  const bool has_segments =
      has_points && (border_ == nullptr || !border_->holds(operands_, places));
  WindowBorder::Part part{Place::of(asked.from), Place::of(asked.to)};
  if (has_points && !has_segments) {
    visit_segments_along_border(places, part, visitor);
  }
  search_.begin(line);
  std::optional<Place> segment;  // where one has begun
  runs_.clear();
  if constexpr (Visitor::knows_rings) {
    visitor.known_runs(places, runs_);
    for (Run& run : runs_) {
      run.parameters = {parameters_of(line, run.from).lo, parameters_of(line, run.to).hi};
    }
  }
  if (border_ != nullptr) {
    part = border_->clipped(operands_, places, part);
    if (places.compare(part.from, part.to) > 0) {
      return;
    }
  }
  std::optional<Place> place = part.from;
  // Where another walk has ended, what follows is soon shown to be covered, as a rule.
  const bool was_walked_to = place->is_sum && !(place->sum == start_of(s));
  if (find_run(places, line, *place) == nullptr) {
    if (!was_walked_to) {
      place = skip(places, line, std::max(parameters_of(line, *place).lo, 0.0), *place);
    } else if (const std::optional<Place> exit = exit_near(places, line, *place)) {
      place = skip_between(places, line, *place, *exit);
    }
  }
  while (place) {
    if (const Run* const run = find_run(places, line, *place)) {
      if (segment) {
        visitor.segment(places, *segment, *place);
        segment.reset();
      }
      place = leave_ring(places, line, run->to);
      continue;
    }
    const int order = places.compare(*place, part.to);
    if (order > 0 && !segment) {
      return;
    }
    const bool is_end = order >= 0;
    if (lies_on_known_ring(places, *place, visitor)) {
      // What follows is soon shown to be covered, as a rule.
      const std::optional<Place> exit = is_end ? std::nullopt : exit_near(places, line, *place);
      if (segment && (is_end || exit)) {
        visitor.segment(places, *segment, *place);
        segment.reset();
      }
      if (is_end) {
        return;
      }
      if (exit) {
        place = skip_between(places, line, *place, *exit);
        continue;
      }
    }
    Surroundings surroundings = look(places, line, *place);
    std::optional<Containment> containment;  // where edges near the place do not cover it
    if (!surroundings.is_covered) {
      containment = contained_at(places, line, *place);
      surroundings.is_covered = containment->of_place;
    }
    const bool leads_on =
        !is_end && !surroundings.is_covered && !surroundings.blocked.holds(s.rank);
    const bool is_ring = leads_on && !surroundings.blocked.hold_right_of(s.rank);
    if (segment && !(leads_on && !is_ring)) {
      visitor.segment(places, *segment, *place);
      segment.reset();
    }
    // A segment may meet the window in its end alone: the border is in its way.
    if ((has_points && is_point(surroundings)) ||
        (has_segments && border_ != nullptr && !surroundings.is_covered &&
         surroundings.blocked_inside.leave_a_way_along(s.rank, surroundings.blocked))) {
      visitor.point(places, *place);
    }
    if (is_end) {
      return;
    }
    if (is_ring) {
      place = leave_ring(places, line, visitor.ring(places, *place));
    } else if (leads_on) {
      if (!segment && has_segments) {
        segment = place;
      }
      place = next_change(places, line, *place);
    } else {
      place = leave_cover(places, line, *place, containment);
    }
  }
}

template <class Visitor>
bool EdgeCover::lies_on_known_ring(const PlacesOnLine& places, const Place& place,
                                   Visitor& visitor) {
  if constexpr (Visitor::knows_rings) {
    if (border_ == nullptr) {
      const auto lies_on = [&](const PairEdge& edge) {
        if (places.is_parallel(edge)) {
          return false;
        }
        const PlacesOnLine others(operands_, edge, tally_);
        const Place here = place.is_sum ? place : others.crossing(places.line());
        runs_across_.clear();
        visitor.known_runs(others, runs_across_);
        return std::any_of(runs_across_.begin(), runs_across_.end(), [&](const Run& run) {
          return others.compare(run.from, here) <= 0 && others.compare(here, run.to) <= 0;
        });
      };
      if (!place.is_sum) {
        return lies_on(place.crossing);
      }
      const auto [i, j] = place.sum;
      return lies_on(operands_.translated(i, j)) || lies_on(operands_.corner(i, j)) ||
             lies_on(operands_.translated(operands_.a.previous(i), j)) ||
             lies_on(operands_.corner(i, operands_.b.previous(j)));
    }
  }
  return false;
}

}  // namespace gcv
