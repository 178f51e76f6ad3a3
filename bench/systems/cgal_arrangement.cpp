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

// Every edge + every vertex that is convex and has the edge's direction in its closed cone.
std::vector<SupersetEdge> enumerate_reduced_convolution(const Operands& operands) {
  std::vector<SupersetEdge> edges;
  const auto sum = [&](Index i, Index j) {
    return SumPoint{operands.a.vertices[i], operands.b.vertices[j]};
  };
  for (Index i = 0; i < operands.a.size(); ++i) {
    for (Index j = 0; j < operands.b.size(); ++j) {
      if (operands.b_contributes(j, operands.directions.rank_a[i])) {
        edges.push_back({sum(i, j), sum(operands.a.next(i), j), {EdgeKind::translated, i, j}});
      }
      if (operands.a_contributes(i, operands.directions.rank_b[j])) {
        edges.push_back({sum(i, j), sum(i, operands.b.next(j)), {EdgeKind::corner, i, j}});
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
