// SPDX-License-Identifier: LGPL-3.0-or-later
#include "minkowski_region.hpp"

#include <utility>

#include "exact_region.hpp"
#include "outer_face.hpp"
#include "region_rounding.hpp"

namespace gcv {

namespace {

Operand all_rings(const RegionOperand& operand) {
  return {{operand.polygon, &operand.polygon->boundary()}, operand.name, operand.error_bound};
}

}  // namespace

Region minkowski_sum_region(const RegionOperand& a, const RegionOperand& b, const Point& shift,
                            const RegionOptions& options, Task& task) {
  Region region;
  Tally& tally = region.counts.predicates;
  Walk walk = walk_outer_face(a.polygon->outer, b.polygon->outer, task, tally);
  ExactRegion& exact = region.exact;
  exact.a = all_rings(a);
  exact.b = all_rings(b);
  exact.shift = shift;
  const Operands operands{*exact.a.ring, *exact.b.ring,
                          merge_directions(*exact.a.ring, *exact.b.ring, tally)};
  find_sum_parts(operands, walk.vertices, {!options.leave_out_holes, !options.leave_out_fits}, task,
                 tally, exact);
  region.rounded = round_to_nearest(exact, true, task, tally);
  return region;
}

Region inner_fit_region(const RegionOperand& container, const RegionOperand& reflected,
                        const Point& shift, const RegionOptions& options, Task& task) {
  Region region;
  Tally& tally = region.counts.predicates;
  ExactRegion& exact = region.exact;
  exact.a = {std::make_shared<const Boundary>(container.polygon->boundary().complement()),
             container.name, container.error_bound};
  exact.b = all_rings(reflected);
  exact.shift = shift;
  const Operands operands{*exact.a.ring, *exact.b.ring,
                          merge_directions(*exact.a.ring, *exact.b.ring, tally)};
  exact.against_edges = true;
  find_free_parts(operands, {true, !options.leave_out_fits}, task, tally, exact);
  region.rounded = round_to_nearest(exact, false, task, tally);
  return region;
}

}  // namespace gcv
