// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The free place of a sum that is nearest to a point, or furthest in a direction, found without the
// sum. A place is free where the open sum does not cover it. The nearest one lies on a superset
// edge. A best-first search by distances in doubles finds it. What these do not tell apart is
// compared exactly.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "best_free.hpp"
#include "cover.hpp"
#include "exact_point.hpp"
#include "exact_region.hpp"
#include "exact_ring.hpp"
#include "free_boundary.hpp"
#include "nearest_edges.hpp"
#include "task.hpp"
#include "walked_lines.hpp"

namespace gcv {

class FreePlaceSearch {
 public:
  // The operands must live longer. O(n + m).
  FreePlaceSearch(const Operands& operands, const WantedParts& wanted, Tally& tally);

  // Each step of a search counts as `step` steps of the task.
  //
  // The nearest one to a point, of several the lexicographically smallest. Nothing if there is
  // none, or none within that distance. Without holes, it is on this ring or a fit. Nothing, too,
  // where that takes more than `most_steps`. Throws Error: cancelled, internal.
  std::optional<FreePlace> nearest(const Point& from, double most,
                                   const std::vector<RingVertex>& outer_ring, Task& task,
                                   std::uint64_t step, std::uint64_t most_steps = no_limit);
  // The same, where the boundary is known: with holes and fits if these are wanted.
  std::optional<FreePlace> nearest(const Point& from, const FreeBoundary& boundary);
  // Fits that are not wanted are passed over, and corners too, if it is for these.
  struct Wish {
    std::function<bool(const FreePlace&)> is_wanted;
    bool is_for_corners;
  };
  // The furthest one in a direction, of several the lexicographically smallest, of those that are
  // wanted. The free set must be bounded in it. None before `first` is free, if that is given: what
  // lies there is left out, also where the operands do not cover it. Throws Error: cancelled,
  // internal.
  std::optional<FreePlace> furthest(const Point& direction, const Wish& wish, Task& task,
                                    std::uint64_t step,
                                    const std::optional<ExactPoint>& first = std::nullopt);

  static constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();
  // How many edges and pairs of nodes the last search for a nearest place looked at, and how many
  // visits it took to find witnesses.
  [[nodiscard]] std::uint64_t last_steps() const { return last_steps_; }

  // Vectors into the middles of the directions in which all is free next to a furthest place.
  std::vector<Point> ways_off(const FreePlace& place) {
    return cover_.ways_off(place.edge, *place.place);
  }
  // Calls visit(i, j) for the pairs of edges whose sums may hold the place.
  template <class Visit>
  void for_each_pair_near(const FreePlace& place, Visit visit) {
    for (const auto& [i, j] : pairs_near(place)) {
      visit(i, j);
    }
  }

 private:
  std::vector<WitnessSearch::Pair> pairs_near(const FreePlace& place);
  // Walks what no other edge has walked.
  template <class Visitor>
  void walk(const PairEdge& s, Visitor& visitor) {
    for (const WalkedLines::Part& part : walked_.left_of(s)) {
      cover_.walk(s, part, visitor);
    }
  }

  const Operands& operands_;
  WantedParts wanted_;
  Tally& tally_;
  EdgeCover cover_;
  NearestEdges nearest_edges_;
  std::uint64_t last_steps_ = 0;
  WalkedLines walked_;  // what superset edges have there within reach is found
};

}  // namespace gcv
