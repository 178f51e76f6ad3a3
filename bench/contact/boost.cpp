// SPDX-License-Identifier: LGPL-3.0-or-later
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <memory>

#include "asker.hpp"

namespace gcv::bench {

namespace {

namespace bg = boost::geometry;
// Counter-clockwise and open.
using Polygon = bg::model::polygon<bg::model::d2::point_xy<double>, false, false>;

Polygon to_polygon(const Ring& ring) {
  Polygon polygon;
  for (const Point& p : ring) {
    polygon.outer().emplace_back(p.x, p.y);
  }
  return polygon;
}

double relation(const Polygon& a, const Polygon& b) {
  if (!bg::intersects(a, b)) {
    return 1;
  }
  return bg::touches(a, b) ? 0 : -1;
}

double distance(const Polygon& a, const Polygon& b) { return bg::distance(a, b); }

Asker asker(const char* name, Question question, double (*answer)(const Polygon&, const Polygon&)) {
  return {.name = name,
          .question = question,
          .prepare =
              [answer](const Scene& s, const Placements& p) {
                const auto all = std::make_shared<std::pair<Polygon, std::vector<Polygon>>>(
                    to_polygon(s.a), moved_and_made(s, p, to_polygon));
                return [all, answer](std::size_t first, std::size_t count, double* out) {
                  for (std::size_t k = first; k < first + count; ++k) {
                    out[k] = answer(all->first, all->second[k]);
                  }
                };
              },
          .is_given_rounded = true};
}

}  // namespace

std::vector<Asker> boost_askers() {
  return {asker("Boost.Geometry, intersects and touches", Question::relation, relation),
          asker("Boost.Geometry distance", Question::distance, distance)};
}

}  // namespace gcv::bench
