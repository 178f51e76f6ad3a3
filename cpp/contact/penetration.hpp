// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How B gets out of an overlap.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "boundary_trial.hpp"
#include "contact.hpp"
#include "exact_region.hpp"
#include "free_boundary.hpp"
#include "free_place.hpp"
#include "operands_in_range.hpp"
#include "usable_position.hpp"

namespace gcv {

struct Escape {
  double depth;       // correctly rounded; 0 if they do not overlap
  Point translation;  // the shortest way out, each coordinate correctly rounded
  UsablePosition place;
  Contact contact;  // that is there; none if they do not overlap
};

// What the ways out at all translations have in common. With holes left out there is the outer ring
// to go to. The whole boundary is found for convex polygons, where it takes a part of the time of
// the searches that are still to come, and in place of a search that takes long. It gives the same
// ways.
class WaysOut {
 public:
  // The polygons must live longer. `places`: how many translations there are, about.
  WaysOut(const Polygon& a, const Polygon& reflected_b, const WantedParts& wanted,
          std::size_t places, Task& task, Tally& tally);

  [[nodiscard]] const Operands& operands() const { return operands_; }
  [[nodiscard]] const OperandsInRange& in_range() const { return in_range_; }
  // What is searched, and where the boundary is that of: the operands in range.
  [[nodiscard]] const Operands& searched() const { return in_range_.operands(); }
  [[nodiscard]] const WantedParts& wanted() const { return wanted_; }
  [[nodiscard]] const std::vector<RingVertex>& outer_ring() const { return outer_ring_; }

  // A search has taken so many steps and visits.
  void add_search(std::uint64_t steps) const {
    steps_ += steps;
    ++searches_;
  }
  // Null where searches are quicker, as far as they have gone, or where it takes more than `steps`
  // as well, and while another thread finds it. Throws Error: cancelled, internal.
  [[nodiscard]] const FreeBoundary* boundary(Task& task, std::uint64_t steps = 0) const;

 private:
  [[nodiscard]] bool are_convex() const { return operands_.a.is_convex && operands_.b.is_convex; }
  [[nodiscard]] std::vector<RingVertex> walked_outer_ring(Task& task, Tally& tally) const;
  // How many steps the boundary may take: half of those that searches will take without it,
  // which take about twice as long.
  [[nodiscard]] std::uint64_t steps_to_spend() const;
  void find_boundary(Task& task) const;

  const Polygon& a_;
  const Polygon& reflected_b_;
  Operands operands_;
  OperandsInRange in_range_;
  WantedParts wanted_;
  std::vector<RingVertex> outer_ring_;  // without holes
  std::uint64_t places_;
  mutable std::atomic<std::uint64_t> steps_{0};
  mutable std::atomic<std::uint64_t> searches_{0};
  mutable BoundaryTrial trial_;
  mutable std::mutex mutex_;  // of who finds it
  mutable std::optional<FreeBoundary> boundary_;
  mutable std::atomic<const FreeBoundary*> found_{nullptr};  // once it is there
};

// The shortest translation to a place, each coordinate correctly rounded.
Point way_to(const FreePlace& place, const Point& from, Tally& tally);

// Its length, correctly rounded.
double depth_of(const Operands& operands, const FreePlace& place, const Point& from, Tally& tally);

// The contact in a free place: of the superset edges that hold it, the first by the owner of the
// edge or vertex of A, the kind, and the caller's numbers. `owners` has one for each ring of A, or
// none. No contact, but an owner, where none holds it.
struct OwnedContact {
  std::uint64_t owner = 0;
  Contact contact;
  std::optional<EdgePair> edges;  // those of the contact, or that begin at vertices of it
};
OwnedContact contact_in(const Operands& operands, FreePlaceSearch& search, const FreePlace& place,
                        std::span<const std::uint64_t> owners, Tally& tally);

// Finds ways out, one after the other. A translation lies in the open sum of A and the reflection
// of B just where they overlap there. So the way out leads to the nearest free place of that sum.
class EscapeSearch {
 public:
  EscapeSearch(const WaysOut& ways, Tally& tally)
      : ways_(ways), tally_(tally), search_(ways.searched(), ways.wanted(), tally) {}

  // Of several ways out, the lexicographically smallest one. Throws Error: cancelled, internal.
  Escape find(const PlacedPair& placed, Task& task);

 private:
  // The nearest free place. Throws Error: cancelled, internal.
  FreePlace nearest(const Point& from, Task& task);
  // The same of a point among the operands in range.
  std::optional<FreePlace> nearest_in_range(const Point& from, Task& task);

  const WaysOut& ways_;
  Tally& tally_;
  FreePlaceSearch search_;
};

}  // namespace gcv
