// SPDX-License-Identifier: LGPL-3.0-or-later
#include "minkowski_sum.hpp"

#include <cmath>
#include <utility>

#include "contributing_vertices.hpp"
#include "directions.hpp"
#include "edge_sources.hpp"
#include "error.hpp"
#include "outer_face.hpp"
#include "outward.hpp"

namespace gcv {

namespace {

// The extreme coordinates of the sum are those of vertices of its outer face. Where one is
// not finite, nor is a search in doubles of use: better to know before the walk.
void check_extremes(const Operand& a, const Operand& b) {
  const auto check = [&](const char* name, double x, double y) {
    if (!std::isfinite(x + y)) {
      throw Error(
          Status::range,
          "the %s coordinate of the outer face, the sum of %g of %s and %g of %s, is beyond "
          "the largest double",
          name, x, a.name, y, b.name);
    }
  };
  const Box& box_a = a.polygon->bounds;
  const Box& box_b = b.polygon->bounds;
  check("smallest x", box_a.x0, box_b.x0);
  check("largest x", box_a.x1, box_b.x1);
  check("smallest y", box_a.y0, box_b.y0);
  check("largest y", box_a.y1, box_b.y1);
}

}  // namespace

OuterFace minkowski_sum(const Operand& a, const Operand& b, const Point& shift, Rounding rounding,
                        Task& task) {
  const Polygon& pa = *a.polygon;
  const Polygon& pb = *b.polygon;
  if (shift == Point{0, 0}) {
    check_extremes(a, b);
  }
  OuterFace face;
  Tally& tally = face.counts.predicates;
  Walk walk = walk_outer_face(pa, pb, task, tally);
  face.counts.walk_steps = walk.steps;
  face.counts.candidate_edges = walk.candidates;
  face.exact = {a, b, shift, std::move(walk.vertices), walk.chains_are_repeated};
  face.rounded = rounding == Rounding::nearest ? round_to_nearest(face.exact, task, tally)
                                               : round_outward(face.exact, task, tally);
  face.rounded.error_bound =
      sum_bound(face.rounded.error_bound, sum_bound(a.error_bound, b.error_bound));
  return face;
}

std::vector<SupersetEdge> superset(const Polygon& a, const Polygon& b) {
  Tally tally;
  const Operands operands{a, b, merge_directions(a, b, tally)};
  std::vector<SupersetEdge> edges = enumerate_superset(operands);
  for (SupersetEdge& edge : edges) {
    edge.source = in_callers_numbers(edge.source, a, b);
  }
  return edges;
}

}  // namespace gcv
