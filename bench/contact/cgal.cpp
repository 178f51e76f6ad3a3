// SPDX-License-Identifier: LGPL-3.0-or-later
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "asker.hpp"

namespace gcv::bench {

namespace {

using Exact = CGAL::Epeck;
using Inexact = CGAL::Epick;
template <class Kernel>
using Polygon = CGAL::Polygon_2<Kernel>;

constexpr double most_vertex_pairs_of_all_edges = 1e6;
constexpr double most_vertex_pairs_of_arrangements = 1e5;

Polygon<Inexact> to_polygon(const Ring& ring) {
  Polygon<Inexact> polygon;
  for (const Point& p : ring) {
    polygon.push_back({p.x, p.y});
  }
  return polygon;
}

// Moved exactly.
Polygon<Exact> to_exact_polygon(const Ring& ring, const Point& translation) {
  Polygon<Exact> polygon;
  for (const Point& p : ring) {
    polygon.push_back({Exact::FT(p.x) + translation.x, Exact::FT(p.y) + translation.y});
  }
  return polygon;
}

bool lie_within(const Polygon<Inexact>& a, const Polygon<Inexact>& b) {
  return a.has_on_bounded_side(b[0]) || b.has_on_bounded_side(a[0]);
}

double apart_or_not(const Polygon<Inexact>& a, const Polygon<Inexact>& b) {
  if (!CGAL::do_overlap(a.bbox(), b.bbox())) {
    return 1;
  }
  for (auto p = a.edges_begin(); p != a.edges_end(); ++p) {
    for (auto q = b.edges_begin(); q != b.edges_end(); ++q) {
      if (CGAL::do_intersect(*p, *q)) {
        return 0;
      }
    }
  }
  return lie_within(a, b) ? 0 : 1;
}

double distance(const Polygon<Inexact>& a, const Polygon<Inexact>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (auto p = a.edges_begin(); p != a.edges_end(); ++p) {
    for (auto q = b.edges_begin(); q != b.edges_end(); ++q) {
      least = std::min(least, CGAL::squared_distance(*p, *q));
      if (least == 0) {
        return 0;
      }
    }
  }
  return lie_within(a, b) ? 0 : std::sqrt(least);
}

Asker all_edges(const char* name, Question question, Tells tells,
                double (*answer)(const Polygon<Inexact>&, const Polygon<Inexact>&)) {
  using All = std::pair<Polygon<Inexact>, std::vector<Polygon<Inexact>>>;
  return {.name = name,
          .question = question,
          .prepare =
              [answer](const Scene& s, const Placements& p) {
                const auto all =
                    std::make_shared<All>(to_polygon(s.a), moved_and_made(s, p, to_polygon));
                return [all, answer](std::size_t first, std::size_t count, double* out) {
                  for (std::size_t k = first; k < first + count; ++k) {
                    out[k] = answer(all->first, all->second[k]);
                  }
                };
              },
          .tells = tells,
          .is_given_rounded = true,
          .most_vertex_pairs = most_vertex_pairs_of_all_edges};
}

Asker overlap_by_arrangement() {
  using All = std::pair<Polygon<Exact>, std::vector<Polygon<Exact>>>;
  return {.name = "CGAL EPECK, do_intersect of polygons",
          .question = Question::relation,
          .prepare =
              [](const Scene& s, const Placements& p) {
                const auto all = std::make_shared<All>();
                all->first = to_exact_polygon(s.a, {0, 0});
                for (const Point& translation : p.translations) {
                  all->second.push_back(to_exact_polygon(s.b, translation));
                }
                return [all](std::size_t first, std::size_t count, double* out) {
                  for (std::size_t k = first; k < first + count; ++k) {
                    out[k] = CGAL::do_intersect(all->first, all->second[k]) ? -1 : 1;
                  }
                };
              },
          .tells = Tells::overlap_or_not,
          .most_vertex_pairs = most_vertex_pairs_of_arrangements};
}

}  // namespace

std::vector<Asker> cgal_askers() {
  return {all_edges("CGAL EPICK, do_intersect of all edges", Question::relation,
                    Tells::apart_or_not, apart_or_not),
          overlap_by_arrangement(),
          all_edges("CGAL EPICK, squared_distance of all edges", Question::distance,
                    Tells::all_three, distance)};
}

}  // namespace gcv::bench
