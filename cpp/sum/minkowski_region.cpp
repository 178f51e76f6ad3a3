// SPDX-License-Identifier: LGPL-3.0-or-later
#include "minkowski_region.hpp"

#include <utility>

#include "box.hpp"
#include "directions.hpp"
#include "error.hpp"
#include "exact_region.hpp"
#include "outer_face.hpp"
#include "region_outward.hpp"
#include "region_rounding.hpp"
#include "units.hpp"

namespace gcv {

namespace {

std::shared_ptr<const Boundary> all_rings(const std::shared_ptr<const Polygon>& polygon) {
  return {polygon, &polygon->boundary()};
}

// The exact parts of a sum of these operands.
ExactRegion exact_sum(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                      const WantedParts& wanted, Task& task, Counts& counts) {
  Tally& tally = counts.predicates;
  Walk walk = walk_outer_face(a.polygon->outer, b.polygon->outer, task, tally);
  counts.walk_steps += walk.steps;
  counts.candidate_edges += walk.candidates;
  ExactRegion exact;
  exact.a = {all_rings(a.polygon), a.name, a.error_bound};
  exact.b = {all_rings(b.polygon), b.name, b.error_bound};
  exact.shift = shift;
  exact.chains_are_repeated = walk.chains_are_repeated;
  if (!wanted.holes && !wanted.fits) {
    add_outer_ring(std::move(walk.vertices), exact);
    return exact;
  }
  const Operands operands{*exact.a.ring, *exact.b.ring,
                          merge_directions(*exact.a.ring, *exact.b.ring, tally)};
  find_sum_parts(operands, walk.vertices, wanted, task, counts, exact);
  return exact;
}

// Where a polygon overlaps none of the solids.
ExactRegion exact_free_set(const Operand& solids, const WindowBorder* border,
                           const RegionOperand& reflected, const Point& shift,
                           const WantedParts& wanted, Task& task, Counts& counts) {
  ExactRegion exact;
  exact.a = solids;
  exact.b = {all_rings(reflected.polygon), reflected.name, reflected.error_bound};
  exact.shift = shift;
  exact.against_edges = true;
  Operands operands{*exact.a.ring, *exact.b.ring,
                    merge_directions(*exact.a.ring, *exact.b.ring, counts.predicates)};
  if (border != nullptr) {
    operands.focus = border->focus(operands);
  }
  find_free_parts(operands, border, wanted, task, counts, exact);
  return exact;
}

// The outside of a container.
Operand outside_of(const RegionOperand& container) {
  return {std::make_shared<const Boundary>(container.polygon->boundary().complement()),
          container.name, container.error_bound};
}

}  // namespace

RegionOperand simplified_for_sum(const RegionOperand& operand, const SumOptions& options) {
  if (operand.polygon->holes.empty()) {
    const std::shared_ptr<const Boundary> ring = outer_ring(operand.polygon);
    const Simplified near = simplified_for_sum(ring, options);
    return near.ring == ring ? operand
                             : RegionOperand{std::make_shared<const Polygon>(*near.ring),
                                             operand.name, near.error_bound};
  }
  if (options.tolerance == 0) {
    return operand;
  }
  const SimplifiedPolygon near = simplify(operand.polygon, options.tolerance / 2, options.rounding,
                                          most_vertices_left(operand.polygon->outer));
  return {near.polygon, operand.name, near.error_bound};
}

std::uint64_t estimated_steps(const Polygon& a, const Polygon& b, const RegionOptions& options) {
  const std::uint64_t steps = estimated_steps(a.outer, b.outer);
  return options.leave_out_holes && options.leave_out_fits
             ? steps
             : steps + estimated_cover_steps(a.boundary(), b.boundary());
}

Region sum_region(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                  const RegionOptions& options, Task& task) {
  if (shift == Point{0, 0}) {
    check_extremes(a.polygon->outer, a.name, b.polygon->outer, b.name);
  }
  Region region;
  Tally& tally = region.counts.predicates;
  const WantedParts wanted{!options.leave_out_holes, !options.leave_out_fits};
  region.exact = exact_sum(a, b, shift, wanted, task, region.counts);
  if (options.rounding == Rounding::nearest) {
    region.rounded = round_to_nearest(region.exact, true, task, tally);
  } else {
    const auto outer_face_of = [&](const Boundary& p, const Boundary& q) {
      return walk_outer_face(p, q, task, tally).vertices;
    };
    const auto sum_with = [&](const std::shared_ptr<const Polygon>& polygon,
                              const std::shared_ptr<const Polygon>& square) {
      Counts counts;
      return exact_sum({polygon, "the rounded region"}, {square, "the square"}, {0, 0},
                       {true, false}, task, counts);
    };
    region.rounded = round_region_outward(region.exact, outer_face_of, sum_with, task, tally);
  }
  region.rounded.error_bound =
      sum_bound(region.rounded.error_bound, sum_bound(a.error_bound, b.error_bound));
  return region;
}

Region minkowski_sum_region(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                            const RegionOptions& options, Task& task) {
  task.begin(estimated_steps(*a.polygon, *b.polygon, options));
  Region region = options.tolerance == 0
                      ? sum_region(a, b, shift, options, task)
                      : sum_region(simplified_for_sum(a, options), simplified_for_sum(b, options),
                                   shift, options, task);
  task.finish();
  return region;
}

Region free_region(const Operand& solids, const WindowBorder* border,
                   const RegionOperand& reflected, const Point& shift, const RegionOptions& options,
                   Task& task) {
  task.begin(estimated_cover_steps(*solids.ring, reflected.polygon->boundary()));
  Region region;
  Tally& tally = region.counts.predicates;
  region.exact = exact_free_set(solids, border, reflected, shift, {true, !options.leave_out_fits},
                                task, region.counts);
  if (options.rounding == Rounding::nearest) {
    region.rounded = round_to_nearest(region.exact, false, task, tally);
  } else {
    const auto fits_of = [&](const std::shared_ptr<const Polygon>& polygon,
                             const std::shared_ptr<const Polygon>& square) {
      Counts counts;
      return exact_free_set(outside_of({polygon, "the rounded region"}), nullptr,
                            {square, "the square"}, {0, 0}, {true, false}, task, counts);
    };
    region.rounded = round_region_inward(region.exact, fits_of, task, tally);
  }
  task.finish();
  return region;
}

Region inner_fit_region(const RegionOperand& container, const RegionOperand& reflected,
                        const Point& shift, const RegionOptions& options, Task& task) {
  return free_region(outside_of(container), nullptr, reflected, shift, options, task);
}

}  // namespace gcv
