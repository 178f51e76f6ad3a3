// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>

#include <algorithm>
#include <array>
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
  const gcv::Boundary& a = operands.a;
  const gcv::Boundary& b = operands.b;
  const Directions& directions = operands.directions;
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

std::vector<SupersetEdge> superset_of(const Ring& a, const Ring& b, Enumerate enumerate) {
  const gcv::Boundary p = make_ring(a, "a");
  const gcv::Boundary q = make_ring(b, "b");
  Tally tally;
  return enumerate({p, q, merge_directions(p, q, tally)});
}

Job arrangement_job(const Ring& a, const Ring& b, Enumerate enumerate) {
  auto boundary = std::make_shared<CgalPolygon>();
  return {[&a, &b, enumerate, boundary] {
            *boundary = unbounded_face(superset_of(a, b, enumerate));
            return to_doubles(*boundary);
          },
          [&a, &b, enumerate, boundary] {
            std::array<double, 5> seconds{};
            std::size_t edges = 0;
            for (double& time : seconds) {
              const auto start = Clock::now();
              edges = superset_of(a, b, enumerate).size();
              time = std::chrono::duration<double>(Clock::now() - start).count();
            }
            std::sort(seconds.begin(), seconds.end());
            return Observation{count_corners(*boundary), edges, seconds[seconds.size() / 2], 0};
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
