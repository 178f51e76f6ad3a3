// SPDX-License-Identifier: LGPL-3.0-or-later
#include "ring_conflicts.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <tuple>

#include "box.hpp"
#include "cycle.hpp"
#include "overlapping_pairs.hpp"
#include "predicates.hpp"
#include "simplicity.hpp"
#include "task.hpp"

namespace gcv {

namespace {

// All edges of rings, one ring after the other.
struct AllEdges {
  std::vector<RingEdge> edges;
  std::vector<Box> boxes;

  AllEdges(std::span<const PointVector> rings, double margin) {
    Pace pace;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      pace.step(2 * std::uint64_t{rings[r].size()});
      for (std::size_t i = 0; i < rings[r].size(); ++i) {
        edges.push_back({r, i});
        boxes.push_back(
            widened(box_of(rings[r][i], rings[r][cyclic_next(i, rings[r].size())]), margin));
      }
    }
  }
};

// How a ring passes through a point of one of its edges.
struct Passage {
  Point from;
  Point place;
  Point to;
};

Passage passage(const PointVector& ring, std::size_t edge, const Point& place) {
  const std::size_t n = ring.size();
  const std::size_t next = cyclic_next(edge, n);
  if (place == ring[edge]) {
    return {ring[cyclic_previous(edge, n)], place, ring[next]};
  }
  if (place == ring[next]) {
    return {ring[edge], place, ring[cyclic_next(next, n)]};
  }
  return {ring[edge], place, ring[next]};
}

// The side of a passage on which the way from its place to q begins: 1 left, -1 right, 0 along it.
int side_of_way(const Passage& passage, const Point& q, Tally& tally) {
  const Point& from = passage.from;
  const Point& place = passage.place;
  const Point& to = passage.to;
  const int turn = orientation(from, place, to, tally);
  const int of_in = orientation(from, place, q, tally);
  const int of_out = orientation(place, to, q, tally);
  const auto is_along = [&](const Point& p) {
    return orientation(place, p, q, tally) == 0 &&
           (lexicographically_less(place, p) == lexicographically_less(place, q));
  };
  if (is_along(from) || is_along(to)) {
    return 0;
  }
  if (turn == 0) {
    return of_out;
  }
  const bool is_left = turn > 0 ? of_in > 0 && of_out > 0 : of_in > 0 || of_out > 0;
  return is_left ? 1 : -1;
}

bool is_conflict(std::span<const PointVector> rings, const RingEdge& e, const RingEdge& f,
                 Tally& tally) {
  const PointVector& ring_e = rings[e.ring];
  const PointVector& ring_f = rings[f.ring];
  const Point& p0 = ring_e[e.edge];
  const Point& p1 = ring_e[cyclic_next(e.edge, ring_e.size())];
  const Point& q0 = ring_f[f.edge];
  const Point& q1 = ring_f[cyclic_next(f.edge, ring_f.size())];
  const int side_q0 = orientation(p0, p1, q0, tally);
  const int side_q1 = orientation(p0, p1, q1, tally);
  if (side_q0 * side_q1 > 0) {
    return false;
  }
  const int side_p0 = orientation(q0, q1, p0, tally);
  const int side_p1 = orientation(q0, q1, p1, tally);
  if (side_p0 * side_p1 > 0) {
    return false;
  }
  if (side_q0 * side_q1 < 0 && side_p0 * side_p1 < 0) {
    return true;
  }
  const Box box_e = box_of(p0, p1);
  const Box box_f = box_of(q0, q1);
  const auto crosses_at = [&](const Point& place) {
    const Box at = box_of(place, place);
    if (are_apart(box_e, at) || are_apart(box_f, at)) {
      return false;
    }
    const Passage of_e = passage(ring_e, e.edge, place);
    const Passage of_f = passage(ring_f, f.edge, place);
    return side_of_way(of_e, of_f.from, tally) * side_of_way(of_e, of_f.to, tally) <= 0;
  };
  return (side_q0 == 0 && crosses_at(q0)) || (side_q1 == 0 && crosses_at(q1)) ||
         (side_p0 == 0 && crosses_at(p0)) || (side_p1 == 0 && crosses_at(p1));
}

}  // namespace

std::vector<RingConflict> find_ring_conflicts(std::span<const PointVector> rings) {
  std::vector<RingConflict> conflicts;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    if (rings[r].size() >= 3 && find_conflict(rings[r], box_of(rings[r]))) {
      for (const Conflict& conflict : find_all_conflicts(rings[r])) {
        conflicts.push_back({{r, conflict.first}, {r, conflict.second}});
      }
    }
  }
  if (rings.size() <= 1) {
    return conflicts;
  }
  const AllEdges all(rings, 0);
  Tally tally;
  OverlappingPairs(all.boxes).visit_all([&](std::size_t i, std::size_t j) {
    const RingEdge& e = all.edges[std::min(i, j)];
    const RingEdge& f = all.edges[std::max(i, j)];
    if (e.ring != f.ring && is_conflict(rings, e, f, tally)) {
      conflicts.push_back({e, f});
    }
  });
  const auto key = [](const RingConflict& conflict) {
    const auto& [e, f] = conflict;
    return std::tie(e.ring, f.ring, e.edge, f.edge);
  };
  std::sort(conflicts.begin(), conflicts.end(),
            [&](const RingConflict& p, const RingConflict& q) { return key(p) < key(q); });
  return conflicts;
}

bool are_rings_near(std::span<const PointVector> rings, double distance) {
  if (rings.size() <= 1) {
    return false;
  }
  const AllEdges all(rings, distance);
  return !OverlappingPairs(all.boxes).visit_some(
      std::numeric_limits<std::uint64_t>::max(), [&](std::size_t i, std::size_t j) {
        return all.edges[i].ring == all.edges[j].ring || are_apart(all.boxes[i], all.boxes[j]);
      });
}

}  // namespace gcv
