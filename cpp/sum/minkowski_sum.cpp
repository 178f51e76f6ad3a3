// SPDX-License-Identifier: LGPL-3.0-or-later
#include "minkowski_sum.hpp"

#include <cmath>
#include <utility>

#include "box.hpp"
#include "contributing_vertices.hpp"
#include "directions.hpp"
#include "edge_sources.hpp"
#include "error.hpp"
#include "outer_face.hpp"
#include "outward.hpp"
#include "units.hpp"

namespace gcv {

namespace {

Operand simplified_operand(const Operand& operand, const SumOptions& options) {
  Simplified near = simplified_for_sum(operand.ring, options);
  return {std::move(near.ring), operand.name, near.error_bound};
}

// The coordinate that is the sum of x of a and y of b.
double finite_sum(double x, double y) {
  const double sum = x + y;
  if (!std::isfinite(sum)) {
    throw Error(Status::range,
                "superset: the sum of %g of a and %g of b is beyond the largest double", x, y);
  }
  return sum + 0.0;
}

Point finite_sum(const SumPoint& point) {
  return {finite_sum(point.a.x, point.b.x), finite_sum(point.a.y, point.b.y)};
}

}  // namespace

// Where one is not finite, nor is a search in doubles of use: better to know before the walk.
void check_extremes(const Boundary& a, const char* name_a, const Boundary& b, const char* name_b) {
  const auto check = [&](const char* name, double x, double y) {
    if (!std::isfinite(x + y)) {
      throw Error(
          Status::range,
          "the %s coordinate of the outer face, the sum of %g of %s and %g of %s, is beyond "
          "the largest double",
          name, x, name_a, y, name_b);
    }
  };
  const Box& box_a = a.bounds;
  const Box& box_b = b.bounds;
  check("smallest x", box_a.x0, box_b.x0);
  check("largest x", box_a.x1, box_b.x1);
  check("smallest y", box_a.y0, box_b.y0);
  check("largest y", box_a.y1, box_b.y1);
}

std::uint64_t estimated_steps(const Boundary& a, const Boundary& b) {
  return 2 * (std::uint64_t{a.size()} + b.size());
}

std::uint64_t parts_of_sum(const Boundary& a, const Boundary& b) {
  return a.is_convex && b.is_convex ? 0 : estimated_steps(a, b);
}

std::size_t most_vertices_left(const Boundary& ring) { return 3 * ring.vertices.size() / 4; }

Simplified simplified_for_sum(const std::shared_ptr<const Boundary>& polygon,
                              const SumOptions& options) {
  return simplify(polygon, options.tolerance / 2, options.rounding, most_vertices_left(*polygon));
}

OuterFace minkowski_sum(Operand a, Operand b, const Point& shift, Rounding rounding, Task& task) {
  const Boundary& pa = *a.ring;
  const Boundary& pb = *b.ring;
  if (shift == Point{0, 0}) {
    check_extremes(pa, a.name, pb, b.name);
  }
  OuterFace face;
  Tally& tally = face.counts.predicates;
  Walk walk = walk_outer_face(pa, pb, task, tally);
  face.counts.walk_steps = walk.steps;
  face.counts.candidate_edges = walk.candidates;
  face.exact = {std::move(a), std::move(b), shift, std::move(walk.vertices),
                walk.chains_are_repeated};
  const auto outer_face_of = [&](const Boundary& p, const Boundary& q) {
    return walk_outer_face(p, q, task, tally).vertices;
  };
  face.rounded =
      rounding == Rounding::nearest
          ? round_to_nearest(face.exact, task, tally, parts_of_sum(pa, pb) / 2)
          : round_outward(face.exact, outer_face_of, task, tally, parts_of_sum(pa, pb) / 2);
  face.rounded.error_bound = sum_bound(
      face.rounded.error_bound, sum_bound(face.exact.a.error_bound, face.exact.b.error_bound));
  return face;
}

OuterFace minkowski_sum(const Operand& a, const Operand& b, const Point& shift,
                        const SumOptions& options, Task& task) {
  const std::uint64_t parts = parts_of_sum(*a.ring, *b.ring);
  task.begin(estimated_steps(*a.ring, *b.ring), parts);
  Operand near_a = simplified_operand(a, options);
  task.advance(0);
  Operand near_b = a.ring == b.ring ? Operand{near_a.ring, b.name, near_a.error_bound}
                                    : simplified_operand(b, options);
  task.advance(0, parts - parts_of_sum(*near_a.ring, *near_b.ring));
  OuterFace face =
      minkowski_sum(std::move(near_a), std::move(near_b), shift, options.rounding, task);
  task.finish();
  return face;
}

std::vector<SupersetEdge> superset(const Boundary& a, const Boundary& b) {
  Tally tally;
  const Operands operands{a, b, merge_directions(a, b, tally)};
  std::vector<SupersetEdge> edges = enumerate_superset(operands);
  for (SupersetEdge& edge : edges) {
    edge.source = in_callers_numbers(edge.source, a, b);
  }
  return edges;
}

std::vector<RoundedSupersetEdge> rounded_superset(const Boundary& a, const Boundary& b) {
  std::vector<RoundedSupersetEdge> rounded;
  for (const SupersetEdge& edge : superset(a, b)) {
    rounded.push_back({finite_sum(edge.from), finite_sum(edge.to), edge.source});
  }
  return rounded;
}

}  // namespace gcv
