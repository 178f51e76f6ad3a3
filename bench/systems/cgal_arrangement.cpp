// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <stdexcept>

#include "cgal.hpp"
#include "superset.hpp"

namespace gcv::bench {

namespace {

using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Clock = std::chrono::steady_clock;

Kernel::Point_2 exact_point(const SumPoint& p) {
  return {Kernel::FT(p.a.x) + Kernel::FT(p.b.x), Kernel::FT(p.a.y) + Kernel::FT(p.b.y)};
}

CgalPolygon unbounded_face(const std::vector<SupersetEdge>& superset) {
  std::vector<Traits::X_monotone_curve_2> segments;
  segments.reserve(superset.size());
  for (const SupersetEdge& edge : superset) {
    segments.emplace_back(exact_point(edge.from), exact_point(edge.to));
  }
  Arrangement arrangement;
  CGAL::insert(arrangement, segments.begin(), segments.end());
  const auto face = arrangement.unbounded_face();
  if (std::distance(face->inner_ccbs_begin(), face->inner_ccbs_end()) != 1) {
    throw std::runtime_error("not one ring");
  }
  CgalPolygon boundary;
  const auto first = *face->inner_ccbs_begin();
  auto edge = first;
  do {
    boundary.push_back(edge->target()->point());
  } while (++edge != first);
  boundary.reverse_orientation();  // the unbounded face has it clockwise
  return boundary;
}

// Every edge + every vertex that is convex and has the edge's direction in its cone. Of two
// edges of equal direction, that of B is taken first and then that of A, as in one pass
// round the convolution: so one side of each cone is open.
std::vector<SupersetEdge> enumerate_reduced_convolution(const Operands& operands) {
  const auto& [a, b, directions] = operands;
  std::vector<SupersetEdge> edges;
  for (Index i = 0; i < a.size(); ++i) {
    for (Index j = 0; j < b.size(); ++j) {
      const Rank of_a = directions.rank_a[i];
      const Rank of_b = directions.rank_b[j];
      const SumPoint start{a.vertices[i], b.vertices[j]};
      if (operands.b_contributes(j, of_a) && of_a != of_b) {
        const SumPoint end{a.vertices[a.next(i)], b.vertices[j]};
        edges.push_back({start, end, {EdgeKind::translated, i, j}});
      }
      if (operands.a_contributes(i, of_b) && of_b != directions.rank_a[a.previous(i)]) {
        const SumPoint end{a.vertices[i], b.vertices[b.next(j)]};
        edges.push_back({start, end, {EdgeKind::corner, i, j}});
      }
    }
  }
  return edges;
}

using Enumerate = std::vector<SupersetEdge> (*)(const Operands&);

Job arrangement_job(const Ring& a, const Ring& b, Enumerate enumerate) {
  struct State {
    Observation observation;
    CgalPolygon boundary;
  };
  auto state = std::make_shared<State>();
  return {
      [&a, &b, enumerate, state] {
        const auto start = Clock::now();
        const Polygon p = make_polygon(a, "a");
        const Polygon q = make_polygon(b, "b");
        Tally tally;
        const std::vector<SupersetEdge> superset = enumerate({p, q, merge_directions(p, q, tally)});
        const std::chrono::duration<double> elapsed = Clock::now() - start;
        state->observation = {0, superset.size(), elapsed.count()};
        state->boundary = unbounded_face(superset);
        return to_doubles(state->boundary);
      },
      [state] {
        Observation observation = state->observation;
        observation.exact_vertices = count_corners(state->boundary);
        return observation;
      }};
}

}  // namespace

Job gcv_arrangement(const Ring& a, const Ring& b) {
  return arrangement_job(a, b, enumerate_superset);
}

Job reduced_convolution_arrangement(const Ring& a, const Ring& b) {
  return arrangement_job(a, b, enumerate_reduced_convolution);
}

}  // namespace gcv::bench
