// SPDX-License-Identifier: LGPL-3.0-or-later
#include "exact_region.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "choose.hpp"
#include "cover.hpp"
#include "exact_order.hpp"
#include "fits.hpp"
#include "free_rings.hpp"
#include "half_plane.hpp"
#include "known_runs.hpp"
#include "operands_in_range.hpp"
#include "search.hpp"
#include "tree_product.hpp"
#include "turns.hpp"
#include "walker.hpp"

namespace gcv {

namespace {

// Takes what covers leave.
class Finder {
 public:
  static constexpr bool knows_rings = true;

  Finder(const Operands& operands, Task& task, Tally& tally)
      : operands_(operands),
        task_(task),
        runs_(operands, slack_of(operands), tally),
        known_(operands, tally),
        fits_(operands, tally) {}

  // A ring that lives as long as this.
  void add_outer(const std::vector<RingVertex>& ring) {
    runs_.add(ring, task_);
    outer_ = &ring;
  }

  void known_runs(const PlacesOnLine& places, std::vector<EdgeCover::Run>& runs) {
    runs_.for_each(places.line().edge, [&](const KnownRuns::Run& run) {
      runs.push_back(
          {places.place(run.from, run.from.arriving()), places.place(run.to, run.to.leaving())});
    });
  }

  Place ring(const PlacesOnLine& places, const Place& from) {
    if (outer_ != nullptr) {
      add_known(*std::exchange(outer_, nullptr));
    }
    if (!walker_) {
      superset_.emplace(operands_);
      walker_.emplace(operands_, Search(*superset_), superset_->slack(), task_);
    }
    auto ring = walker_->ring(from, places.line().edge,
                              [&](const RingVertex& vertex) { return known_.has(vertex); });
    if (ring.walk) {
      steps_ += ring.walk->steps;
      candidates_ = ring.walk->candidates;  // of all rings so far
      add_known(ring.walk->vertices);
      runs_.add(ring.walk->vertices, task_);
      rings_.push_back(std::move(ring.walk->vertices));
    }
    return ring.leaves;
  }
  void segment(const PlacesOnLine& places, const Place& from, const Place& to) {
    fits_.add_segment(places.line().edge, vertex(places, from), vertex(places, to));
  }
  void point(const PlacesOnLine& places, const Place& place) {
    fits_.add_point(vertex(places, place));
  }

  // The rings found, with the free side on the right.
  std::vector<std::vector<RingVertex>>& rings() { return rings_; }
  Fits& fits() { return fits_; }
  [[nodiscard]] Tally tally() const { return walker_ ? walker_->tally() : Tally{}; }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] std::uint64_t candidates() const { return candidates_; }

 private:
  static RingVertex vertex(const PlacesOnLine& places, const Place& place) {
    const PairEdge& s = places.line().edge;
    return place.is_sum ? RingVertex::sum(place.sum.i, place.sum.j, s, s)
                        : RingVertex::crossing(s, place.crossing);
  }

  void add_known(const std::vector<RingVertex>& ring) {
    for (const RingVertex& vertex : ring) {
      known_.add(vertex);
    }
  }

  const Operands& operands_;
  Task& task_;
  KnownRuns runs_;
  const std::vector<RingVertex>* outer_ = nullptr;  // if its turns are not known yet
  KnownTurns known_;
  std::optional<SearchableSuperset> superset_;  // made for the first ring
  std::optional<Walker<Search>> walker_;
  Fits fits_;
  std::vector<std::vector<RingVertex>> rings_;
  std::uint64_t steps_ = 0;
  std::uint64_t candidates_ = 0;
};

void add_part(ExactRegion& region, PartKind kind, Index polygon,
              const std::vector<RingVertex>& vertices) {
  region.parts.push_back({kind, polygon, region.vertices.size(), vertices.size()});
  region.vertices.insert(region.vertices.end(), vertices.begin(), vertices.end());
}

// The same vertex, which the edge leaves. It lies on the line of the edge.
RingVertex left_by(const Operands& operands, const RingVertex& v, const EdgeName& edge) {
  if (v.is_sum()) {
    return RingVertex::sum(v.i(), v.j(), v.arriving(), edge);
  }
  const Directions& directions = operands.directions;
  const Rank angle = directions.angle(operands.named(v.arriving()).rank, operands.named(edge).rank);
  const bool are_parallel = angle == 0 || angle == directions.half_turn;
  return RingVertex::crossing(are_parallel ? v.leaving() : v.arriving(), edge);
}

void add_fits(const Operands& operands, Fits& fits, ExactRegion& region, bool in_window = false) {
  fits.finish(region.vertices);
  if (in_window) {
    fits.drop_points_on(region.vertices, region.parts);
  }
  for (const auto& [edge, ends] : fits.segments()) {
    add_part(region, PartKind::segment, RegionPart::no_polygon,
             {left_by(operands, ends[0].vertex, edge), ends[1].vertex});
  }
  for (const auto& point : fits.points()) {
    add_part(region, PartKind::point, RegionPart::no_polygon, {point.vertex});
  }
}

// Tells the task of a walk over pairs of edges in even steps, as many as were estimated. The steps
// along rings that were found on the way are among them.
class Progress {
 public:
  Progress(const Operands& operands, Task& task)
      : task_(task),
        steps_a_pair_(static_cast<double>(estimated_cover_steps(operands.a, operands.b)) /
                      (static_cast<double>(operands.a.size()) * operands.b.size())) {}

  // After a step of the search, when it had so many visits.
  void pass(std::uint64_t pairs, std::uint64_t visits, std::uint64_t steps_along_rings) {
    pairs_ += pairs;
    if (++searched_ + visits >= next_poll_) {
      task_.poll();
      next_poll_ = searched_ + visits + work_a_poll;
    }
    const auto target = static_cast<std::uint64_t>(static_cast<double>(pairs_) * steps_a_pair_);
    const std::uint64_t done = told_ + steps_along_rings;
    if (target >= done + Task::portion) {
      task_.advance(target - done);
      told_ += target - done;
    }
  }

 private:
  // Steps of the search and visits, each of which takes less than a microsecond.
  static constexpr std::uint64_t work_a_poll = 1U << 14;

  Task& task_;
  double steps_a_pair_;
  std::uint64_t searched_ = 0;
  std::uint64_t next_poll_ = work_a_poll;
  std::uint64_t pairs_ = 0;
  std::uint64_t told_ = 0;
};

// Asks all superset edges of half a plane of directions.
void walk_half_plane(const Operands& operands, EdgeCover& cover, Finder& finder, Task& task,
                     Counts& counts) {
  Progress progress(operands, task);
  const std::uint64_t edges = cover.walk_half_plane(
      cheapest_half_plane(operands), finder,
      [&](std::uint64_t pairs) { progress.pass(pairs, cover.search().visits(), finder.steps()); });
  counts.candidate_edges += edges + finder.candidates();
  counts.walk_steps += finder.steps();
  counts.predicates += finder.tally();
}

}  // namespace

std::uint64_t estimated_cover_steps(const Boundary& a, const Boundary& b) {
  return 16 * (std::uint64_t{a.size()} + b.size());
}

void add_outer_ring(std::vector<RingVertex> outer, ExactRegion& region) {
  region.parts.push_back({PartKind::outer, 0, 0, outer.size()});
  region.vertices = std::move(outer);
}

void find_sum_parts(const Operands& operands, const std::vector<RingVertex>& outer,
                    const WantedParts& wanted, Task& task, Counts& counts, ExactRegion& region) {
  Tally& tally = counts.predicates;
  add_outer_ring(outer, region);
  const bool has_more = wanted.holes || wanted.fits;
  if (!has_more || (operands.a.is_convex && operands.b.is_convex)) {
    return;
  }
  const OperandsInRange in_range(operands);
  const Operands& searched = in_range.operands();
  Finder finder(searched, task, tally);
  finder.add_outer(outer);
  EdgeCover cover(searched, tally);
  walk_half_plane(searched, cover, finder, task, counts);
  if (wanted.fits) {
    cover.visit_touches(finder, [](const VertexSum&) { return true; });
  }
  if (!wanted.holes) {
    finder.rings().clear();
  }
  const ExactOrder order(searched.a, searched.b, {0, 0}, tally);
  order.sort(finder.rings());
  for (const std::vector<RingVertex>& hole : finder.rings()) {
    add_part(region, PartKind::hole, 0, hole);
  }
  if (wanted.fits) {
    add_fits(searched, finder.fits(), region);
  }
}

void find_free_parts(const Operands& operands, const WindowBorder* border,
                     const WantedParts& wanted, Task& task, Counts& counts, ExactRegion& region) {
  const OperandsInRange in_range(operands);
  const Operands& searched = in_range.operands();
  Tally& tally = counts.predicates;
  Finder finder(searched, task, tally);
  EdgeCover cover(searched, tally, border);
  walk_half_plane(searched, cover, finder, task, counts);
  if (wanted.fits) {
    cover.visit_touches(finder, [](const VertexSum&) { return true; });
  }
  Index number = 0;
  for (const auto& [outer, holes] :
       free_polygons(searched, std::move(finder.rings()), !searched.a.solids.empty(), tally)) {
    add_part(region, PartKind::outer, number, outer);
    for (const std::vector<RingVertex>& hole : holes) {
      add_part(region, PartKind::hole, number, hole);
    }
    ++number;
  }
  if (wanted.fits) {
    add_fits(searched, finder.fits(), region, border != nullptr);
  }
}

void find_free_boundary(const Operands& operands, const WantedParts& wanted, Task& task,
                        Counts& counts, ExactRegion& region) {
  const OperandsInRange in_range(operands);
  const Operands& searched = in_range.operands();
  Finder finder(searched, task, counts.predicates);
  EdgeCover cover(searched, counts.predicates);
  walk_half_plane(searched, cover, finder, task, counts);
  for (const std::vector<RingVertex>& ring : finder.rings()) {
    add_part(region, PartKind::outer, 0, ring);
  }
  if (wanted.fits) {
    cover.visit_touches(finder, [](const VertexSum&) { return true; });
    add_fits(searched, finder.fits(), region);
  }
}

}  // namespace gcv
